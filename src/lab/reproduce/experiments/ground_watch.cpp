#include "lab/reproduce/experiments/ground_watch.h"

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "lab/reproduce/experiments/samples.h"

#include <algorithm>

namespace muster {
GroundWatch::GroundWatch(const World& world) : stepTime_(world.parameters().stepTime) {
    const CharactersView characters = world.characters();
    position_.assign(characters.position.begin(), characters.position.end());
    for (const Vec2 p : position_) ground_.push_back(inspect::environment(world).ground(p).motion);
    tallies_.resize(inspect::environment(world).def().clips.size());
    for (Tally& tally : tallies_) tally.visited.assign(characters.size(), 0);
}

void GroundWatch::observe(const World& world) {
    const CharactersView characters = world.characters();
    for (std::size_t i = 0; i < position_.size(); ++i) {
        const MotionId now = inspect::environment(world).ground(characters.position[i]).motion;
        Tally& tally = tallies_[now];
        tally.visited[i] = 1;
        if (now == ground_[i]) {
            ++tally.steps;
            if (characters.motion[i] != now) ++tally.wrong;
            tally.metres += distance(characters.position[i], position_[i]);
        }
        position_[i] = characters.position[i];
        ground_[i] = now;
    }
}

double GroundWatch::seconds(MotionId motion) const {
    return static_cast<double>(tallies_[motion].steps) * stepTime_;
}

double GroundWatch::metres(MotionId motion) const {
    return tallies_[motion].metres;
}

double GroundWatch::speed(MotionId motion) const {
    const double time = seconds(motion);
    return time > 0.0 ? metres(motion) / time : kNothing;
}

std::int32_t GroundWatch::visitors(MotionId motion) const {
    const std::vector<std::uint8_t>& visited = tallies_[motion].visited;
    return static_cast<std::int32_t>(std::count(visited.begin(), visited.end(), std::uint8_t{1}));
}

double GroundWatch::wrongShare(MotionId motion) const {
    const Tally& tally = tallies_[motion];
    return tally.steps > 0 ? static_cast<double>(tally.wrong) / static_cast<double>(tally.steps) : kNothing;
}

}  // namespace muster
