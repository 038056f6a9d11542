// The worlds of a C program, and the memory of what it reads of them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bindings/c/c_world/call.h"
#include "bindings/c/c_world/memory.h"
#include "muster/muster.h"
#include "muster/world.h"

namespace muster::c_api {

/// What is lent until the next call for the same thing.
enum class Lent : std::uint8_t {
    WayAhead,
    Standings,
    GroupDef,
    Controls,
    Orders,
    Forecast,
    Obstacle,
    Patch,
    Checkpoints,
    Areas,
    Rejections,
    StageTimes,
    Count
};

/// A world behind a handle: a program's own, or one that a replay shows.
class WorldHandle {
public:
    explicit WorldHandle(World world) : own_(std::move(world)), world_(&*own_) {}
    explicit WorldHandle(const World* shown) : world_(shown) {}

    const World& world() const { return *world_; }
    /// The world to change; null for one that is shown.
    World* own() { return own_ ? &*own_ : nullptr; }
    /// Memory for one kind of read-out, emptied.
    Arena& lend(Lent kind) {
        Arena& arena = arenas_[static_cast<std::size_t>(kind)];
        arena.reset();
        return arena;
    }

    /// Keeps what was read until the next call for the same thing.
    const GroupDef& keep(GroupDef def) { return group_ = std::move(def); }
    const ObstacleView& keep(ObstacleView view) { return obstacle_ = std::move(view); }
    const PatchView& keep(PatchView view) { return patch_ = std::move(view); }
    const std::vector<AreaView>& keep(std::vector<AreaView> views) { return areas_ = std::move(views); }

private:
    std::optional<World> own_;
    const World* world_;
    std::array<Arena, static_cast<std::size_t>(Lent::Count)> arenas_;
    GroupDef group_;
    ObstacleView obstacle_;
    PatchView patch_;
    std::vector<AreaView> areas_;
};

/// Takes a world and gives its handle.
MusterWorldId addWorld(std::unique_ptr<WorldHandle> world);
/// The world of that handle; NotFound where there is none.
Result<WorldHandle*> findWorld(MusterWorldId id);
/// Ends the handle of a world.
Status endWorld(MusterWorldId id);

/// Calls `work` with the handle's world, to read it.
template <class Work>
MusterStatus readWorld(MusterWorldId id, Work&& work) noexcept {
    return call([&]() -> Status {
        const Result<WorldHandle*> found = findWorld(id);
        return found.ok() ? work(**found) : found.status();
    });
}
/// Calls `work` with the handle's world, to change it. Fails for one that a replay shows.
template <class Work>
MusterStatus changeWorld(MusterWorldId id, Work&& work) noexcept {
    return readWorld(id, [&](WorldHandle& handle) -> Status {
        World* const own = handle.own();
        if (own == nullptr)
            return {StatusCode::Unsupported,
                    "world: found one that a replay shows, expected one of your own"};
        return work(*own);
    });
}
/// Writes a value that `read` gives of a world.
template <class T, class Read>
MusterStatus readValue(MusterWorldId id, T* out, const char* name, Read&& read) noexcept {
    return readWorld(id, [&](WorldHandle& handle) -> Status {
        if (out == nullptr) return nullArgument(name);
        *out = read(handle.world());
        return {};
    });
}

}  // namespace muster::c_api
