// What going back costs: eight steps, a rewind to before them, and the same eight steps again.
#pragma once

#include <cstdint>
#include <string>

#include "muster/status.h"
#include "scale/crowd_scenes.h"

namespace muster::scale {

/// How rewinds are measured.
struct RewindDef {
    SceneDef scene{"block", Regime::Tracking, 360, 1, "../shared/maps"};  ///< Scene, size and seed.
    double seconds = 12.0;                                                ///< World time [s], 1 to 600.
    bool edits = false;  ///< A building is added in the fourth of each eight steps.
};

/// CPU times of the thread, over all windows of eight steps but the first two seconds' [ms].
struct RewindRow {
    std::int32_t windows = 0;  ///< Their number.
    double first50 = 0.0;      ///< Median of the first eight steps.
    double again50 = 0.0;      ///< Median of the rewind and the eight steps after it.
    double ratio50 = 0.0;      ///< Median of the second over the first.
    double ratio95 = 0.0;      ///< 95th percentile.
    double over95 = 0.0;       ///< 95th percentile of the second less 1.25 times the first.
    double rewind50 = 0.0;     ///< Median of the rewind alone.
    double rewind95 = 0.0;     ///< 95th percentile.
    double snapshot50 = 0.0;   ///< Median of a snapshot.
    double restored50 = 0.0;   ///< Median of World::restore and the eight steps after it.
    double restored95 = 0.0;   ///< 95th percentile.
    std::size_t bytes = 0;     ///< Of the last snapshot.
    std::uint64_t hash = 0;    ///< Of the last state.
};

/// Runs the scene with one thread. Fails where it cannot be made, or where a hash after a rewind or a restore
/// differs from the first.
Result<RewindRow> measureRewind(const RewindDef& def);
/// The row in words.
std::string rewindText(const RewindDef& def, const RewindRow& row);

}  // namespace muster::scale
