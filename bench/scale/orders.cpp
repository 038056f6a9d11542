#include "scale/orders.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/maths.h"
#include "base/random.h"
#include "muster/world.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr double kSpacing = 1.0;      // Of both formations [m].
constexpr double kBetween = 2.0;      // Two groups of a row, edge to edge [m].
constexpr double kWalk = 20.0;        // From the middle of the crossing to the first rows, about [m].
constexpr double kOrderPeriod = 0.5;  // Between two poses [s].
constexpr double kStanding = 0.05;    // A slower character stands [m/s].
constexpr double kNear = 0.5;         // From its place [m].
constexpr double kWall = 1.0;         // Thickness of a wall with gaps [m].
constexpr double kWallSpacing = 0.8;  // Of formations before and behind it [m].
constexpr double kWallWalk = 8.0;     // From the wall to the first rows [m].
constexpr double kWallRoom = 5.0;     // Round formations beside it [m].
constexpr double kGapShare = 0.2;     // Of the front of a formation: all gaps together.

double spacingOf(const OrdersDef& def) {
    return def.gaps > 0 ? kWallSpacing : kSpacing;
}

// Side of the square formation of one group.
double sideOf(const OrdersDef& def) {
    return spacingOf(def) * std::ceil(std::sqrt(static_cast<double>(def.count) / def.groups));
}

// Through a wall all walk east.
bool walksEast(const OrdersDef& def, std::int32_t group) {
    return def.gaps > 0 || group % 2 == 0;
}

// Centre of a group, from the middle of the row of groups that walk its way.
double offsetOf(const OrdersDef& def, std::int32_t group) {
    const std::int32_t row = def.gaps > 0 ? def.groups : (def.groups + 1 - group % 2) / 2;
    const std::int32_t number = def.gaps > 0 ? group : group / 2;
    return (number - 0.5 * (row - 1)) * (sideOf(def) + kBetween);
}

// From the middle to where groups start and go.
double awayOf(const OrdersDef& def) {
    if (def.gaps > 0) return 0.5 * sideOf(def) + kWallWalk;
    return 0.5 * std::max(1, def.groups / 2) * (sideOf(def) + kBetween) + kWalk;
}

// Half of the width and height of the world. Passages are looked for on small ground only.
Vec2 halfBox(const OrdersDef& def) {
    if (def.gaps > 0)
        return {awayOf(def) + 0.5 * sideOf(def) + kWallRoom,
                offsetOf(def, def.groups - 1) + 0.5 * sideOf(def) + kWallRoom};
    const double edge = awayOf(def) + sideOf(def);
    return {edge, edge};
}

ObstacleDef wallPart(double from, double to) {
    ObstacleDef part;
    const double x = 0.5 * kWall;
    part.polygon = {{-x, from}, {x, from}, {x, to}, {-x, to}};
    return part;
}

// A wall across the way with gaps along the front of a formation, every second one three times as wide as the
// others.
void addWall(const OrdersDef& def, std::vector<ObstacleDef>& obstacles) {
    const double edge = halfBox(def).y, front = 2.0 * (edge - kWallRoom);
    double from = -edge;
    for (std::int32_t k = 0; k < def.gaps; ++k) {
        const double middle = front * ((k + 0.5) / def.gaps - 0.5);
        const double half = 0.25 * kGapShare * front / def.gaps * (k % 2 == 0 ? 1.0 : 3.0);
        obstacles.push_back(wallPart(from, middle - half));
        from = middle + half;
    }
    if (def.gaps > 0) obstacles.push_back(wallPart(from, edge));
}

void addWeights(Random& random, GroupDef& group) {
    group.bodies.resize(static_cast<std::size_t>(group.count));
    for (Body& body : group.bodies) body.supply = 0.25 * (1 + random.below(12));
    for (std::int32_t k = 0; k < group.count; ++k) group.demands.push_back(0.25 * (1 + random.below(12)));
}

WorldDef worldOf(const OrdersDef& def) {
    WorldDef world;
    const double away = awayOf(def);
    const Vec2 half = halfBox(def);
    world.box = {-half, half};
    addWall(def, world.obstacles);
    Random random(def.seed);
    for (std::int32_t k = 0; k < def.obstacles; ++k)
        world.obstacles.push_back(
            {.centre = {.x = random.uniform(-half.x, half.x), .y = random.uniform(-half.y, half.y)},
             .radius = 0.5});
    for (std::int32_t k = 0; k < def.groups; ++k) {
        GroupDef group{.name = "Group " + std::to_string(k),
                       .count = def.count / def.groups,
                       .formation = {.kind = FormationKind::Square, .spacing = spacingOf(def)}};
        const double offset = offsetOf(def, k);
        group.position = walksEast(def, k) ? Vec2{-away, offset} : Vec2{offset, -away};
        if (def.weights) addWeights(random, group);
        world.groups.push_back(group);
    }
    return world;
}

