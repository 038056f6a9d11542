#include "cost/static_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bilinear.h"
#include "cost/ground_cost.h"

namespace muster {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr double kHalfDiagonal = 0.70710678118654752;
// Steps over cells overrate true distances by up to 8 %.
constexpr float kStepShare = 0.92f;
constexpr std::int32_t kBlock = 4;      // Cells across a block in which far walls are looked for.
constexpr double kLeastRoom = -0.02;    // Straight ways may dip this far into walls, for rounding [m].
constexpr double kLeastStride = 0.12;   // Between two looks along a straight way [m].
constexpr double kInterpolated = 0.75;  // With less room than this a closer look is worth it [m].

// Distances over the eight neighbours from cells that hold 0 (two sweeps of Borgefors 1986) [cells].
void spreadDistances(std::int32_t width, std::int32_t height, std::vector<float>& value) {
    constexpr float kDiagonal = 1.41421356f;
    const auto lower = [&](std::size_t at, std::int32_t x, std::int32_t y, std::int32_t dx, std::int32_t dy) {
        const std::int32_t nx = x + dx;
        const std::int32_t ny = y + dy;
        if (nx < 0 || ny < 0 || nx >= width || ny >= height) return;
        const float step = dx != 0 && dy != 0 ? kDiagonal : 1.0f;
        value[at] = std::min(value[at], value[static_cast<std::size_t>(ny) * width + nx] + step);
    };
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * width + x;
            lower(at, x, y, -1, 0);
            lower(at, x, y, -1, -1);
            lower(at, x, y, 0, -1);
            lower(at, x, y, 1, -1);
        }
    for (std::int32_t y = height; y-- > 0;)
        for (std::int32_t x = width; x-- > 0;) {
            const std::size_t at = static_cast<std::size_t>(y) * width + x;
            lower(at, x, y, 1, 0);
            lower(at, x, y, 1, 1);
            lower(at, x, y, 0, 1);
            lower(at, x, y, -1, 1);
        }
}

}  // namespace

void StaticGround::update(const Environment& environment, double price, double radius) {
    if (seen_ == environment.staticVersion() && price_ == price && radius_ == radius &&
        grid_ == environment.grid())
        return;
    seen_ = environment.staticVersion();
    price_ = price;
    radius_ = radius;
    grid_ = environment.grid();
    ++version_;
    perCell_ = 1.0 / grid_.cell;
    slack_ = kHalfDiagonal * grid_.cell;
    const std::span<const float> clearance = environment.staticClearance();
    const std::span<const float> patch = environment.staticPatchSpeed();
    speed_.resize(patch.size());
    unit_.resize(patch.size());
    for (std::size_t k = 0; k < patch.size(); ++k) {
        speed_[k] = patch[k] < kInfinite ? patch[k] : 1.0f;
        unit_[k] = static_cast<float>(price / speed_[k]);
    }
    makeLevel(fine_, {grid_, clearance, speed_});
    makeRoom(environment);
    makeMiddle(clearance);
    makeCoarse();
}

void StaticGround::makeLevel(GroundLevel& level, const GroundRasters& rasters) {
    UnitCost& cost = level.cost;
    const auto count = static_cast<std::size_t>(rasters.grid.count());
    cost.grid = rasters.grid;
    cost.radius = radius_;
    cost.cells.assign(count, {kInfinite, kInfinite, kInfinite, kInfinite});
    cost.nodes.clear();
    far_.assign(count, kInfinite);
    priceGround(rasters, radius_, price_, 0, rasters.grid.count(), {cost.cells, far_, cost.nodes});
    cost.lowest = *std::min_element(far_.begin(), far_.end());
    if (!(cost.lowest < kInfinite)) cost.lowest = static_cast<float>(price_);
    level.clearance.resize(count);
    const auto radius = static_cast<float>(radius_);
    for (std::size_t k = 0; k < count; ++k) level.clearance[k] = rasters.clearance[k] - radius;
}

