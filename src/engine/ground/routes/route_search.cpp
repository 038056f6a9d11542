#include "engine/ground/routes/route_search.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/ground/routes/nearest_cell.h"

namespace muster {
namespace {

// Factor of the estimates of the remaining length, which makes searches several times faster. Routes over
// crossings are longer than taut ones by about as much.
constexpr double kStretch = 1.05;
// Operations counted for a line, for the paths of a tile and for the crossings of a tile.
constexpr std::int64_t kLineWork = 6, kPathsWork = 1500, kTileWork = 100;
constexpr std::size_t kReserved = 4096;  // Number of entries for which a search has memory from the first.

}  // namespace

void RouteSearch::reserve() {
    open_.reserve(kReserved);
    nodes_.reserve(kReserved);
    for (auto* points : {&path_, &corners_}) points->reserve(kReserved / 8);
    for (auto* list : {&touched_, &chain_, &changedTiles_, &neighbourTiles_}) list->reserve(kReserved / 8);
    for (TilePaths* paths : {&startPaths_, &goalPaths_, &paths_}) paths->reserve();
}

void RouteSearch::start(RouteGraph& graph, Vec2 from, Vec2 to, std::span<const ClosedLine> closed,
                        bool moving) {
    graph.trim();
    graph_ = &graph;
    reserve();
    closed_.assign(closed.begin(), closed.end());
    moving = moving && !graph.environment().movingObstacleAreas().empty();
    ground_ = RouteGround(graph.environment(), graph.radius(), closed_, moving);
    from_ = from;
    to_ = to;
    path_.clear();
    open_.clear();
    work_ = 0;
    startPaths_.clear();
    goalPaths_.clear();
    if (std::cmp_not_equal(firstNode_.size(), graph.tiles().count()))
        firstNode_.assign(graph.tiles().count(), -1);
    for (const std::int32_t tile : touched_)
        if (std::cmp_less(tile, firstNode_.size())) firstNode_[tile] = -1;
    touched_.clear();
    nodes_.assign(2, {});
    nodes_[kGoal].cost = kInfiniteCost;
    status_ = RouteStatus::Unreachable;
    if (!isFinite(from) || !isFinite(to) || graph.tiles().count() == 0) return;
    if (ground_.lineClear(from, to)) {
        path_.assign({from, to});
        status_ = RouteStatus::Found;
        return;
    }
    changeTiles(closed, moving);
    if (!findEnds()) return;
    nodes_[kStart] = {0.0, -1, start_.tile, -1, true};
    status_ = RouteStatus::Searching;
    expand(kStart);
}

// Lists the tiles that closed lines or moving obstacles meet, and these with their neighbours, both
// ascending.
void RouteSearch::listChangedTiles(std::span<const ClosedLine> closed, bool moving) {
    const TileGrid& tiles = graph_->tiles();
    changedTiles_.clear();
    const auto change = [&](const CellRect& cells) {
        const CellRect rect = tiles.tilesOf(cells);
        for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y)
            for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x)
                changedTiles_.push_back(y * tiles.width + x);
    };
    for (const ClosedLine& line : closed) {
        const Box box{{std::min(line.a.x, line.b.x), std::min(line.a.y, line.b.y)},
                      {std::max(line.a.x, line.b.x), std::max(line.a.y, line.b.y)}};
        change(CellRect::touching(tiles.cells, box.grown(tiles.cells.cell)));
    }
    if (moving)
        for (const CellRect& area : graph_->environment().movingObstacleAreas()) change(area);
    const auto unique = [](std::vector<std::int32_t>& list) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    unique(changedTiles_);
    neighbourTiles_ = changedTiles_;
    for (const std::int32_t tile : changedTiles_)
        for (std::int32_t d = 0; d < kDirections; ++d)
            if (const std::int32_t other = tiles.neighbour(tile, d); other >= 0)
                neighbourTiles_.push_back(other);
    unique(neighbourTiles_);
}

