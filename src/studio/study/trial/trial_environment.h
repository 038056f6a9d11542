// The environments of the study (SPEC X12; paper section 7.5, figure 11), and their worlds.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "muster/status.h"
#include "muster/world.h"
#include "studio/gestures/input_event.h"

namespace muster {

/// Version of all that this header makes: any change of a world raises it, and results of several versions
/// are reported beside each other.
inline constexpr std::int32_t kEnvironmentVersion = 1;

/// One of the paper's four environments, with our own measures.
struct StudyEnvironment {
    std::string_view name;         ///< "single-block", "corridor", "multiple-paths", "four-blocks".
    std::string_view title;        ///< "Single Block"...
    std::string_view description;  ///< One or two sentences.
    Vec2 start;                    ///< Centre of the crowd at the start [m].
    std::vector<Box> blocks;       ///< Its obstacles [m].
};

/// What is the same in all environments; printed in every report.
struct StudyRules {
    Box box{{-20.0, -11.25}, {20.0, 11.25}};  ///< The ground [m].
    std::int32_t items = 24;                  ///< Number of items.
    double itemRadius = 0.5;      ///< A character whose centre comes so near collects an item [m].
    double itemClearance = 0.75;  ///< Least distance from an item's centre to an obstacle or the border [m].
    double itemSpacing = 1.5;     ///< Least distance between items [m].
    double startFree = 5.5;       ///< Half the side of the square round the start that holds no items [m].
    double spacing = 1.0;         ///< Between neighbouring places of the start formation, a square [m].
    double speed = 2.0;           ///< Top speed of characters, and of control points [m/s].
    double limit = 300.0;         ///< A trial that is not done by then is censored [s].
    double width = 1920.0, height = 1080.0;  ///< Of the display [px].
    double mmPerPixel = 0.2767;              ///< Of the display.
};

/// The numbers of characters that are studied; the first is the usual one.
std::span<const std::int32_t> studyCrowds();
/// The rules.
const StudyRules& studyRules();
/// All environments.
std::span<const StudyEnvironment> studyEnvironments();
/// The one of that name. Fails with NotFound, listing the names.
Result<StudyEnvironment> studyEnvironment(std::string_view name);
/// A trial's world: `seed` places the items; `mirrored` swaps top and bottom of everything. Fails with
/// InvalidArgument where `crowd` is not 1 to 400.
Result<WorldDef> studyWorld(const StudyEnvironment& environment, std::int32_t crowd, std::uint64_t seed,
                            bool mirrored);
/// How a trial's world is seen: from straight above, all of it.
GroundView studyView();

}  // namespace muster
