#include "engine/fields/cost/static_ground.h"

#include <algorithm>

#include "engine/fields/cost/chamfer_distance.h"

namespace muster {
namespace {

constexpr double kHalfDiagonal = 0.70710678118654752;  // Half of the diagonal of a cell of edge 1.
constexpr float kFarAway = 1e6f;                       // A distance beyond all others on a grid [cells].
// Number of changed areas above which the whole ground counts as changed.
constexpr std::size_t kMaxAreas = 64;
// Half of the width by which a gap may be narrower than a diameter and still be open [m].
constexpr double kGapTolerance = 1e-7;
constexpr std::size_t kMaxChanges = 256;  // Number of changes that are remembered.

}  // namespace

void StaticGround::update(const Environment& environment, double openCost, double radius) {
    if (instance_ == environment.instance() && environmentVersion_ == environment.staticVersion() &&
        openCost_ == openCost && radius_ == radius && grid_ == environment.grid())
        return;
    const bool local = findChanges(environment, openCost, radius);
    instance_ = environment.instance();
    environmentVersion_ = environment.staticVersion();
    grid_ = environment.grid();
    radius_ = radius;
    floatRadius_ = static_cast<float>(radius);
    openCost_ = openCost;
    perCell_ = 1.0 / grid_.cell;
    halfDiagonal_ = kHalfDiagonal * grid_.cell;
    capped_ = static_cast<float>(Environment::kClearanceLimit) - floatRadius_ - 1e-4f;
    clearance_ = environment.staticClearance();
    patchSpeed_ = environment.staticPatchSpeed();
    open_ = environment.obstacleIds().empty() && environment.patchIds().empty();
    const float lowest = lowest_;
    if (!local || patchVersion_ != environment.staticPatchVersion()) updatePatches();
    patchVersion_ = environment.staticPatchVersion();
    ++version_;
    noteChanges(!local || lowest != lowest_);
    if (!local) {
        distant_.reset(grid_);
        gaps_.reset(environment, 2.0 * (radius - kGapTolerance));
        narrow_.reset(radius);
        resetCoarse();
    }
    for (const CellRect& area : areas_) {
        distant_.update(clearance_, area);
        gaps_.update(environment, area);
        narrow_.update(environment, gaps_, area);
        updateCoarse(area);
    }
}

// Lists the changed areas; false where all may have changed.
bool StaticGround::findChanges(const Environment& environment, double openCost, double radius) {
    areas_.clear();
    const bool known = instance_ == environment.instance() && openCost_ == openCost && radius_ == radius &&
                       grid_ == environment.grid() && open_ == false &&
                       environment.staticChangesSince(environmentVersion_, areas_) &&
                       areas_.size() <= kMaxAreas;
    const Grid& grid = environment.grid();
    if (!known) areas_.assign(1, {{0, 0}, {grid.width - 1, grid.height - 1}});
    return known;
}

void StaticGround::noteChanges(bool all) {
    if (all || changes_.size() > kMaxChanges) {
        changes_.clear();
        changesFrom_ = version_ - (all ? 0 : 1);
    }
    if (all) return;
    for (const CellRect& area : areas_) changes_.push_back({version_, area});
}

bool StaticGround::changesSince(std::uint32_t version, std::vector<CellRect>& areas) const {
    if (version < changesFrom_ || version > version_) return false;
    for (const Change& change : changes_)
        if (change.version > version) areas.push_back(change.area);
    return true;
}

// Computes the unit cost, its lowest value, and the distance to the nearest cell with a neighbour of another
// unit cost.
void StaticGround::updatePatches() {
    const std::int32_t count = grid_.count();
    unit_.clear();
    toOtherGround_.clear();
    lowest_ = static_cast<float>(openCost_ / travelSpeed(0));
    const auto differs = [&](std::int32_t cell) { return travelSpeed(cell) != travelSpeed(0); };
    std::int32_t first = patchSpeed_.isConstant() ? count : 0;
    while (first < count && !differs(first)) ++first;
    if (first == count) {
        unit_.shrink_to_fit();
        toOtherGround_.shrink_to_fit();
        return;
    }
    unit_.resize(count);
    for (std::int32_t k = 0; k < count; ++k) unit_[k] = static_cast<float>(openCost_ / travelSpeed(k));
    lowest_ = *std::min_element(unit_.begin(), unit_.end());
    toOtherGround_.assign(count, kFarAway);
    std::vector<float>& border = toOtherGround_;
    for (std::int32_t k = 0; k < count; ++k) {
        const Cell c = grid_.at(k);
        if (c.x + 1 < grid_.width && unit_[k + 1] != unit_[k]) border[k] = border[k + 1] = 0.0f;
        if (c.y + 1 < grid_.height && unit_[k + grid_.width] != unit_[k])
            border[k] = border[k + grid_.width] = 0.0f;
    }
    chamferDistance(grid_.width, grid_.height, border);
    const auto edge = static_cast<float>(grid_.cell);
    for (float& value : border) value = (kChamferLowerBound * value - 0.5f) * edge;
}

}  // namespace muster