// Changed tiles get components of their own; they and their neighbours get crossings of their own.
void RouteSearch::changeTiles(std::span<const ClosedLine> closed, bool moving) {
    ownCount_ = 0;
    if (closed.empty() && !moving) return;
    const Environment& environment = graph_->environment();
    MovingGround ground{environment.instance(), environment.groundVersion(), graph_->version(),
                        movingGround_.count};
    if (closed.empty() && ground == movingGround_) {
        ownCount_ = movingGround_.count;
        return;
    }
    listChangedTiles(closed, moving);
    ownCount_ = neighbourTiles_.size();
    while (ownTiles_.size() < ownCount_) ownTiles_.emplace_back().detail.reserve();
    for (std::size_t k = 0; k < ownCount_; ++k) {
        OwnTile& own = ownTiles_[k];
        own.tile = neighbourTiles_[k];
        own.changed = std::binary_search(changedTiles_.begin(), changedTiles_.end(), own.tile);
        own.described = false;
        if (own.changed) labeller_.run(ground_, graph_->tiles().cellsOf(own.tile), own.components);
    }
    ground.count = ownCount_;
    movingGround_ = closed.empty() ? ground : MovingGround{};
}

std::ptrdiff_t RouteSearch::ownIndex(std::int32_t tile) const {
    const auto end = ownTiles_.begin() + static_cast<std::ptrdiff_t>(ownCount_);
    const auto at = std::lower_bound(ownTiles_.begin(), end, tile,
                                     [](const OwnTile& own, std::int32_t t) { return own.tile < t; });
    return at != end && at->tile == tile ? at - ownTiles_.begin() : -1;
}

const RouteSearch::OwnTile* RouteSearch::ownTile(std::int32_t tile) const {
    const std::ptrdiff_t at = ownIndex(tile);
    return at >= 0 ? &ownTiles_[at] : nullptr;
}

RouteSearch::OwnTile* RouteSearch::ownTile(std::int32_t tile) {
    const std::ptrdiff_t at = ownIndex(tile);
    return at >= 0 ? &ownTiles_[at] : nullptr;
}

BorderTile RouteSearch::borderTile(std::int32_t tile) const {
    const OwnTile* const own = ownTile(tile);
    if (own != nullptr && own->changed) return {graph_->tiles().cellsOf(tile), &own->components};
    return graph_->borderTile(tile);
}

const RouteGround& RouteSearch::groundOf(std::int32_t tile) const {
    return ownTile(tile) != nullptr ? ground_ : graph_->ground();
}

TileDetail& RouteSearch::detailOf(std::int32_t tile) {
    OwnTile* const own = ownTile(tile);
    if (own == nullptr) return graph_->detail(tile);
    if (!own->described) {
        describeTile(ground_, graph_->tiles(), tile, *this, found_, own->detail);
        own->described = true;
    }
    return own->detail;
}

std::optional<RouteAnchor> RouteSearch::anchorAt(Vec2 p) const {
    return anchorOf(ground_, p, [&](Cell c, std::int32_t& tile) {
        tile = graph_->tiles().tileOf(c);
        return borderTile(tile).components->at(TileGrid::localOf(c));
    });
}

// Finds the ends; false where one end has no ground, or the ends lie in different regions.
bool RouteSearch::findEnds() {
    std::optional<RouteAnchor> start = anchorAt(from_);
    if (!start) start = anchorAt(graph_->nearestReachable(from_, -1));
    if (!start) return false;
    std::optional<RouteAnchor> goal = anchorAt(to_);
    if (!goal) {
        const std::int32_t region = graph_->region(start->point);
        goal = anchorAt(graph_->nearestReachable(to_, region));
    }
    if (!goal) return false;
    start_ = *start;
    goal_ = *goal;
    startPoint_ = ground_.lineClear(from_, start_.point) ? from_ : start_.point;
    goalPoint_ = ground_.lineClear(to_, goal_.point) ? to_ : goal_.point;
    const bool changed = ownCount_ > 0;
    return changed ||
           graph_->regionOf(start_.tile, start_.component) == graph_->regionOf(goal_.tile, goal_.component);
}

std::int32_t RouteSearch::nodeOf(std::int32_t tile, std::int32_t crossing) {
    if (firstNode_[tile] < 0) {
        const std::size_t count = detailOf(tile).crossings.size();
        firstNode_[tile] = static_cast<std::int32_t>(nodes_.size());
        touched_.push_back(tile);
        work_ += kTileWork;
        for (std::size_t k = 0; k < count; ++k)
            nodes_.push_back({kInfiniteCost, -1, tile, static_cast<std::int32_t>(k), false});
    }
    return firstNode_[tile] + crossing;
}

// The node on the other side of a crossing.
std::int32_t RouteSearch::twinOf(std::int32_t tile, std::int32_t crossing) {
    const TileDetail& detail = detailOf(tile);
    const std::int32_t d = detail.crossings[crossing].direction;
    const std::int32_t other = graph_->tiles().neighbour(tile, d);
    const std::int32_t back = (d + kDirections / 2) % kDirections;
    return nodeOf(other, detailOf(other).first[back] + crossing - detail.first[d]);
}