/// Gives the orders of a step: all groups cross the square, and the first one gets a new pose every half
/// second.
class Director {
public:
    explicit Director(const OrdersDef& def) : def_(def), away_(awayOf(def)) {}

    Status before(World& world) {
        for (std::int32_t k = 1; k < def_.groups && world.stepCount() == 0; ++k) {
            const double offset = offsetOf(def_, k);
            const Vec2 goal = walksEast(def_, k) ? Vec2{away_, offset} : Vec2{offset, away_};
            if (Status status = order(world, k, goal, 0.0); !status.ok()) return status;
        }
        const auto period = static_cast<std::uint32_t>(
            std::lround(kOrderPeriod / world.parameters().stepTime));
        if (world.stepCount() % period != 0) return {};
        const std::uint32_t n = world.stepCount() / period;
        const double aside = n % 2 == 0 ? 1.0 : -1.0;
        if (def_.gaps > 0) return order(world, 0, {away_, offsetOf(def_, 0) + 2.0 * aside}, 0.0);
        return order(world, 0, {away_, offsetOf(def_, 0) + 4.0 * aside}, 0.1 * (n % 7));
    }

private:
    Status order(World& world, std::size_t group, Vec2 position, double angle) {
        Command command{.step = world.stepCount(),
                        .sequence = ++sequence_,
                        .body = SetPose{world.group(group).id, position, angle}};
        if (def_.moves)
            command.body = GiveOrder{world.group(group).id, QueueMode::Replace, 0,
                                     Order::move(position, angle)};
        return world.submit(command);
    }

    const OrdersDef& def_;
    double away_;
    std::uint32_t sequence_ = 0;
};

// How long each character has stood still, not arrived.
class Waits {
public:
    void look(const World& world) {
        const CharactersView characters = world.characters();
        since_.resize(characters.size(), 0);
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const std::span<const Vec2> places = world.group(characters.group[i]).placePositions;
            const bool near = characters.place[i] >= 0 &&
                              distance(characters.position[i], places[characters.place[i]]) < kNear;
            const bool stands = length(characters.velocity[i]) < kStanding && !near;
            since_[i] = stands ? since_[i] + 1 : 0;
            longest_ = std::max(longest_, since_[i]);
        }
    }
    std::int32_t longest() const { return longest_; }

private:
    std::vector<std::int32_t> since_;
    std::int32_t longest_ = 0;
};

// The first step plans everything: it has no orders alone.
double mostAbove(const std::vector<double>& least, std::size_t period) {
    constexpr std::size_t kRound = 12;
    double most = 0.0;
    for (std::size_t k = period; k + kRound < least.size() && k >= kRound; k += period) {
        const std::vector<double> near(least.begin() + static_cast<std::ptrdiff_t>(k - kRound),
                                       least.begin() + static_cast<std::ptrdiff_t>(k + kRound));
        most = std::max(most, least[k] - quantile(near, 0.5));
    }
    return most;
}

// One run: lowers `least` to its times, and notes the stages of steps that were the slowest so far.
Status run(const OrdersDef& def, std::vector<double>& least, std::vector<std::string>& stages,
           OrdersRow& row) {
    Result<World> world = World::create(worldOf(def));
    if (!world.ok()) return world.status();
    Director director(def);
    Waits waits;
    for (std::size_t step = 0; step < least.size(); ++step) {
        if (Status status = director.before(*world); !status.ok()) return status;
        const double took = timedStep(*world);
        waits.look(*world);
        if (took >= least[step]) continue;
        least[step] = took;
        stages[step] = stagesText(world->stageTimes(), 0.5);
    }
    row.longestWait = waits.longest() * world->parameters().stepTime;
    const std::uint64_t hash = world->hash();
    if (row.hash != 0 && row.hash != hash) return Status(StatusCode::Corrupt, "orders: two runs differ");
    row.hash = hash;
    return {};
}

}  // namespace

Result<OrdersRow> measureOrders(const OrdersDef& def) {
    const auto steps = static_cast<std::size_t>(def.seconds * 60.0);
    std::vector<double> least(std::max<std::size_t>(2, steps), 1e300);
    std::vector<std::string> stages(least.size());
    OrdersRow row;
    for (std::int32_t k = 0; k < def.runs; ++k)
        if (Status status = run(def, least, stages, row); !status.ok()) return status;
    const auto worst = std::max_element(least.begin(), least.end());
    row.first = least.front();
    row.worst = *worst;
    row.worstStep = static_cast<std::int32_t>(worst - least.begin());
    row.worstStages = stages[row.worstStep];
    row.above = mostAbove(least, static_cast<std::size_t>(kOrderPeriod * 60.0));
    row.p50 = quantile(least, 0.5);
    row.p95 = quantile(least, 0.95);
    return row;
}

}  // namespace muster::scale
