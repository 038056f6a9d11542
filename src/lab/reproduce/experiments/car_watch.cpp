#include "lab/reproduce/experiments/car_watch.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace muster {
namespace {

// Distance of a vertex from its vertex of the user mesh from which on it gives way [m].
constexpr double kYieldDistance = 0.1;
// Distance below which a vertex that gave way stands on the user mesh again [m].
constexpr double kRestDistance = 0.02;

}  // namespace

CarWatch::CarWatch(const World& world)
    : smallest_(world.characters().size(), kFar), displaced_(world.group(0).userMesh.size(), 0) {}

void CarWatch::observe(const World& world) {
    const std::span<const Vec2> positions = world.characters().position;
    const double radius = world.parameters().character.radius;
    for (const ObstaclePiece& piece : inspect::environment(world).pieces()) {
        if (!piece.moving) continue;
        // Displacement of the car until the next step. In the axes of the car, people move the opposite way.
        const Vec2 ahead = piece.velocity * world.parameters().stepTime;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double now = piece.signedDistance(positions[i]);
            const double after = piece.signedDistance(positions[i] - ahead);
            smallest_[i] = std::min({smallest_[i], now - radius, after - radius});
        }
    }
    watchMesh(world);
}

void CarWatch::watchMesh(const World& world) {
    const FormationMesh& mesh = inspect::mesh(world, 0);
    for (std::size_t v = 0; v < displaced_.size(); ++v) {
        const Vec2 wanted = mesh.userMesh()[v];
        const double moved = distance(wanted, mesh.finalMesh()[v]);
        if (moved < kRestDistance) displaced_[v] = 0;
        if (moved < kYieldDistance || displaced_[v] != 0) continue;
        displaced_[v] = 1;
        double nearest = std::numeric_limits<double>::infinity();
        for (const ObstaclePiece& piece : inspect::environment(world).pieces())
            if (piece.moving) nearest = std::min(nearest, piece.signedDistance(wanted));
        sum_ += nearest;
        ++count_;
    }
}

double CarWatch::smallest() const {
    return *std::min_element(smallest_.begin(), smallest_.end());
}

double CarWatch::meanSmallest() const {
    return std::accumulate(smallest_.begin(), smallest_.end(), 0.0) / static_cast<double>(smallest_.size());
}

std::int32_t CarWatch::nearer(double gap) const {
    return static_cast<std::int32_t>(
        std::count_if(smallest_.begin(), smallest_.end(), [gap](double smallest) { return smallest < gap; }));
}

double CarWatch::givesWayFrom() const {
    return count_ > 0 ? sum_ / static_cast<double>(count_) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace muster
