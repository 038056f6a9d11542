// Rollback: a command arrives late; the world goes back to a snapshot before it and simulates again what came
// since.
#include <muster/world.h>

#include <cstdio>
#include <deque>
#include <vector>

namespace {

/// A world that takes commands for steps up to a second in the past.
class RollbackWorld {
public:
    explicit RollbackWorld(muster::World world) : world_(std::move(world)) { keep(); }

    /// Steps, and keeps a snapshot of every tenth state.
    void step() {
        world_.step();
        if (world_.stepCount() % kSpacing == 0) keep();
    }
    /// Takes a command for any step since the oldest snapshot. False where it is older, or malformed.
    bool submit(const muster::Command& command) {
        const std::uint32_t now = world_.stepCount();
        if (command.step >= now) return add(command);
        while (!kept_.empty() && kept_.back().step > command.step) kept_.pop_back();
        if (kept_.empty()) return false;
        if (!world_.rewind(kept_.back().bytes).ok()) return false;
        // A snapshot holds the commands that waited when it was taken; those that were given later are given
        // again.
        for (std::size_t i = kept_.back().commands; i < log_.size(); ++i)
            if (!world_.submit(log_[i]).ok()) return false;
        if (!add(command)) return false;
        while (world_.stepCount() < now) step();
        return true;
    }
    const muster::World& world() const { return world_; }

private:
    static constexpr std::uint32_t kSpacing = 10;  // Steps between snapshots.
    static constexpr std::size_t kMost = 7;        // Snapshots kept: a second's worth.

    struct Kept {
        std::uint32_t step = 0;
        std::size_t commands = 0;  // Given before it.
        std::vector<std::uint8_t> bytes;
    };

    void keep() {
        kept_.push_back({world_.stepCount(), log_.size(), world_.snapshot()});
        if (kept_.size() > kMost) kept_.pop_front();
    }
    bool add(const muster::Command& command) {
        if (!world_.submit(command).ok()) return false;
        log_.push_back(command);
        return true;
    }

    muster::World world_;
    std::deque<Kept> kept_;
    std::vector<muster::Command> log_;  // All commands, in the order they came.
};

muster::World makeWorld() {
    muster::WorldDef def;
    muster::GroupDef group;
    group.count = 49;
    def.groups.push_back(group);
    return muster::World::create(def).value();  // The definition is known to be valid.
}

}  // namespace

int main() {
    muster::World onTime = makeWorld();
    RollbackWorld late(makeWorld());
    const muster::Vec2 start = onTime.group(0).finalMesh.front();
    const muster::Command down{10, 1, 0, muster::Touch{muster::TouchPhase::Down, 1, start, 10.0 / 60.0, {}}};
    const muster::Command move{40, 2, 0, muster::SetParameter{"character.maxSpeed", 1.5}};
    const muster::Command up{
        60, 1, 1, muster::Touch{muster::TouchPhase::Move, 1, start + muster::Vec2{5.0, 0.0}, 1.0, {}}};

    // One world gets all commands in time, the other gets one of them half a second late.
    bool accepted = onTime.submit(down).ok() && onTime.submit(move).ok() && onTime.submit(up).ok();
    accepted = accepted && late.submit(down) && late.submit(up);
    for (int step = 0; step < 70; ++step) late.step();
    const std::uint64_t before = late.world().hash();
    accepted = accepted && late.submit(move);
    for (int step = 0; step < 70; ++step) onTime.step();
    const bool same = onTime.hash() == late.world().hash();
    std::printf(
        "a command for step 40 came at step %u: the state was %016llx, is %016llx, should be %016llx\n",
        late.world().stepCount(), static_cast<unsigned long long>(before),
        static_cast<unsigned long long>(late.world().hash()), static_cast<unsigned long long>(onTime.hash()));
    return accepted && same && before != onTime.hash() ? 0 : 1;
}
