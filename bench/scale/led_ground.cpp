#include "scale/led_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "engine/ground/routes/route_search.h"
#include "engine/world/inspect.h"
#include "muster/event.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr double kRoom = 1.5;      // Clearance of the two ends, about [m].
constexpr double kSample = 2.0;    // Between points that are looked at for an end [m].
constexpr double kThere = 0.5;     // Who is so near to the place is there [m].
constexpr double kMostLag = 25.0;  // The next pose waits while the mean lag is above this [m].

// The two points of the largest region that are farthest apart along x.
std::pair<Vec2, Vec2> endsOf(const Environment& environment, const RouteGraph& routes) {
    const Box& box = environment.def().box;
    std::vector<std::pair<std::int32_t, Vec2>> points;
    std::vector<std::int32_t> count(routes.regionCount(), 0);
    for (double x = box.min.x + kRoom; x < box.max.x; x += kSample)
        for (double y = box.min.y + kRoom; y < box.max.y; y += kSample) {
            const Vec2 p{x, y};
            if (environment.distanceToObstacle(p, kRoom) < kRoom) continue;
            const std::int32_t region = routes.region(p);
            if (region < 0) continue;
            ++count[region];
            points.push_back({region, p});
        }
    const auto largest = static_cast<std::int32_t>(std::max_element(count.begin(), count.end()) -
                                                   count.begin());
    std::erase_if(points, [&](const auto& point) { return point.first != largest; });
    return points.empty() ? std::pair<Vec2, Vec2>{} : std::pair{points.front().second, points.back().second};
}

// The way from end to end on the bare ground.
Result<std::vector<Vec2>> wayThrough(WorldDef def) {
    def.groups.clear();
    Result<World> bare = World::create(def);
    if (!bare.ok()) return bare.status();
    const Environment& environment = inspect::environment(*bare);
    RouteGraph routes;
    routes.update(environment, def.parameters.character.radius);
    const auto [from, to] = endsOf(environment, routes);
    std::vector<Vec2> way = findRoute(routes, from, to);
    if (way.size() < 2) return invalidArgument("found no way through the map");
    return way;
}

Vec2 pointAlong(const std::vector<Vec2>& way, double s) {
    for (std::size_t k = 1; k < way.size(); ++k) {
        const double edge = distance(way[k - 1], way[k]);
        if (s <= edge) return lerp(way[k - 1], way[k], s / std::max(edge, 1e-9));
        s -= edge;
    }
    return way.back();
}

/// Gives the poses one after the other, and measures the steps.
class Leader {
public:
    Leader(const LedGroundDef& def, std::vector<Vec2> way)
        : def_(def), way_(std::move(way)), length_(std::min(pathLength(way_), def.length)) {
        row_.route = length_;
        row_.led = row_.arrived = -1.0;
    }

    Status run(World& world) {
        const auto steps = static_cast<std::int64_t>(def_.seconds / world.parameters().stepTime);
        for (std::int64_t k = 0; k < steps && row_.arrived < 0.0; ++k) {
            if (Status status = lead(world); !status.ok()) return status;
            measure(world);
            if (row_.led >= 0.0 && k % 10 == 0 && missing(world) == 0) row_.arrived = world.time();
        }
        finish(world);
        return {};
    }
    const LedGroundRow& row() const { return row_; }

private:
    // The next pose comes when the last one is so old that the group can have walked there, and has.
    Status lead(World& world) {
        if (row_.led >= 0.0 || world.time() < next_) return {};
        if (def_.stride > 0.0 && at_ > 0.0 && world.group(0).meanLag > kMostLag) return {};
        at_ = def_.stride > 0.0 ? std::min(at_ + def_.stride, length_) : length_;
        next_ = world.time() + def_.stride / def_.speed;
        if (at_ >= length_) row_.led = world.time();
        const Vec2 p = pointAlong(way_, at_);
        const Vec2 along = p - pointAlong(way_, std::max(0.0, at_ - 1.0));
        const double angle = std::round(4.0 * std::atan2(along.y, along.x)) / 4.0;
        return world.submit({world.stepCount(), 1, sequence_++, SetPose{world.group(0).id, p, angle}});
    }

    void measure(World& world) {
        times_.push_back(timedStep(world));
        const StageTimes stages = world.stageTimes();
        for (std::size_t k = 0; k < row_.stages.size(); ++k) row_.stages[k] += stages.milliseconds[k];
        for (const Event& event : world.events()) row_.swaps += event.kind == EventKind::Swap ? 1 : 0;
    }

    static std::size_t missing(const World& world) {
        const CharactersView characters = world.characters();
        const auto targets = world.group(0).placeTargets;
        std::size_t count = 0;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const std::int32_t place = characters.place[i];
            count += place < 0 || distance(characters.position[i], targets[place]) > kThere ? 1 : 0;
        }
        return count;
    }

    void finish(const World& world) {
        row_.missing = missing(world);
        row_.p50 = quantile(times_, 0.5);
        row_.p95 = quantile(times_, 0.95);
        row_.p99 = quantile(times_, 0.99);
        row_.most = quantile(times_, 1.0);
        for (double& sum : row_.stages) sum /= std::max<double>(1.0, static_cast<double>(times_.size()));
        row_.memory = peakMemory();
        row_.hash = world.hash();
    }

    LedGroundDef def_;
    std::vector<Vec2> way_;
    double length_;
    double at_ = 0.0;    // Of the last pose along the way [m].
    double next_ = 0.0;  // Time from which the next one may come [s].
    std::uint32_t sequence_ = 0;
    std::vector<double> times_;  // Of the steps [ms].
    LedGroundRow row_;
};

}  // namespace

Result<LedGroundRow> runLedGround(const LedGroundDef& def) {
    Result<WorldDef> made = largeWorld(def.ground);
    if (!made.ok()) return made.status();
    Result<std::vector<Vec2>> way = wayThrough(*made);
    if (!way.ok()) return way.status();
    made->groups.front().position = way->front();
    Result<World> world = World::create(*made);
    if (!world.ok()) return world.status();
    Leader leader(def, *std::move(way));
    if (Status status = leader.run(*world); !status.ok()) return status;
    return leader.row();
}

std::string ledGroundText(const LedGroundRow& row) {
    char text[512];
    std::snprintf(text, sizeof(text),
                  "way             %9.0f m\nlast pose       %9.1f s\narrived         %9.1f s (%zu missing)\n"
                  "steps           %9.2f ms  p50 %9.2f p95 %9.2f p99 %9.2f max\n",
                  row.route, row.led, row.arrived, row.missing, row.p50, row.p95, row.p99, row.most);
    std::string all = text;
    for (std::size_t k = 0; k < row.stages.size(); ++k) {
        std::snprintf(text, sizeof(text), "  %-18s %7.3f ms  mean\n", stepStages()[k].name.data(),
                      row.stages[k]);
        all += text;
    }
    std::snprintf(text, sizeof(text),
                  "swaps           %9lld\npeak memory     %9.1f MB\nhash            %016llx\n",
                  static_cast<long long>(row.swaps), row.memory, static_cast<unsigned long long>(row.hash));
    return all + text;
}

}  // namespace muster::scale