Vec2 RouteSearch::pointOf(std::int32_t node) {
    if (node == kGoal) return goalPoint_;
    if (node == kStart) return startPoint_;
    const Node& n = nodes_[node];
    return detailOf(n.tile).crossings[n.crossing].point;
}

void RouteSearch::offer(std::int32_t node, std::int32_t parent, double cost, bool exact) {
    ++work_;
    Node& n = nodes_[node];
    if (n.closed || !(cost < n.cost)) return;
    if (exact) n.cost = cost;
    const double left = node == kGoal ? 0.0 : kStretch * distance(pointOf(node), goalPoint_);
    open_.push_back({cost + left, cost, node, parent, exact});
    std::push_heap(open_.begin(), open_.end());
}

// Offers all nodes to which the tile of a node leads, at the cost of straight lines where no other is known.
void RouteSearch::expand(std::int32_t node) {
    const Node n = nodes_[node];
    const Vec2 point = pointOf(node);
    const TileDetail& detail = detailOf(n.tile);
    const std::int32_t component = node == kStart ? start_.component : detail.crossings[n.crossing].component;
    for (std::int32_t k = 0; std::cmp_less(k, detail.crossings.size()); ++k) {
        const TileCrossing& crossing = detail.crossings[k];
        if (crossing.component != component || k == n.crossing) continue;
        const std::int32_t twin = twinOf(n.tile, k);
        const double step = distance(crossing.point, pointOf(twin));
        // Memory of earlier searches in the tile must not show in this one, so the line is offered even where
        // the path is known.
        offer(twin, node, n.cost + distance(point, crossing.point) + step, detail.open && node != kStart);
    }
    if (n.tile == goal_.tile && component == goal_.component)
        offer(kGoal, node, n.cost + distance(point, goalPoint_), false);
}

double RouteSearch::lengthOf(std::int32_t node, std::int32_t to) {
    Node& n = nodes_[node];
    TileDetail& detail = detailOf(n.tile);
    const RouteGround& ground = groundOf(n.tile);
    const Vec2 a = detail.crossings[n.crossing].point, b = detail.crossings[to].point;
    work_ += kLineWork;
    if (detail.open) return distance(a, b);
    TileDetail::Edge& edge = detail.edges[n.crossing * detail.crossings.size() + to];
    if (edge.length < 0.0 && ground.lineClear(a, b)) edge.length = distance(a, b);
    if (edge.length < 0.0) describePaths(ground, borderTile(n.tile), n.crossing, paths_, corners_, detail);
    // Paths that are not straight count once per node, whether or not the tile knew them.
    if (!n.traced && edge.length != distance(a, b)) {
        n.traced = true;
        work_ += kPathsWork;
    }
    return edge.length;
}

double RouteSearch::traceFromStart(std::int32_t crossing, std::vector<Vec2>& corners) {
    corners.clear();
    const RouteGround& ground = groundOf(start_.tile);
    TileDetail& detail = detailOf(start_.tile);
    const TileCrossing& to = detail.crossings[crossing];
    work_ += kLineWork;
    if (ground.lineClear(startPoint_, to.point)) return distance(startPoint_, to.point);
    if (!startPaths_.known()) {
        work_ += kPathsWork;
        startPaths_.run(ground, borderTile(start_.tile), start_.cell, detail.steps);
    }
    return startPaths_.trace(ground, startPoint_, to.cell, to.point, corners);
}

// Traces the path from a node of the goal's tile; the search in the tile begins at the goal.
double RouteSearch::traceToGoal(std::int32_t node, std::vector<Vec2>& corners) {
    corners.clear();
    const RouteGround& ground = groundOf(goal_.tile);
    TileDetail& detail = detailOf(goal_.tile);
    const Vec2 from = pointOf(node);
    const Cell cell = node == kStart ? start_.cell : detail.crossings[nodes_[node].crossing].cell;
    work_ += kLineWork;
    if (ground.lineClear(from, goalPoint_)) return distance(from, goalPoint_);
    if (!goalPaths_.known()) {
        work_ += kPathsWork;
        goalPaths_.run(ground, borderTile(goal_.tile), goal_.cell, detail.steps);
    }
    const double length = goalPaths_.trace(ground, goalPoint_, cell, from, corners);
    std::reverse(corners.begin(), corners.end());
    return length;
}

