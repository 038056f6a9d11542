// Movement from outside: Muster says who goes where and by which way, the program moves the people itself
// (orca.h stands for its own engine) and writes back where they are, every step.
#include <muster/world.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "orca.h"

namespace {

using muster::Vec2;

constexpr double kTopSpeed = 1.4;  // [m/s]
constexpr double kHorizon = 2.0;   // [s]
constexpr double kSight = 4.0;     // [m]

/// Moves all characters of a world.
class Movement {
public:
    Movement(muster::World& world, const muster::WorldDef& def) : world_(world) {
        for (const muster::ObstacleDef& pillar : def.obstacles)
            pillars_.push_back({pillar.centre, {}, pillar.radius, false});
    }

    /// Tells Muster that it does not move them any more.
    void takeOver() {
        const auto ids = world_.characters().id;
        send(muster::ChangeCharacters{{ids.begin(), ids.end()}, {}, muster::Driver::Outside});
        world_.step();
    }

    /// Chooses velocities by what Muster wants, moves, writes back, and steps.
    void step() {
        const muster::CharactersView people = world_.characters();
        const double dt = world_.parameters().stepTime;
        std::vector<orca::Disc> discs;
        for (std::size_t i = 0; i < people.size(); ++i)
            discs.push_back({people.position[i], people.velocity[i]});
        muster::WriteMotion motion;
        for (std::size_t i = 0; i < people.size(); ++i) {
            const Vec2 velocity = orca::choose(constraints(discs, i, dt), people.wantedVelocity[i],
                                               kTopSpeed);
            motion.ids.push_back(people.id[i]);
            motion.positions.push_back(people.position[i] + velocity * dt);
            motion.velocities.push_back(velocity);
        }
        send(std::move(motion));
        world_.step();
        for (const muster::Rejection& rejection : world_.rejections())
            std::fprintf(stderr, "%s\n", rejection.status.message().c_str());
        good = good && world_.rejections().empty();
    }

    void send(muster::CommandBody body) {
        const muster::Status status = world_.submit({world_.stepCount(), 1, sequence_++, std::move(body)});
        if (!status.ok()) std::fprintf(stderr, "%s\n", status.message().c_str());
        good = good && status.ok();
    }

    bool good = true;  ///< False where a command was refused.

private:
    std::vector<orca::HalfPlane> constraints(const std::vector<orca::Disc>& discs, std::size_t self,
                                             double dt) const {
        std::vector<orca::HalfPlane> planes;
        for (std::size_t j = 0; j < discs.size(); ++j)
            if (j != self && distance(discs[j].position, discs[self].position) < kSight)
                planes.push_back(orca::avoid(discs[self], discs[j], kHorizon, dt));
        for (const orca::Disc& pillar : pillars_)
            if (distance(pillar.position, discs[self].position) < kSight + pillar.radius)
                planes.push_back(orca::avoid(discs[self], pillar, 0.5, dt));
        return planes;
    }

    muster::World& world_;
    std::vector<orca::Disc> pillars_;
    std::uint32_t sequence_ = 0;
};

muster::WorldDef court() {
    muster::WorldDef def;
    def.box = {{-20.0, -12.0}, {20.0, 12.0}};
    for (const double y : {-4.0, 0.0, 4.0}) {
        muster::ObstacleDef pillar;
        pillar.centre = {0.0, y};
        pillar.radius = 0.6;
        def.obstacles.push_back(pillar);
    }
    for (const double x : {-12.0, 12.0}) {
        muster::GroupDef group;
        group.count = 16;
        group.formation.spacing = 1.2;
        group.position = {x, 0.0};
        group.angle = x < 0.0 ? 0.0 : 3.14159265;
        def.groups.push_back(group);
    }
    return def;
}

}  // namespace

int main() {
    const muster::WorldDef def = court();
    muster::Result<muster::World> made = muster::World::create(def);
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;
    Movement movement(world, def);
    movement.takeOver();
    // Two groups change sides between the pillars: Muster finds the ways and gives out the places.
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const double side = g == 0 ? 1.0 : -1.0;
        movement.send(muster::GiveOrder{world.group(g).id, muster::QueueMode::Replace, 0,
                                        muster::Order::go({side * 12.0, 0.0}, g == 0 ? 0.0 : 3.14159265)});
    }
    double deepest = 0.0;
    while (world.time() < 60.0) {
        movement.step();
        deepest = std::max(deepest, world.contacts().worstPenetration);
    }
    double lag = 0.0;
    for (std::size_t g = 0; g < world.groupCount(); ++g) lag = std::max(lag, world.group(g).meanLag);
    std::printf("%zu people, on average at most %.2f m from their places, deepest overlap %.1f %%\n",
                world.characters().size(), lag, 100.0 * deepest);
    return movement.good && lag < 0.5 && deepest < 0.1 ? 0 : 1;
}
