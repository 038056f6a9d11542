// Death and reinforcement: the game keeps its own table of units by Muster's ids. People fall on the march,
// others join, and nobody else changes id, stops or runs across the formation.
#include <muster/world.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using muster::EventKind;
using muster::GroupId;

/// What a game knows of a unit.
struct Unit {
    std::string name;
    int health = 100;
};

/// A game: its units by the ids of Muster's characters.
class Game {
public:
    explicit Game(muster::World& world) : world_(world) {
        for (const std::uint32_t id : world_.characters().id) enlist(id);
    }

    /// Hurts somebody; who has no health left falls.
    void hit(std::uint32_t id, int damage) {
        Unit& unit = units.at(id);
        unit.health -= damage;
        if (unit.health <= 0) fallen_.push_back(id);
    }
    /// People join a group where they stand; their ids come with the events of the step.
    void reinforce(GroupId group, std::vector<muster::Vec2> positions) {
        send(muster::AddCharacters{group, std::move(positions), {}});
    }
    void order(GroupId group, muster::Order order) {
        send(muster::GiveOrder{group, muster::QueueMode::Replace, 0, std::move(order)});
    }

    void run(double seconds) {
        for (const double end = world_.time() + seconds; world_.time() < end;) step();
    }

    std::map<std::uint32_t, Unit> units;  ///< All that are alive, by id.
    bool good = true;                     ///< False where a command was refused.

private:
    void enlist(std::uint32_t id) { units[id] = {"unit " + std::to_string(id)}; }

    void step() {
        if (!fallen_.empty()) send(muster::TransferCharacters{fallen_, {}});
        fallen_.clear();
        world_.step();
        for (const muster::Event& event : world_.events()) {
            if (event.kind == EventKind::Joined) enlist(event.subject);
            if (event.kind == EventKind::Left) units.erase(event.subject);
        }
        good = good && world_.rejections().empty();
        for (const muster::Rejection& rejection : world_.rejections())
            std::fprintf(stderr, "%s\n", rejection.status.message().c_str());
    }
    void send(muster::CommandBody body) {
        const muster::Status status = world_.submit({world_.stepCount(), 1, sequence_++, std::move(body)});
        if (!status.ok()) std::fprintf(stderr, "%s\n", status.message().c_str());
        good = good && status.ok();
    }

    muster::World& world_;
    std::vector<std::uint32_t> fallen_;
    std::uint32_t sequence_ = 0;
};

/// The mean speed of a crowd [m/s].
double meanSpeed(const muster::World& world) {
    double sum = 0.0;
    for (const muster::Vec2 velocity : world.characters().velocity) sum += muster::length(velocity);
    return world.characters().size() > 0 ? sum / static_cast<double>(world.characters().size()) : 0.0;
}

/// True where the world's characters are those of the game.
bool agree(const muster::World& world, const Game& game) {
    std::set<std::uint32_t> ids(world.characters().id.begin(), world.characters().id.end());
    for (const auto& [id, unit] : game.units)
        if (ids.erase(id) == 0) return false;
    return ids.empty();
}

void report(const char* what, const muster::World& world) {
    std::printf("%5.1f s  %-24s %3zu people, %.2f m/s on average\n", world.time(), what,
                world.characters().size(), meanSpeed(world));
}

}  // namespace

int main() {
    muster::WorldDef def;
    def.box = {{-40.0, -20.0}, {40.0, 20.0}};
    muster::GroupDef group;
    group.count = 60;
    group.formation.files = 10;
    group.position = {-30.0, 0.0};
    def.groups.push_back(group);
    muster::Result<muster::World> made = muster::World::create(def);
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;
    const GroupId company = world.group(0).id;
    Game game(world);
    game.order(company, muster::Order::move({25.0, 0.0}, 0.0));
    game.run(4.0);
    report("on the march", world);

    // Ten fall, one every half a second: the ranks behind them close up, and the march goes on.
    const double speed = meanSpeed(world);
    double slowest = speed;
    for (std::uint32_t id = 3; id <= 57; id += 6) {
        game.hit(id, 100);
        game.run(0.5);
        slowest = std::min(slowest, meanSpeed(world));
    }
    report("ten have fallen", world);

    // Eight more come up from behind, and get places of their own.
    const muster::Vec2 rear = world.group(0).pose.position - muster::Vec2{8.0, 0.0};
    std::vector<muster::Vec2> positions;
    for (int k = 0; k < 8; ++k) positions.push_back(rear + muster::Vec2{0.0, 1.0 * k - 3.5});
    game.reinforce(company, positions);
    game.run(0.5);
    report("eight have joined", world);
    const std::uint32_t newest = game.units.rbegin()->first;
    game.run(40.0);
    report("there", world);

    const bool kept = slowest > 0.8 * speed && game.units.size() == 58 && newest == 68 && agree(world, game);
    return kept && game.good && world.group(0).meanLag < 0.5 ? 0 : 1;
}
