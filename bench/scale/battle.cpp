#include "scale/battle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scale/battle_script.h"
#include "scale/battle_watch.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr std::uint32_t kMinute = 3600;        // Steps.
constexpr std::uint32_t kRest = 1200;          // Steps after the stop.
constexpr std::uint32_t kAfterBuilding = 120;  // Steps in which overlaps do not count.
constexpr double kOutOfPlace = 0.5;            // [m]

Status stopAll(World& world) {
    for (std::size_t k = 0; k < world.groupCount(); ++k) {
        const EditQueue stop{world.group(k).id, QueueEdit::Stop, 0};
        const auto sequence = static_cast<std::uint32_t>(k);
        if (Status status = world.submit({world.stepCount(), 2, sequence, stop}); !status.ok()) return status;
    }
    return {};
}

// Plays the battle itself; times of all steps [ms].
Status play(const BattleDef& def, World& world, BattleScript& script, BattleWatch& watch, BattleRow& row,
            std::vector<double>& times) {
    const auto steps = static_cast<std::uint32_t>(std::lround(def.seconds / world.parameters().stepTime));
    double early = 0.0;
    StageMeans means;
    while (world.stepCount() < steps) {
        if (Status status = script.before(world); !status.ok()) return status;
        times.push_back(timedStep(world));
        if (times.size() > 1) means.add(world.stageTimes());
        script.after(world);
        if (times.size() > 1 && times.back() > row.worst) {
            row.worst = times.back();
            row.worstStages = stagesText(world.stageTimes(), 0.5);
        }
        const std::uint32_t building = script.lastBuilding();
        watch.look(world, building == 0 || world.stepCount() > building + kAfterBuilding);
        if (world.stepCount() == kMinute) early = residentMemory();
    }
    row.meanStages = means.text(0.03);
    if (early > 0.0) row.growth = residentMemory() - early;
    return {};
}

void countOutOfPlace(const World& world, BattleRow& row) {
    for (std::size_t i = 0; i < world.characters().size(); ++i) {
        const double away = distanceFromTarget(world, i);
        if (away > kOutOfPlace) ++row.outOfPlace;
        row.farthest = std::max(row.farthest, away);
    }
}

}  // namespace

Result<BattleRow> measureBattle(const BattleDef& def) {
    BattleScript script(def);
    Result<World> world = World::create(script.world());
    if (!world.ok()) return world.status();
    BattleRow row{.characters = static_cast<std::int32_t>(world->characters().size())};
    BattleWatch watch;
    std::vector<double> times;
    if (Status status = play(def, *world, script, watch, row, times); !status.ok()) return status;
    row.first = times.front();
    for (std::size_t at = 0; at < times.size(); at += kMinute) {
        const auto end = times.begin() + static_cast<std::ptrdiff_t>(std::min(times.size(), at + kMinute));
        row.minutes.push_back(quantile({times.begin() + static_cast<std::ptrdiff_t>(at), end}, 0.5));
    }
    times.erase(times.begin());
    row.p50 = quantile(times, 0.5);
    row.p95 = quantile(times, 0.95);
    row.orders = script.orders();
    row.changes = static_cast<double>(watch.changes()) /
                  static_cast<double>(std::max<std::int64_t>(1, script.ordered()));
    row.stuck = watch.stuck();
    row.overlap = watch.overlap();
    row.speed = watch.speed();
    if (Status status = stopAll(*world); !status.ok()) return status;
    times.clear();
    for (std::uint32_t k = 0; k < kRest; ++k) times.push_back(timedStep(*world));
    row.restP50 = quantile(times, 0.5);
    countOutOfPlace(*world, row);
    row.hash = world->hash();
    return row;
}

std::string battleText(const BattleDef& def, const BattleRow& row) {
    char text[1024];
    std::snprintf(
        text, sizeof(text),
        "%d characters in %d groups, %d obstacles on %.0f m, seed %llu, %.0f s, %d orders: step p50 %.2f, "
        "p95 %.2f, first %.1f, worst %.1f ms (%s); %.2f changes of place a character and order; %d "
        "silently stuck; overlap %.1f %%; %.3f of top speed; %.0f MB more than after a minute; 20 s after "
        "the stop %d out of place, the farthest %.1f m, step p50 %.2f ms; hash %016llx\n",
        row.characters, def.groups, def.obstacles, def.side, static_cast<unsigned long long>(def.seed),
        def.seconds, row.orders, row.p50, row.p95, row.first, row.worst, row.worstStages.c_str(), row.changes,
        row.stuck, 100.0 * row.overlap, row.speed, row.growth, row.outOfPlace, row.farthest, row.restP50,
        static_cast<unsigned long long>(row.hash));
    std::string whole = text;
    whole += "mean of the stages [ms]: " + row.meanStages + "\np50 by minute:";
    for (const double minute : row.minutes) {
        std::snprintf(text, sizeof(text), " %.2f", minute);
        whole += text;
    }
    return whole + " ms\n";
}

}  // namespace muster::scale