double RouteSearch::exactCost(const Open& open) {
    const double before = nodes_[open.parent].cost;
    if (open.node == kGoal) return before + traceToGoal(open.parent, corners_);
    // The crossing through which the parent's tile is left.
    const std::int32_t exit = twinOf(nodes_[open.node].tile, nodes_[open.node].crossing);
    const std::int32_t crossing = exit - firstNode_[nodes_[open.parent].tile];
    const double step = distance(pointOf(exit), pointOf(open.node));
    if (open.parent == kStart) return before + traceFromStart(crossing, corners_) + step;
    return before + lengthOf(open.parent, crossing) + step;
}

RouteStatus RouteSearch::advance(RouteGraph& graph, std::int64_t& budget) {
    graph_ = &graph;
    if (status_ != RouteStatus::Searching) return status_;
    const std::int64_t begin = work_;
    while (work_ - begin < budget && status_ == RouteStatus::Searching) {
        ++work_;
        if (open_.empty()) {
            status_ = RouteStatus::Unreachable;
            break;
        }
        Open at = open_.front();
        std::pop_heap(open_.begin(), open_.end());
        open_.pop_back();
        if (nodes_[at.node].closed || at.cost > nodes_[at.node].cost) continue;
        if (!at.exact) {
            const double exact = exactCost(at);
            if (exact > at.cost * (1.0 + 1e-12)) {
                if (exact < kInfiniteCost) offer(at.node, at.parent, exact, true);
                continue;
            }
        }
        Node& node = nodes_[at.node];
        node.cost = at.cost;
        node.parent = at.parent;
        node.closed = true;
        if (at.node == kGoal) {
            assemble();
            status_ = RouteStatus::Found;
        } else {
            expand(at.node);
        }
    }
    budget -= work_ - begin;
    return status_;
}

// The step between the two cells of a crossing.
void RouteSearch::addStep(std::int32_t exit, std::int32_t entry) {
    const Vec2 a = pointOf(exit), b = pointOf(entry);
    path_.push_back(a);
    const auto cellOf = [&](std::int32_t node) {
        return detailOf(nodes_[node].tile).crossings[nodes_[node].crossing].cell;
    };
    if (const std::optional<Vec2> over = ground_.stepPoint(cellOf(exit), a, cellOf(entry), b))
        path_.push_back(*over);
    path_.push_back(b);
}

// Follows the parents back from the goal and joins the paths within the tiles.
void RouteSearch::assemble() {
    std::vector<std::int32_t>& chain = chain_;
    chain.clear();
    for (std::int32_t node = kGoal; node >= 0; node = nodes_[node].parent) chain.push_back(node);
    std::reverse(chain.begin(), chain.end());
    path_.assign(1, startPoint_);
    for (std::size_t k = 1; k < chain.size(); ++k) {
        const std::int32_t from = chain[k - 1], to = chain[k];
        if (to == kGoal) {
            traceToGoal(from, corners_);
            path_.insert(path_.end(), corners_.begin(), corners_.end());
            path_.push_back(goalPoint_);
            break;
        }
        const std::int32_t exit = twinOf(nodes_[to].tile, nodes_[to].crossing);
        const std::int32_t crossing = nodes_[exit].crossing;
        if (from == kStart) {
            traceFromStart(crossing, corners_);
            path_.insert(path_.end(), corners_.begin(), corners_.end());
        } else if (const TileDetail& detail = detailOf(nodes_[from].tile); !detail.open) {
            const TileDetail::Edge&
                edge = detail.edges[nodes_[from].crossing * detail.crossings.size() + crossing];
            const auto first = detail.corners.begin() + edge.first;
            path_.insert(path_.end(), first, first + edge.count);
        }
        addStep(exit, to);
    }
    pullTaut(ground_, path_, corners_);
    work_ += kLineWork * static_cast<std::int64_t>(chain.size());
    if (!(path_.front() == from_)) path_.insert(path_.begin(), from_);
}

std::vector<Vec2> findRoute(RouteGraph& graph, Vec2 from, Vec2 to, std::span<const ClosedLine> closed,
                            bool moving) {
    RouteSearch search;
    search.start(graph, from, to, closed, moving);
    std::int64_t budget = std::numeric_limits<std::int64_t>::max();
    search.advance(graph, budget);
    return search.path();
}

}  // namespace muster
