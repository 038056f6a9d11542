#include "files/scenario/describe_world.h"

#include "base/text_file.h"
#include "muster/scenario.h"

namespace muster {
namespace {

constexpr std::size_t kMaxMapSide = 4096;
constexpr const char* kAbout = "A MovingAI map as ground: a file beside the scenario, or its rows.";

/// The map's text, from the file or from the rows.
std::string mapText(FieldReader& v, const std::string& file, const Json* rows, const std::string& folder) {
    if (rows == nullptr) {
        if (folder.empty()) {
            v.fail("file", "a file name", "embedded rows, since files are not read here");
            return {};
        }
        const std::string separator = folder.back() == '/' ? "" : "/";
        const auto text = readTextFile(file.front() == '/' ? file : folder + separator + file);
        if (!text.ok()) v.fail("file", text.status().message(), "a MovingAI map");
        return text.ok() ? *text : std::string();
    }
    const std::size_t width = !rows->empty() && (*rows)[0].isText() ? (*rows)[0].text().size() : 0;
    std::string text = "type octile\nheight " + std::to_string(rows->size()) + "\nwidth " +
                       std::to_string(width) + "\nmap\n";
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const Json& row = (*rows)[i];
        if (!row.isText() || row.text().size() != width || width > kMaxMapSide) {
            v.fail("rows[" + std::to_string(i) + "]", describeJson(row),
                   "a text of " + std::to_string(width) + " cells, as the first row, at most 4096");
            return {};
        }
        text += row.text() + "\n";
    }
    return text;
}

void readMap(FieldReader& v, MapGround& map, const std::string& folder) {
    std::string file;
    v.text("file", file, "");
    const Json* rows = v.findArray("rows", kMaxMapSide, Need::Optional);
    describe(v, map.def);
    if (v.failed()) return;
    if (file.empty() == (rows == nullptr)) {
        return v.fail({}, file.empty() ? "neither file nor rows" : "both file and rows", "one of them");
    }
    const std::string text = mapText(v, file, rows, folder);
    if (v.failed()) return;
    auto grid = parseMap(text);
    if (!grid.ok())
        return v.fail(rows != nullptr ? "rows" : "file", grid.status().message(), "a MovingAI map");
    map.grid = std::move(grid).value();
}

}  // namespace

Box mapBox(const MapGround& map) {
    const Vec2 size{map.grid.width * map.def.metresPerCell, map.grid.height * map.def.metresPerCell};
    return {map.def.origin, map.def.origin + size};
}

bool describeMap(FieldReader& v, std::optional<MapGround>& map, const std::string& folder) {
    const bool found = v.object("map", kAbout,
                                [&](FieldReader& inner) { readMap(inner, map.emplace(), folder); });
    return found && !v.failed();
}

bool describeMap(FieldWriter& v, std::optional<MapGround>& map, const std::string&) {
    if (!map) return false;
    v.object("map", kAbout, [&](FieldWriter& inner) {
        describe(inner, map->def);
        Json rows = Json::array();
        const auto width = static_cast<std::size_t>(map->grid.width);
        for (std::int32_t row = 0; row < map->grid.height; ++row) {
            rows.push(map->grid.cells.substr(static_cast<std::size_t>(row) * width, width));
        }
        inner.set("rows", std::move(rows));
    });
    return false;  // The box is written as well.
}

bool describeMap(FieldSchema& v, std::optional<MapGround>&, const std::string&) {
    return v.object("map", kAbout, [&](FieldSchema& inner) {
        MapDef def;
        inner.text("file", "", "MovingAI map file, relative to the scenario.");
        inner.set("rows", {{"type", "array"}, {"maxItems", kMaxMapSide}, {"items", {{"type", "string"}}}},
                  "The map's rows from the top, instead of a file.", Need::Optional);
        describe(inner, def);
    });
}

}  // namespace muster
