#include "lab/reproduce/experiments/encounter_watch.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::int64_t kNever = 1'000'000'000;

}  // namespace

bool rayCastInside(const Polygon& polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t k = 0, last = polygon.size() - 1; k < polygon.size(); last = k++) {
        const Vec2 a = polygon[last], b = polygon[k];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

EncounterWatch::EncounterWatch(const World& world, MotionId motion, double rearm)
    : motion_(motion), rearmSteps_(std::lround(rearm / world.parameters().stepTime)) {
    for (const PatchId id : world.patchIds())
        if (inspect::environment(world).patch(id)->motion == motion) patches_.push_back(id);
    const std::size_t count = world.characters().size();
    outside_.assign(patches_.size() * count, kNever);
    begins_.assign(count, 0);
    byCharacter_.assign(count, 0);
    look(world, true);
}

void EncounterWatch::look(const World& world, bool first) {
    const std::span<const Vec2> positions = world.characters().position;
    std::fill(begins_.begin(), begins_.end(), std::uint8_t{0});
    for (std::size_t k = 0; k < patches_.size(); ++k) {
        const Polygon polygon = inspect::environment(world).patchPolygon(patches_[k]);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            std::int64_t& outside = outside_[k * positions.size() + i];
            const bool inside = rayCastInside(polygon, positions[i]);
            if (inside && outside > rearmSteps_ && !first) begins_[i] = 1;
            outside = inside ? 0 : std::min(outside + 1, kNever);
        }
    }
}

void EncounterWatch::observe(const World& world) {
    look(world, false);
    const CharactersView characters = world.characters();
    for (std::size_t i = 0; i < characters.size(); ++i) {
        std::int32_t reported = 0;
        for (const Event& event : world.events())
            if (event.kind == EventKind::SingleStep && event.subject == characters.id[i] &&
                event.value == static_cast<std::uint32_t>(motion_))
                ++reported;
        events_ += reported;
        encounters_ += begins_[i];
        byCharacter_[i] += begins_[i];
        mismatches_ += std::abs(reported - begins_[i]);
    }
}

}  // namespace muster
