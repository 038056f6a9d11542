#include "engine/formation/places/target_separation.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "base/maths.h"
#include "engine/formation/places/ring_search.h"

namespace muster {
namespace {

constexpr int kIterations = 8;  // Number of iterations that push targets apart.
// Factor by which pairs are pushed too far, so that few iterations suffice.
constexpr double kPushFactor = 1.02;
// Number of targets in walls from which on they need room to pass.
constexpr std::ptrdiff_t kManyInWalls = 200;
constexpr std::int32_t kSearchBudget = 10000;  // Points examined on rings for all relocated targets together.

// One Jacobi iteration: pushes targets closer than `separation` apart, each by half of the missing distance.
// Examines only pairs with a target marked in `moved`, and then marks the targets that moved. False where no
// pair was too close.
bool pushApart(std::vector<Vec2>& targets, double separation, SeparationMemory& memory) {
    memory.neighbours.update(targets, separation, kTargetSkin);
    memory.push.assign(targets.size(), {});
    bool any = false;
    const double wanted = separation * kPushFactor, least = separation * kSeparationTolerance;
    for (const auto [low, high] : memory.neighbours.pairs()) {
        const Vec2 between = targets[high] - targets[low];
        if (!(lengthSquared(between) < least * least)) continue;
        if (memory.moved[low] == 0 && memory.moved[high] == 0) continue;
        const double gap = length(between);
        Vec2 direction = between / gap;
        if (!(gap > 1e-9 * separation)) {
            // Coincident targets separate in directions by the golden angle.
            const double angle = 2.399963229728653 * static_cast<double>(high);
            direction = {cosine(angle), sine(angle)};
        }
        const Vec2 half = direction * (0.5 * (wanted - gap));
        memory.push[low] -= half;
        memory.push[high] += half;
        any = true;
    }
    std::fill(memory.moved.begin(), memory.moved.end(), std::uint8_t{0});
    if (!any) return false;
    for (std::size_t k = 0; k < targets.size(); ++k) {
        const Vec2 push = memory.push[k];
        if (push.x == 0.0 && push.y == 0.0) continue;
        targets[k] += clampLength(push, separation);
        memory.moved[k] = 1;
    }
    return true;
}

// Marks with 0 every target that is too close to one of lower index marked with 1.
void markConflicts(const std::vector<Vec2>& targets, double separation, SeparationMemory& memory,
                   std::vector<std::uint8_t>& fit) {
    memory.neighbours.update(targets, separation, kTargetSkin);
    memory.conflicts.clear();
    const double least = separation * kSeparationTolerance;
    for (const NeighbourPair pair : memory.neighbours.pairs())
        if (lengthSquared(targets[pair.high] - targets[pair.low]) < least * least)
            memory.conflicts.push_back(pair);
    // Sorted in ascending order of the higher index, so that the mark of the lower one is final.
    std::sort(memory.conflicts.begin(), memory.conflicts.end(), [](NeighbourPair a, NeighbourPair b) {
        return a.high != b.high ? a.high < b.high : a.low < b.low;
    });
    for (const NeighbourPair pair : memory.conflicts)
        if (fit[pair.low] != 0) fit[pair.high] = 0;
}

// Finds free points for the targets marked 0, in ascending order, and marks them 1.
class Relocation {
public:
    Relocation(const FreeSpace& space, double separation, std::vector<Vec2>& targets,
               std::vector<std::uint8_t>& fit, SeparationMemory& memory)
        : space_(space), separation_(separation), targets_(targets), fit_(fit), memory_(memory) {}

    void run() {
        if (std::find(fit_.begin(), fit_.end(), std::uint8_t{0}) == fit_.end()) return;
        memory_.cells.sort(targets_, separation_);
        memory_.taken.clear();
        std::int32_t budget = kSearchBudget;
        for (std::size_t k = 0; k < targets_.size() && budget > 0; ++k)
            if (fit_[k] == 0) relocate(k, budget);
        flood();
        for (std::uint8_t& f : fit_) f = f != 0 ? 1 : 0;
    }

private:
    // Cells hold former points of relocated targets, which therefore are not yet marked 1.
    static constexpr std::uint8_t kRelocated = 2;

    void relocate(std::size_t k, std::int32_t& budget) {
        searchRings(targets_[k], separation_, std::numeric_limits<double>::infinity(), budget,
                    [&](Vec2 p) { return tryPoint(k, p); });
    }

    bool tryPoint(std::size_t k, Vec2 p) {
        if (isOccupied(p) || !space_.contains(p)) return false;
        memory_.taken.push_back(p);
        targets_[k] = p;
        fit_[k] = kRelocated;
        return true;
    }

    // Floods for targets that the rings did not serve.
    void flood() {
        SiteFlood& flood = memory_.flood;
        flood.begin(space_.routes(), space_.region(), kSiteSpacing * separation_);
        for (std::size_t k = 0; k < targets_.size(); ++k)
            if (fit_[k] == 0) flood.add(static_cast<std::int32_t>(k), targets_[k]);
        flood.run(static_cast<std::int32_t>(targets_.size()),
                  [&](std::int32_t k, Vec2 p) { return tryPoint(static_cast<std::size_t>(k), p); });
    }

    bool isOccupied(Vec2 p) const {
        const double least = separation_ * kSeparationTolerance, limit = least * least;
        for (const Vec2 taken : memory_.taken)
            if (lengthSquared(taken - p) < limit) return true;
        return memory_.cells.anyBeside(
            p, [&](std::int32_t k) { return fit_[k] == 1 && lengthSquared(targets_[k] - p) < limit; });
    }

    const FreeSpace& space_;
    double separation_;
    std::vector<Vec2>& targets_;
    std::vector<std::uint8_t>& fit_;
    SeparationMemory& memory_;
};

// Separates targets; false where some found no point.
bool separate(const FreeSpace& space, double separation, std::vector<Vec2>& targets,
              std::vector<std::uint8_t>& fit, SeparationMemory& memory) {
    fit.assign(targets.size(), 1);
    for (Vec2& target : targets) target = space.nearest(target);
    memory.moved.assign(targets.size(), 1);
    memory.neighbours.clear();
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        if (!pushApart(targets, separation, memory)) return true;
        for (std::size_t k = 0; k < targets.size(); ++k)
            if (memory.moved[k] != 0) targets[k] = space.nearest(targets[k]);
    }
    markConflicts(targets, separation, memory, fit);
    Relocation(space, separation, targets, fit, memory).run();
    return std::find(fit.begin(), fit.end(), std::uint8_t{0}) == fit.end();
}

}  // namespace

void separateTargets(const FreeSpace& space, double separation, std::vector<Vec2>& targets,
                     std::vector<std::uint8_t>& fit, SeparationMemory& memory) {
    const auto inWall = std::count_if(targets.begin(), targets.end(),
                                      [&](Vec2 target) { return !space.contains(target); });
    memory.asked = targets;
    if (2 * inWall > std::ssize(targets) && inWall > kManyInWalls &&
        separate(space, kLooseSpacing * separation, targets, fit, memory))
        return;
    targets = memory.asked;
    separate(space, separation, targets, fit, memory);
}

}  // namespace muster
