// The quickest flow of a crowd through the passages of a wall: a bound on the last arrival, by LEMON's
// maximum flow on a network over time. It knows nothing of Muster's plans.
#pragma once

#if __has_include(<lemon/preflow.h>)
#define MUSTER_HAS_LEMON 1
#include <lemon/preflow.h>
#include <lemon/smart_graph.h>
#else
#define MUSTER_HAS_LEMON 0
#endif

#include <algorithm>
#include <cmath>
#include <vector>

#include "jams/jam_scene.h"
#include "jams/visibility_graph.h"

#if MUSTER_HAS_LEMON

namespace muster::testing {

inline constexpr double kFlowPerMetre = 4.5;  ///< Characters a second and metre of clear width.
inline constexpr double kWalkingSpeed = 2.0;  ///< [m/s]

/// Times of walks between all characters or goals and all passages [s].
struct PassageWalks {
    std::vector<std::vector<double>> to;    ///< By passage and character.
    std::vector<std::vector<double>> from;  ///< By passage and goal.
};

/// Walks are measured to the nearest of a few points across the passage, so they are never too long.
inline std::vector<double> walksTo(const VisibilityGraph& graph, const JamPassage& passage, double radius,
                                   const std::vector<Vec2>& points) {
    constexpr int kPoints = 5;
    std::vector<double> least(points.size(), 1e9);
    const Vec2 inward = normalized(passage.b - passage.a) * radius;
    for (int k = 0; k < kPoints; ++k) {
        const Vec2 via = lerp(passage.a + inward, passage.b - inward, k / (kPoints - 1.0));
        const std::vector<double> lengths = graph.lengthsFrom(via);
        for (std::size_t i = 0; i < points.size(); ++i)
            least[i] = std::min(least[i], graph.lengthTo(points[i], via, lengths) / kWalkingSpeed);
    }
    return least;
}

/// True where all can be in place at `time` [s] after they set out. Passage p lets one character through at
/// each multiple of 1 / (4.5 width): a slot. A character may wait before its slot and after it.
inline bool allArriveBy(double time, const JamScene& scene, const PassageWalks& walks) {
    using Graph = lemon::SmartDigraph;
    const int people = static_cast<int>(walks.to.front().size());
    Graph graph;
    Graph::ArcMap<int> capacity(graph);
    const auto connect = [&](Graph::Node a, Graph::Node b, int most) { capacity[graph.addArc(a, b)] = most; };
    const Graph::Node source = graph.addNode(), sink = graph.addNode();
    std::vector<Graph::Node> goals;
    std::vector<Graph::Node> characters;
    for (int i = 0; i < people; ++i) {
        characters.push_back(graph.addNode());
        goals.push_back(graph.addNode());
        connect(source, characters[i], 1);
        connect(goals[i], sink, 1);
    }
    for (std::size_t p = 0; p < scene.passages.size(); ++p) {
        const double rate = kFlowPerMetre * scene.passages[p].width();
        const int slots = static_cast<int>(time * rate) + 1;
        std::vector<Graph::Node> before, after;
        for (int s = 0; s < slots; ++s) {
            before.push_back(graph.addNode());
            after.push_back(graph.addNode());
            connect(before[s], after[s], 1);
            if (s > 0) connect(before[s - 1], before[s], people);
            if (s > 0) connect(after[s - 1], after[s], people);
        }
        for (int i = 0; i < people; ++i) {
            const double arrives = std::ceil(walks.to[p][i] * rate);
            if (arrives < slots) connect(characters[i], before[static_cast<int>(arrives)], 1);
            const double latest = std::floor((time - walks.from[p][i]) * rate);
            if (latest >= 0.0) connect(after[std::min(slots - 1, static_cast<int>(latest))], goals[i], 1);
        }
    }
    lemon::Preflow<Graph, Graph::ArcMap<int>> flow(graph, capacity, source, sink);
    flow.runMinCut();
    return flow.flowValue() == people;
}

/// Seconds from setting out until the last can be in place, to 0.02 s.
inline double quickestFlow(const JamScene& scene, const std::vector<Vec2>& starts) {
    const VisibilityGraph graph(scene.def.obstacles);
    std::vector<Vec2> goals;
    for (const Vec2 p : starts) goals.push_back(p + scene.shift);
    PassageWalks walks;
    for (const JamPassage& passage : scene.passages) {
        const double radius = scene.def.parameters.character.radius;
        walks.to.push_back(walksTo(graph, passage, radius, starts));
        walks.from.push_back(walksTo(graph, passage, radius, goals));
    }
    double low = 0.0, high = 400.0;
    while (high - low > 0.02) {
        const double middle = 0.5 * (low + high);
        (allArriveBy(middle, scene, walks) ? high : low) = middle;
    }
    return high;
}

/// Seconds after the last command, as runs are measured.
inline double quickestFlowAfterCommands(const JamScene& scene, const std::vector<Vec2>& starts) {
    const double last = scene.commands.back().step * scene.def.parameters.stepTime;
    return quickestFlow(scene, starts) - (last - scene.start);
}

}  // namespace muster::testing

#endif
