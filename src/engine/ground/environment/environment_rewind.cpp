// The rasters of an environment that goes back to an earlier state.
#include <utility>

#include "engine/ground/environment/environment_impl.h"

namespace muster {
namespace {

// Number of obstacles or patches that differ above which all is made again.
constexpr std::int32_t kMostDifferences = 64;

/// The differences of two lists of obstacles or patches.
struct Differences {
    std::int32_t count = 0;
    bool still = false;  ///< True if a static obstacle or patch differs.
};

/// Calls `visit(entry)` for the entries of both lists that the other list lacks, or has with another
/// definition. Both ascend by ids.
template <class Id, class Entry, class Visit>
Differences forDifferences(const std::vector<Id>& idsA, const std::vector<Entry>& a,
                           const std::vector<Id>& idsB, const std::vector<Entry>& b, const Visit& visit) {
    Differences found;
    const auto differs = [&](const Entry& entry) {
        ++found.count;
        found.still = found.still || entry.def.path.still();
        visit(entry);
    };
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        const bool onlyA = j == b.size() || (i < a.size() && idsA[i] < idsB[j]);
        const bool onlyB = !onlyA && (i == a.size() || idsB[j] < idsA[i]);
        if (onlyA || onlyB) {
            differs(onlyA ? a[i++] : b[j++]);
            continue;
        }
        if (!(a[i].def == b[j].def)) {
            differs(a[i]);
            differs(b[j]);
        }
        ++i;
        ++j;
    }
    return found;
}

bool sameFrame(const EnvironmentDef& a, const EnvironmentDef& b) {
    return a.box.min == b.box.min && a.box.max == b.box.max && a.cell == b.cell && a.ring == b.ring &&
           a.clips == b.clips;
}

}  // namespace

void Environment::keepCachesOf(Environment& before) {
    Impl& now = *impl_;
    Impl& old = *before.impl_;
    const auto compare = [&](const auto& visit) {
        const Differences o = forDifferences(old.obstacleIds, old.obstacles, now.obstacleIds, now.obstacles,
                                             visit);
        const Differences p = forDifferences(old.patchIds, old.patches, now.patchIds, now.patches, visit);
        return std::pair(o, p);
    };
    const auto [obstacles, patches] = compare([](const auto&) {});
    if (!sameFrame(old.def, now.def) || obstacles.count + patches.count > kMostDifferences) {
        // Callers that know an old version must see that the ground changed.
        now.groundVersion = old.groundVersion + 1;
        now.staticVersion = now.staticEditsFrom = old.staticVersion + 1;
        now.stale = true;
        return;
    }
    if (obstacles.count + patches.count > 0) {
        compare([&](const auto& entry) { old.markDirty(entry); });
        old.countEdit(obstacles.still || patches.still);
        old.stale = true;
    }
    if (obstacles.count > 0) {
        old.obstacleIds = std::move(now.obstacleIds);
        old.obstacles = std::move(now.obstacles);
        old.piecesStale = true;
    }
    if (patches.count > 0) {
        old.patchIds = std::move(now.patchIds);
        old.patches = std::move(now.patches);
        old.patchPiecesStale = true;
    }
    old.nextObstacle = now.nextObstacle;
    old.nextPatch = now.nextPatch;
    before.setFieldDefaults(now.def.defaultRange, now.def.defaultStrength);
    before.setTime(now.time);
    std::swap(impl_, before.impl_);
}

}  // namespace muster
