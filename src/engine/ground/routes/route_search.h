// A search for one route: A* (Hart, Nilsson and Raphael 1968) over the crossings between tiles, whose paths
// within tiles are found when they are needed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ground/routes/route_graph.h"

namespace muster {

/// Status of a search.
enum class RouteStatus : std::uint8_t {
    Searching,    ///< The search goes on in the next step.
    Found,        ///< There is a route.
    Unreachable,  ///< No route exists.
};

/// One search at a time, which may take several steps. Memory is reused.
class RouteSearch : private TileSource {
public:
    /// Allocates memory for searches on a ground of some size.
    void reserve();
    /// Begins a search from `from` to `to`. The route crosses no closed line, and no moving obstacle at its
    /// present position if `moving`. A start that is blocked leads to the nearest free cell, a goal that is
    /// blocked to the free cell of the start's region that is nearest to it.
    void start(RouteGraph& graph, Vec2 from, Vec2 to, std::span<const ClosedLine> closed = {},
               bool moving = false);
    /// Goes on for about `budget` operations, of some 50 ns each, and subtracts the number used from
    /// `budget`. The graph must be as it was at the start.
    RouteStatus advance(RouteGraph& graph, std::int64_t& budget);

    RouteStatus status() const { return status_; }  ///< Status after the last advance().
    /// The route, both ends included, once it is found [m].
    const std::vector<Vec2>& path() const { return path_; }
    /// Its length [m].
    double length() const { return pathLength(path_); }
    std::int64_t work() const { return work_; }  ///< Operations since the start.

private:
    // A crossing through which the search has entered a tile, or one of the two ends.
    struct Node {
        double cost = 0.0;  // Cost from the start [m]; infinite where not reached.
        std::int32_t parent = -1;
        std::int32_t tile = 0;
        std::int32_t crossing = -1;
        bool closed = false;
        bool traced = false;  // True if paths of its tile were needed.
    };
    struct Open {
        double estimate;  // Cost of the whole route [m].
        double cost;      // Cost up to the node [m].
        std::int32_t node;
        std::int32_t parent;
        bool exact;  // False where the last part may be longer than its straight line.
        friend bool operator<(const Open& a, const Open& b) {
            if (a.estimate != b.estimate) return a.estimate > b.estimate;
            if (a.node != b.node) return a.node > b.node;
            return a.parent > b.parent;
        }
    };
    // A tile that closed lines or moving obstacles change, or a neighbour of one.
    struct OwnTile {
        std::int32_t tile = 0;
        bool changed = false;
        TileComponents components;
        TileDetail detail;
        bool described = false;
    };
    static constexpr std::int32_t kGoal = 0, kStart = 1;  // Indices of nodes.

    BorderTile borderTile(std::int32_t tile) const override;
    std::ptrdiff_t ownIndex(std::int32_t tile) const;
    const OwnTile* ownTile(std::int32_t tile) const;
    OwnTile* ownTile(std::int32_t tile);
    const RouteGround& groundOf(std::int32_t tile) const;
    TileDetail& detailOf(std::int32_t tile);
    void changeTiles(std::span<const ClosedLine> closed, bool moving);
    void listChangedTiles(std::span<const ClosedLine> closed, bool moving);
    bool findEnds();
    std::optional<RouteAnchor> anchorAt(Vec2 p) const;

    std::int32_t nodeOf(std::int32_t tile, std::int32_t crossing);
    std::int32_t twinOf(std::int32_t tile, std::int32_t crossing);
    Vec2 pointOf(std::int32_t node);
    void expand(std::int32_t node);
    void offer(std::int32_t node, std::int32_t parent, double cost, bool exact);
    double exactCost(const Open& open);
    double traceFromStart(std::int32_t crossing, std::vector<Vec2>& corners);
    double traceToGoal(std::int32_t node, std::vector<Vec2>& corners);
    double lengthOf(std::int32_t node, std::int32_t to);
    void addStep(std::int32_t exit, std::int32_t entry);
    void assemble();

    RouteGraph* graph_ = nullptr;
    RouteStatus status_ = RouteStatus::Unreachable;
    RouteGround ground_;  // Ground with closed lines and moving obstacles.
    std::vector<ClosedLine> closed_;
    // Own tiles in ascending order; tiles beyond ownCount_ keep their memory.
    std::vector<OwnTile> ownTiles_;
    std::size_t ownCount_ = 0;
    // The ground on which moving obstacles changed ownTiles_: they serve all searches on it.
    struct MovingGround {
        std::uint64_t instance = 0, ground = 0, graph = 0;
        std::size_t count = 0;  // Number of own tiles.
        friend bool operator==(const MovingGround&, const MovingGround&) = default;
    };
    MovingGround movingGround_;
    TileLabeller labeller_;
    std::vector<std::int32_t> changedTiles_, neighbourTiles_;
    std::vector<BorderCrossing> found_;
    Vec2 from_, to_;               // Ends as asked [m].
    Vec2 startPoint_, goalPoint_;  // Points where the search begins and ends [m].
    RouteAnchor start_, goal_;
    TilePaths startPaths_, goalPaths_, paths_;
    std::vector<Node> nodes_;
    std::vector<std::int32_t> firstNode_;  // Per tile, index of its first node; -1 for none.
    std::vector<std::int32_t> touched_;    // Tiles with nodes.
    std::vector<Open> open_;               // Heap of open nodes.
    std::vector<Vec2> path_;
    std::vector<Vec2> corners_;
    std::vector<std::int32_t> chain_;  // Nodes of the route.
    std::int64_t work_ = 0;
};

/// Makes the whole search at once: the route from `from` to `to`, empty where there is none.
std::vector<Vec2> findRoute(RouteGraph& graph, Vec2 from, Vec2 to, std::span<const ClosedLine> closed = {},
                            bool moving = false);

}  // namespace muster
