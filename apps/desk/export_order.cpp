#include "export_order.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "json/json.h"
#include "muster/own_clips.h"
#include "player_page.h"
#include "zip_file.h"

namespace muster {
namespace {

std::string plainName(const std::string& title) {
    std::string name;
    for (const char c : title) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_';
        if (plain)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name.empty() ? "take" : name.substr(0, 60);
}

bool hasBodies(const std::string& format) {
    return format == "glb" || format == "usda" || format == "usdc" || format == "bvh" || format == "player" ||
           isPlayerPage(format);
}

bool isFolder(const std::string& format) {
    return format == "bvh" || format == kPlayerFolder.name;
}

/// A list of whole numbers from 0 to 2^32 - 1, empty where there is none.
Status readNumbers(const Json& value, const char* key, std::vector<std::uint32_t>& numbers) {
    const Json* list = value.find(key);
    if (list == nullptr) return {};
    const auto bad = [key](const Json& found) {
        return invalidArgument("export: found " + describeJson(found) + " for " + key +
                               ", expected a list of whole numbers");
    };
    if (!list->isArray()) return bad(*list);
    for (const Json& one : list->elements()) {
        const double number = one.isNumber() ? one.number() : -1.0;
        if (!(number >= 0.0 && number <= 4294967295.0) || number != std::floor(number)) return bad(one);
        numbers.push_back(static_cast<std::uint32_t>(number));
    }
    return {};
}

/// Who is chosen.
Status readPeople(const Json& value, ExportOrder& order) {
    if (Status s = readNumbers(value, "groups", order.groups); !s.ok()) return s;
    std::vector<std::uint32_t> people;
    if (Status s = readNumbers(value, "people", people); !s.ok()) return s;
    if (people.empty()) return {};
    if (people.size() != 2)
        return invalidArgument("export: found " + std::to_string(people.size()) +
                               " numbers for people, expected the first and the last");
    order.firstPerson = people[0], order.lastPerson = people[1];
    return {};
}

/// What the text says; the take is a name.
Result<ExportOrder> parseOrder(const std::string& text) {
    const auto value = parseJson(text, "export");
    if (!value.ok()) return value.status();
    if (!value->isObject())
        return invalidArgument("export: found " + describeJson(*value) + ", expected an object");
    ExportOrder order;
    for (const auto& [key, target] :
         {std::pair<const char*, std::string*>{"take", &order.take}, {"format", &order.format}}) {
        const Json* found = value->find(key);
        if (found == nullptr || !found->isText())
            return invalidArgument(std::string("export: expected a text for ") + key);
        *target = found->text();
    }
    for (const auto& [key, target] :
         {std::pair<const char*, double*>{"from", &order.from}, {"to", &order.to}, {"fps", &order.fps}}) {
        const Json* found = value->find(key);
        if (found == nullptr) continue;
        if (!found->isNumber() || !std::isfinite(found->number()))
            return invalidArgument(std::string("export: found ") + describeJson(*found) + " for " + key +
                                   ", expected a number");
        *target = found->number();
    }
    if (const Json* speeds = value->find("speeds"); speeds != nullptr && speeds->isBoolean())
        order.speeds = speeds->boolean();
    if (const Json* estimate = value->find("estimate"); estimate != nullptr && estimate->isBoolean())
        order.estimate = estimate->boolean();
    if (Status s = readPeople(*value, order); !s.ok()) return s;
    return order;
}

}  // namespace

Result<ExportOrder> readExportOrder(const std::string& text, TakeShelf& shelf) {
    auto order = parseOrder(text);
    if (!order.ok()) return order;
    const auto path = shelf.pathOf(order->take);
    if (!path.ok()) return path.status();
    order->title = order->take.substr(0, order->take.rfind('.'));
    for (const ShelvedTake& take : shelf.list())
        if (take.name == order->take && !take.about.title.empty()) order->title = take.about.title;
    order->take = *path;
    return order;
}

Result<std::string> exportFileName(const ExportOrder& order) {
    const auto format = exportOrPageFormat(order.format);
    if (!format.ok()) return format.status();
    return plainName(order.title) + format->ending + (isFolder(order.format) ? ".zip" : "");
}

namespace {

/// An order with what it needs.
struct ExportWork {
    ExportFormat format;
    Take take;
    ClipLibrary clips;
    ExportDef def;
};

Result<ExportWork> prepare(const ExportOrder& order, const ExportTools& tools) {
    const auto format = exportOrPageFormat(order.format);
    if (!format.ok()) return format.status();
    auto take = readTake(order.take);
    if (!take.ok()) return take.status();
    auto clips = tools.loadClips ? tools.loadClips(take->def.name, take->def)
                                 : Result<ClipLibrary>(ownClips());
    if (!clips.ok()) clips = ownClips();
    ExportDef def{.from = order.from, .to = order.to, .fps = order.fps};
    if (order.speeds && hasBodies(order.format)) def.speeds = take->about.speeds;
    def.groups = order.groups;
    def.firstPerson = order.firstPerson, def.lastPerson = order.lastPerson;
    return ExportWork{*format, std::move(take).value(), std::move(clips).value(), std::move(def)};
}

}  // namespace

Status writeExport(const ExportOrder& order, const ExportTools& tools, const std::string& path,
                   const std::function<bool(double)>& progress) {
    const auto work = prepare(order, tools);
    if (!work.ok()) return work.status();
    const std::string target = isFolder(order.format) ? path + "-files" : path;
    Status status = exportTakeOrPage(work->take, work->clips, work->format, target, work->def,
                                     tools.playerFolder, progress);
    if (!isFolder(order.format)) return status;
    if (status.ok()) status = zipFolder(target, path);
    std::error_code ignored;
    std::filesystem::remove_all(target, ignored);
    return status;
}

Result<ExportEstimate> estimateExport(const ExportOrder& order, const ExportTools& tools,
                                      const std::string& path, const std::function<bool()>& goOn) {
    const auto work = prepare(order, tools);
    if (!work.ok()) return work.status();
    const auto write = [&](const ExportDef& def, const std::string& part) {
        return exportTakeOrPage(work->take, work->clips, work->format, part, def, tools.playerFolder,
                                [&](double) { return goOn(); });
    };
    return estimateExport(work->take, order.format, work->def, path, write);
}

}  // namespace muster
