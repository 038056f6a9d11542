#include "muster/ground.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "engine/ground/environment/rectangle_partition.h"

namespace muster {
namespace {

constexpr std::string_view kBlocked = "@OTW";
constexpr std::string_view kOpen = ".G";
constexpr char kSwamp = 'S';
constexpr std::int32_t kLongestSide = 4096;

Status parseError(std::int32_t line, const std::string& message) {
    return {StatusCode::ParseError, "line " + std::to_string(line) + ": " + message};
}

// Hands out lines without their ends; knows the number of the last one.
class Lines {
public:
    explicit Lines(std::string_view text) : rest_(text) {}
    bool next(std::string_view& line) {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        line = rest_.substr(0, end);
        rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        ++number_;
        return true;
    }
    std::int32_t number() const { return number_; }

private:
    std::string_view rest_;
    std::int32_t number_ = 0;
};

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    return text;
}

// A whole number from 1 to kLongestSide, or 0.
std::int32_t sideLength(std::string_view text) {
    if (text.empty() || text.size() > 4) return 0;
    std::int32_t value = 0;
    for (char c : text) {
        if (c < '0' || c > '9') return 0;
        value = value * 10 + (c - '0');
    }
    return value <= kLongestSide ? value : 0;
}

// One line of the header: `type`, `height`, `width` in any order, then `map`, which ends it.
Status readHeaderLine(std::string_view line, std::int32_t number, MapGrid& map, bool& typed, bool& done) {
    line = trimmed(line);
    const std::size_t space = line.find_first_of(" \t");
    const std::string_view key = line.substr(0, space);
    const std::string_view value = space == std::string_view::npos ? std::string_view()
                                                                   : trimmed(line.substr(space));
    if (key == "type") {
        if (value != "octile")
            return parseError(
                number, "expected `type octile`, found type `" + std::string(value.substr(0, 40)) + "`");
        typed = true;
    } else if (key == "height" || key == "width") {
        const std::int32_t side = sideLength(value);
        if (side == 0)
            return parseError(number, "expected " + std::string(key) + " from 1 to 4096, found `" +
                                          std::string(value.substr(0, 40)) + "`");
        (key == "height" ? map.height : map.width) = side;
    } else if (key == "map" && value.empty()) {
        if (!typed) return parseError(number, "the header gives no type before `map`");
        if (map.height == 0) return parseError(number, "the header gives no height before `map`");
        if (map.width == 0) return parseError(number, "the header gives no width before `map`");
        done = true;
    } else {
        return parseError(
            number, "expected type, height, width or map, found `" + std::string(line.substr(0, 40)) + "`");
    }
    return {};
}

Status readRow(std::string_view line, std::int32_t number, MapGrid& map) {
    if (std::cmp_not_equal(line.size(), map.width)) {
        return parseError(number, "expected a row of " + std::to_string(map.width) + " cells, found " +
                                      std::to_string(line.size()));
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (kBlocked.find(c) != std::string_view::npos || kOpen.find(c) != std::string_view::npos ||
            c == kSwamp)
            continue;
        return parseError(
            number, "unknown cell in column " + std::to_string(i + 1) + ": expected one of . G S @ O T W");
    }
    map.cells.append(line);
    return {};
}

// Rectangles of cells whose characters are in `kinds`, rows counted from the top.
std::vector<CellBlock> coverOf(const MapGrid& map, std::string_view kinds) {
    std::vector<char> wanted(map.cells.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        wanted[i] = kinds.find(map.cells[i]) != std::string_view::npos;
    return partitionIntoRectangles(wanted, map.width, map.height);
}

// All coordinates are computed from whole cell numbers, so rectangles that touch share them bit for bit.
Polygon outlineOf(const CellBlock& block, const MapGrid& map, const MapDef& def) {
    const auto x = [&](std::int32_t column) { return def.origin.x + column * def.metresPerCell; };
    const auto y = [&](std::int32_t row) { return def.origin.y + (map.height - row) * def.metresPerCell; };
    return {{x(block.left), y(block.bottom)},
            {x(block.right), y(block.bottom)},
            {x(block.right), y(block.top)},
            {x(block.left), y(block.top)}};
}

}  // namespace

Result<MapGrid> parseMap(const std::string& text) {
    MapGrid map;
    Lines lines(text);
    std::string_view line;
    bool typed = false;
    for (bool done = false; !done;) {
        if (!lines.next(line)) return parseError(lines.number() + 1, "the file ends before `map`");
        if (Status status = readHeaderLine(line, lines.number(), map, typed, done); !status.ok())
            return status;
    }
    for (std::int32_t row = 0; row < map.height; ++row) {
        if (!lines.next(line)) {
            return parseError(lines.number() + 1, "expected " + std::to_string(map.height) + " rows, found " +
                                                      std::to_string(row));
        }
        if (Status status = readRow(line, lines.number(), map); !status.ok()) return status;
    }
    while (lines.next(line)) {
        if (!trimmed(line).empty())
            return parseError(lines.number(), "more rows than the height of " + std::to_string(map.height));
    }
    return map;
}

std::vector<ObstacleDef> mapObstacles(const MapGrid& map, const MapDef& def) {
    std::vector<ObstacleDef> obstacles;
    for (const CellBlock& block : coverOf(map, kBlocked)) {
        obstacles.emplace_back().polygon = outlineOf(block, map, def);
    }
    return obstacles;
}

std::vector<PatchDef> mapPatches(const MapGrid& map, const MapDef& def, MotionId motion) {
    std::vector<PatchDef> patches;
    for (const CellBlock& block : coverOf(map, std::string_view(&kSwamp, 1))) {
        PatchDef& patch = patches.emplace_back();
        patch.name = "Swamp";
        patch.polygon = outlineOf(block, map, def);
        patch.motion = motion;
        patch.speed = def.swampSpeed;
    }
    return patches;
}

}  // namespace muster