// The centre of a cell twice as wide is the corner where four ground cells meet: their means hold there.
void StaticGround::makeMiddle(std::span<const float> clearance) {
    const Grid grid{grid_.origin, 2.0 * grid_.cell, (grid_.width + 1) / 2, (grid_.height + 1) / 2};
    middle_.cost.grid = grid;
    if (open_) return;  // Nobody asks.
    middleClearance_.resize(grid.count());
    middleSpeed_.resize(middleClearance_.size());
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Cell c = grid.at(k);
        float room = 0.0f;
        float unit = 0.0f;
        for (const std::int32_t y : {2 * c.y, std::min(2 * c.y + 1, grid_.height - 1)})
            for (const std::int32_t x : {2 * c.x, std::min(2 * c.x + 1, grid_.width - 1)}) {
                room += 0.25f * clearance[grid_.index({x, y})];
                unit += 0.25f / speed_[grid_.index({x, y})];
            }
        middleClearance_[k] = room;
        middleSpeed_[k] = 1.0f / unit;
    }
    makeLevel(middle_, {grid, middleClearance_, middleSpeed_});
    middle_.uniformClearance.resize(middleClearance_.size());
    for (std::int32_t k = 0; k < grid.count(); ++k)
        middle_
            .uniformClearance[k] = fine_.uniformClearance[grid_.index({2 * grid.at(k).x, 2 * grid.at(k).y})];
}

void StaticGround::makeRoom(const Environment& environment) {
    fine_.uniformClearance = fine_.clearance;
    widenRoom();
    narrowByPatches();
    open_ = environment.obstacleIds().empty() && environment.patchIds().empty();
}

// Clearance is known up to a limit; beyond, blocks of cells tell how far it is to where it is known.
void StaticGround::widenRoom() {
    constexpr auto kLimit = static_cast<float>(Environment::kClearanceLimit);
    const float capped = kLimit - static_cast<float>(radius_) - 1e-4f;
    const std::int32_t width = (grid_.width + kBlock - 1) / kBlock;
    const std::int32_t height = (grid_.height + kBlock - 1) / kBlock;
    far_.assign(static_cast<std::size_t>(width) * height, 1e6f);
    for (std::int32_t k = 0; k < grid_.count(); ++k)
        if (fine_.uniformClearance[k] < capped)
            far_[static_cast<std::size_t>(grid_.at(k).y / kBlock) * width + grid_.at(k).x / kBlock] = 0.0f;
    spreadDistances(width, height, far_);
    const auto edge = static_cast<float>(kBlock * grid_.cell);
    for (std::int32_t k = 0; k < grid_.count(); ++k) {
        if (fine_.uniformClearance[k] < capped) continue;
        const float
            blocks = far_[static_cast<std::size_t>(grid_.at(k).y / kBlock) * width + grid_.at(k).x / kBlock];
        fine_.uniformClearance[k] += std::max(0.0f, kStepShare * blocks - 1.5f) * edge;
    }
}

// Ground is uniform up to the nearest cell beyond which it costs something else.
void StaticGround::narrowByPatches() {
    far_.assign(unit_.size(), 1e6f);
    bool any = false;
    for (std::int32_t k = 0; k < grid_.count(); ++k) {
        const Cell c = grid_.at(k);
        const bool east = c.x + 1 < grid_.width && unit_[k + 1] != unit_[k];
        const bool north = c.y + 1 < grid_.height && unit_[k + grid_.width] != unit_[k];
        if (east) far_[k] = far_[k + 1] = 0.0f;
        if (north) far_[k] = far_[k + grid_.width] = 0.0f;
        any = any || east || north;
    }
    uniform_ = !any;
    if (uniform_) return;
    spreadDistances(grid_.width, grid_.height, far_);
    const auto edge = static_cast<float>(grid_.cell);
    for (std::size_t k = 0; k < fine_.uniformClearance.size(); ++k)
        fine_.uniformClearance[k] = std::min(fine_.uniformClearance[k], (kStepShare * far_[k] - 0.5f) * edge);
}

