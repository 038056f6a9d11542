#include "scale/people_cost.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "muster/parameter_table.h"
#include "muster/world.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr double kRatio = 4.0;      // Length of a ring by its width.
constexpr std::int32_t kWarm = 60;  // Steps before the times count.
constexpr std::int32_t kTurn = 20;  // Steps of one law at a time.

WorldDef ringOf(const char* preset, std::int32_t count, double density) {
    WorldDef def;
    def.parameters = *parameterPreset(preset);
    const double width = std::sqrt(count / density / kRatio), length = kRatio * width;
    def.box = {{0.0, 0.0}, {length, width}};
    def.ring = true;
    GroupDef group;
    group.count = count;
    group.people = {adults()};
    group.orders = {Order::walk(0.0)};
    const int rows = std::max(1, static_cast<int>(width / std::sqrt(0.866 / density)));
    const int files = (count + rows - 1) / rows;
    for (std::int32_t i = 0; i < count; ++i)
        group.starts.push_back(
            {(i / rows + (i % rows % 2) * 0.5) * length / files, (i % rows + 0.5) * width / rows});
    def.groups = {group};
    return def;
}

double meanSpeed(const World& world) {
    double sum = 0.0;
    for (const Vec2 v : world.characters().velocity) sum += v.x;
    return sum / static_cast<double>(world.characters().size());
}

Result<PeopleRow> measureOne(std::int32_t count, double density, std::int32_t rounds) {
    Result<World> units = World::create(ringOf("units", count, density), 1);
    if (!units.ok()) return units.status();
    Result<World> people = World::create(ringOf("people", count, density), 1);
    if (!people.ok()) return people.status();
    for (std::int32_t k = 0; k < kWarm; ++k) {
        units->step();
        people->step();
    }
    std::vector<double> ofUnits, ofPeople;
    for (std::int32_t round = 0; round < rounds; ++round) {
        for (std::int32_t k = 0; k < kTurn; ++k) ofUnits.push_back(timedStep(*units));
        for (std::int32_t k = 0; k < kTurn; ++k) ofPeople.push_back(timedStep(*people));
    }
    return PeopleRow{count,
                     density,
                     quantile(ofUnits, 0.5),
                     quantile(ofPeople, 0.5),
                     meanSpeed(*units),
                     meanSpeed(*people)};
}

}  // namespace

Result<std::vector<PeopleRow>> measurePeople(const PeopleCostDef& def) {
    const std::vector<std::int32_t> counts = def.counts.empty()
                                                 ? std::vector<std::int32_t>{1000, 10000, 100000}
                                                 : def.counts;
    const std::vector<double> densities = def.densities.empty() ? std::vector<double>{0.5, 4.0}
                                                                : def.densities;
    std::vector<PeopleRow> rows;
    for (const std::int32_t count : counts)
        for (const double density : densities) {
            Result<PeopleRow> row = measureOne(count, density, def.rounds);
            if (!row.ok()) return row.status();
            rows.push_back(*row);
        }
    return rows;
}

std::string peopleText(const std::vector<PeopleRow>& rows) {
    std::string text = "characters  density   units ms  people ms  ratio  speeds m/s\n";
    for (const PeopleRow& row : rows) {
        char line[160];
        std::snprintf(line, sizeof(line), "%10d %8.1f %10.3f %10.3f %6.2f  %.2f, %.2f\n", row.count,
                      row.density, row.units, row.people, row.ratio(), row.unitsSpeed, row.peopleSpeed);
        text += line;
    }
    return text;
}

}  // namespace muster::scale
