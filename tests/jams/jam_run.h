// Runs a jam and measures it as `muster play` does.
#pragma once

#include "engine/world/metrics.h"
#include "jams/jam_scene.h"

namespace muster::testing {

/// What came of a run.
struct JamRun {
    double last = -1.0;  ///< Seconds after the last command until all stand in place; -1: not all.
    std::vector<std::int32_t> through;  ///< Characters by passage.
};

/// Counts who crosses the wall where. The wall's middle line lies along the first passage.
class PassageWatch {
public:
    explicit PassageWatch(const JamScene& scene)
        : scene_(scene),
          along_(normalized(scene.passages[0].b - scene.passages[0].a)),
          counts_(scene.passages.size(), 0) {}

    void observe(const World& world) {
        const std::span<const Vec2> positions = world.characters().position;
        crossed_.resize(positions.size(), false);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Vec2 at = positions[i] - scene_.passages[0].a;
            if (crossed_[i] || cross(along_, at) * cross(along_, scene_.shift) < 0.0) continue;
            crossed_[i] = true;
            ++counts_[passageAt(dot(along_, at))];
        }
    }
    const std::vector<std::int32_t>& counts() const { return counts_; }

private:
    std::size_t passageAt(double along) const {
        std::size_t best = 0;
        double least = 1e9;
        for (std::size_t p = 0; p < counts_.size(); ++p) {
            const Vec2 middle = lerp(scene_.passages[p].a, scene_.passages[p].b, 0.5) - scene_.passages[0].a;
            const double away = std::fabs(dot(along_, middle) - along) - 0.5 * scene_.passages[p].width();
            if (away < least) {
                least = away;
                best = p;
            }
        }
        return best;
    }

    const JamScene& scene_;
    Vec2 along_;
    std::vector<std::int32_t> counts_;
    std::vector<bool> crossed_;
};

/// Plays the scene until all stand in place, at most `longest` [s] after the last command.
inline JamRun runJam(const JamScene& scene, double longest = 90.0) {
    World world = World::create(scene.def).value();
    RunMetrics metrics(world);
    PassageWatch watch(scene);
    const double end = scene.commands.back().step * scene.def.parameters.stepTime;
    std::size_t next = 0;
    while (world.time() < end + longest) {
        while (next < scene.commands.size() && scene.commands[next].step <= world.stepCount())
            (void)world.submit(scene.commands[next++]);
        world.step();
        metrics.observe(world);
        watch.observe(world);
        if (next == scene.commands.size() && world.stepCount() % 30 == 0 && metrics.settled(world)) break;
    }
    return {metrics.figures(world, false).arrived100, watch.counts()};
}

}  // namespace muster::testing