// The cheapest of the lanes of cells that lead from the middle of one coarse cell to the middle of the next;
// infinite where none is free. A wall as thick as a character is wide closes them all.
float StaticGround::coarseEdge(Cell from, Cell step, std::int32_t ratio) const {
    float best = kInfinite;
    const Cell to{from.x + step.x, from.y + step.y};
    if (!coarse_.grid.contains(to)) return best;
    for (std::int32_t lane = 0; lane < ratio; ++lane) {
        float sum = 0.0f;
        bool even = true;
        float first = 0.0f;
        for (std::int32_t k = 0; k < ratio && sum < kInfinite; ++k) {
            const std::int32_t along = ratio / 2 + k;
            const Cell c{from.x * ratio + (step.x != 0 ? along : lane),
                         from.y * ratio + (step.y != 0 ? along : lane)};
            if (!grid_.contains(c) || fine_.blocked(grid_.index(c))) {
                sum = kInfinite;
                break;
            }
            const float unit = unit_[grid_.index(c)];
            if (k == 0) first = unit;
            even = even && unit == first;
            sum += unit;
        }
        if (sum < kInfinite) best = std::min(best, even ? first : sum / static_cast<float>(ratio));
    }
    return best;
}

// The cheapest lane from the middle of the neighbour at `step` over the border into a coarse cell; infinite
// where none is free so far.
float StaticGround::nearSide(Cell cell, Cell step, std::int32_t ratio) const {
    float best = kInfinite;
    if (!coarse_.grid.contains({cell.x + step.x, cell.y + step.y})) return best;
    // Fine cells from the one inside to the neighbour's middle.
    const std::int32_t inside = step.x + step.y > 0 ? ratio - 1 : 0;
    for (std::int32_t lane = 0; lane < ratio; ++lane) {
        float sum = 0.0f;
        const std::int32_t length = 1 + ratio / 2;
        for (std::int32_t k = 0; k < length && sum < kInfinite; ++k) {
            const Cell c{cell.x * ratio + (step.x != 0 ? inside + k * step.x : lane),
                         cell.y * ratio + (step.y != 0 ? inside + k * step.y : lane)};
            const bool free = grid_.contains(c) && !fine_.blocked(grid_.index(c));
            sum = free ? sum + unit_[grid_.index(c)] : kInfinite;
        }
        if (sum < kInfinite) best = std::min(best, sum / static_cast<float>(length));
    }
    return best;
}

// Cells with a wall in the middle. Those that can be entered from opposite sides are left out: they may
// divide two rooms.
void StaticGround::findBeside(std::int32_t ratio) {
    partiallyBlocked_.clear();
    const Grid& grid = coarse_.grid;
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Cell cell = grid.at(k);
        const Cell middle{cell.x * ratio + ratio / 2, cell.y * ratio + ratio / 2};
        if (grid_.contains(middle) && !fine_.blocked(grid_.index(middle))) continue;
        const CellCost& cost = coarse_.cells[k];
        for (const bool across : {false, true}) {
            const Cell up = across ? Cell{1, 0} : Cell{0, 1};
            const Cell down{-up.x, -up.y};
            const float high = across ? cost.east : cost.north;
            const float low = across ? cost.west : cost.south;
            if (high < kInfinite || low < kInfinite) continue;
            const float above = nearSide(cell, up, ratio);
            const float below = nearSide(cell, down, ratio);
            if ((above < kInfinite) == (below < kInfinite)) continue;
            const Cell step = above < kInfinite ? up : down;
            partiallyBlocked_.push_back({cell,
                                         {cell.x + step.x, cell.y + step.y},
                                         std::min(above, below) * static_cast<float>(grid.cell)});
        }
    }
}

