#include "lab/verify/row.h"

#include <limits>

#include "lab/verify/verify_scene.h"

namespace muster {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

template <class Item>
void append(std::vector<Item>& all, std::vector<Item> more) {
    for (Item& item : more) all.push_back(std::move(item));
}

}  // namespace

void RowReport::atMost(const std::string& what, double value, double high, const std::string& unit,
                       Whose whose) {
    checks.push_back({what, value, -kEndless, high, unit, whose, true});
}

void RowReport::atLeast(const std::string& what, double value, double low, const std::string& unit,
                        Whose whose) {
    checks.push_back({what, value, low, kEndless, unit, whose, true});
}

void RowReport::within(const std::string& what, double value, double low, double high,
                       const std::string& unit, Whose whose) {
    checks.push_back({what, value, low, high, unit, whose, true});
}

void RowReport::shown(const std::string& what, double value, const std::string& unit) {
    checks.push_back({what, value, -kEndless, kEndless, unit, Whose::Own, false});
}

const std::vector<RowDef>& verifyRows() {
    static const std::vector<RowDef> rows = [] {
        std::vector<RowDef> all;
        append(all, rimeaRows());
        append(all, imoRows());
        append(all, nistRows());
        append(all, isoRows());
        append(all, dataRows());
        return all;
    }();
    return rows;
}

const std::vector<SceneDef>& verifyScenes() {
    static const std::vector<SceneDef> scenes = [] {
        std::vector<SceneDef> all;
        append(all, freeWalkScenes());
        append(all, roomScenes());
        append(all, choiceScenes());
        append(all, bottleneckScenes());
        append(all, stairScenes());
        append(all, streamScenes());
        append(all, encounterScenes());
        return all;
    }();
    return scenes;
}

}  // namespace muster