void StaticGround::makeCoarse() {
    partiallyBlocked_.clear();
    std::int32_t ratio = 2;
    const auto across = [](std::int32_t cells, std::int32_t by) { return (cells + by - 1) / by; };
    while (across(grid_.width, ratio) * across(grid_.height, ratio) > kCoarseCells) ratio *= 2;
    coarse_.grid = {grid_.origin, grid_.cell * ratio, across(grid_.width, ratio),
                    across(grid_.height, ratio)};
    coarse_.radius = radius_;
    coarse_.lowest = fine_.cost.lowest;
    const Grid& grid = coarse_.grid;
    if (open_) return;
    coarse_.cells.assign(static_cast<std::size_t>(grid.count()),
                         {kInfinite, kInfinite, kInfinite, kInfinite});
    // No nodes beside walls: straight ways would be seen to lead through cells that thin walls divide.
    coarse_.nodes.clear();
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Cell c = grid.at(k);
        const float east = coarseEdge(c, {1, 0}, ratio);
        const float north = coarseEdge(c, {0, 1}, ratio);
        coarse_.cells[k].east = east;
        coarse_.cells[k].north = north;
        if (c.x + 1 < grid.width) coarse_.cells[k + 1].west = east;
        if (c.y + 1 < grid.height) coarse_.cells[k + grid.width].south = north;
    }
    findBeside(ratio);
}

double StaticGround::interpolatedClearance(Vec2 p) const {
    return between(fine_.uniformClearance, p);
}

double StaticGround::between(const std::vector<float>& room, Vec2 p) const {
    const Vec2 cells = inCells(p);
    if (!holds(cells)) return -1.0;
    const BilinearPoint at = bilinearPoint(grid_, cells.x, cells.y);
    const float* low = room.data() + grid_.index(at.low);
    const float* high = low + (grid_.height > 1 ? grid_.width : 0);
    const std::int32_t right = grid_.width > 1 ? 1 : 0;
    const double below = low[0] + (low[right] - low[0]) * at.fx;
    const double above = high[0] + (high[right] - high[0]) * at.fx;
    return below + (above - below) * at.fy;
}

double StaticGround::lineCost(Vec2 a, Vec2 b) const {
    if (uniform_) return fine_.cost.lowest * distance(a, b);
    constexpr int kSamples = 8;
    double sum = 0.0;
    for (int k = 0; k < kSamples; ++k) sum += unitCost(a + (b - a) * ((k + 0.5) / kSamples));
    return sum / kSamples * distance(a, b);
}

bool StaticGround::lineOfSight(Vec2 a, Vec2 b, double whole) const {
    if (open_) return true;
    // On slow ground a way out of it and back may be faster, unless both ends lie deep in it.
    if (!uniform_ && unitCost(b) > fine_.cost.lowest)
        return unitCost(a) == unitCost(b) && uniformClearance(a) + uniformClearance(b) >= whole;
    return reaches(fine_.uniformClearance, a, b, whole);
}

// From disc to disc of the room there is.
bool StaticGround::reaches(const std::vector<float>& rooms, Vec2 a, Vec2 b, double whole) const {
    const auto roomAt = [&](Vec2 p) {
        const std::int32_t cell = cellAt(p);
        return cell >= 0 ? static_cast<double>(rooms[cell]) - slack_ : -1.0;
    };
    // Nothing fits between two so close together, though they stand in a door too narrow for the cells to
    // show it.
    if (whole <= radius_) return true;
    // As far as the disc round the end.
    const double far = whole - std::max(roomAt(b), 0.0);
    double free = roomAt(a);
    if (free >= kInterpolated && free >= far) return true;
    const Vec2 along = (b - a) / whole;
    for (double at = 0.0; at < far;) {
        const Vec2 p = a + along * at;
        free = roomAt(p);
        if (free < kInterpolated) free = between(rooms, p);
        if (free < kLeastRoom) return false;
        at += std::max(free, kLeastStride);
    }
    return true;
}

}  // namespace muster
