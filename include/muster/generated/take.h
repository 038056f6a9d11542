// Made by schema/generate.mjs from schema/api/take.txt: change these, not this file.
// What takes hold, and the outcome of a replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/event.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// The hash of a world's state after that many steps.
struct HashMark {
    std::uint32_t step = 0;  ///< Number of steps done.
    std::uint64_t hash = 0;  ///< Hash of the state after these steps.
    /// Number of commands recorded before this mark. The file does not store it.
    std::uint32_t commands = 0;
    /// Equal in all parts.
    friend bool operator==(const HashMark&, const HashMark&) = default;
};

/// An event of an order, as it was raised while the take was recorded (EventKind: Arrived and later ones).
struct TakeEvent {
    std::uint32_t step = 0;  ///< Number of steps done at the event.
    Event event;             ///< The event.
    /// Equal in all parts.
    friend bool operator==(const TakeEvent&, const TakeEvent&) = default;
};

/// Where everybody was after that many steps, to 1 mm: what a take shows where its simulation gives other
/// bits.
struct TakeFrame {
    std::uint32_t step = 0;          ///< Number of steps done.
    std::vector<std::uint32_t> ids;  ///< Who, in ascending order.
    std::vector<Vec2> positions;     ///< Where [m], in the same order.
    /// Equal in all parts.
    friend bool operator==(const TakeFrame&, const TakeFrame&) = default;
};

/// A part of a take that plays faster or slower than it was recorded.
struct SpeedPiece {
    double from = 0.0;   ///< Time in the take [s].
    double to = 0.0;     ///< Time in the take [s], above `from`.
    double speed = 1.0;  ///< Seconds of the take per second, 0.1 to 8.
    double ease = 0.0;   ///< Time at each end in which the speed comes and goes [s], 0 or more.
    /// Equal in all parts.
    friend bool operator==(const SpeedPiece&, const SpeedPiece&) = default;
};

/// Where a film's camera is at a moment of a take. From one to the next it moves with ease.
struct CameraKey {
    std::uint32_t step = 0;  ///< Number of steps done.
    double x = 0.0;          ///< The point on the ground that it looks at [m].
    double y = 0.0;          ///< As above [m].
    double distance = 1.0;   ///< From there, above 0 [m].
    double turn = 0.0;       ///< Round the vertical [rad].
    double pitch = 0.0;      ///< How steeply it looks down [rad].
    bool cut = false;        ///< True: the camera is here at once, and rests before.
    /// Equal in all parts.
    friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

/// Holds the path of edited people at another place at one moment of their own clock; before and after it the
/// path moves along, ever less.
struct PathPin {
    double time = 0.0;  ///< Time on the own clock of each of them, 0 or more [s].
    Vec2 offset;        ///< How far from where they were then [m].
    /// So long before and after the path moves along [s], 0.2 to 60; never beyond the next pin.
    double seconds = 2.0;
    /// Equal in all parts.
    friend bool operator==(const PathPin&, const PathPin&) = default;
};

/// A moment at which edited people are as far on their path as they were at another.
struct ClockPoint {
    double time = 0.0;  ///< Time in the take [s].
    double own = 0.0;   ///< Time of the recording that is shown then [s].
    /// Equal in all parts.
    friend bool operator==(const ClockPoint&, const ClockPoint&) = default;
};

/// A time in which edited people play a named clip.
struct ClipPart {
    std::string name;   ///< Name of the clip; one that does not repeat is played once.
    double from = 0.0;  ///< Time in the take [s].
    double to = 0.0;    ///< Time in the take [s], above `from`.
    /// Equal in all parts.
    friend bool operator==(const ClipPart&, const ClipPart&) = default;
};

/// A time in which edited people look at something.
struct LookPart {
    std::uint32_t person = 0;  ///< At whom; 0 for a point.
    Vec2 point;                ///< At which point, without a person [m].
    double height = 1.6;       ///< The height of that point, -10 to 100 [m].
    double from = 0.0;         ///< Time in the take [s].
    double to = 0.0;           ///< Time in the take [s], above `from`.
    /// Equal in all parts.
    friend bool operator==(const LookPart&, const LookPart&) = default;
};

/// What is changed afterwards in how some people are shown; everybody else keeps everything.
struct TakeEdit {
    std::vector<std::uint32_t> people;  ///< Who, in ascending order; nobody has two edits.
    std::vector<PathPin> pins;          ///< In ascending order, at least 0.1 s apart.
    /// None, or two and more in ascending order; before the first and after the last one their clock runs as
    /// usual.
    std::vector<ClockPoint> clock;
    std::vector<ClipPart> clips;  ///< In ascending order, apart from each other.
    std::vector<LookPart> looks;  ///< In ascending order, apart from each other.

    /// Number of entries of each list.
    static constexpr std::size_t kMaxParts = 64;
    /// True where it changes nothing.
    bool empty() const { return pins.empty() && clock.empty() && clips.empty() && looks.empty(); }
    /// Equal in all parts.
    friend bool operator==(const TakeEdit&, const TakeEdit&) = default;
};

/// What is said about a take: its name, and the part of it that is to be shown. It changes nothing of what
/// was recorded.
struct TakeAbout {
    std::string title;               ///< Name for people; empty for none, at most kMaxTitleBytes.
    std::uint32_t from = 0;          ///< Steps before the part begins.
    std::uint32_t to = 0xffffffff;   ///< Steps after which the part ends; kTakeEnd for the end of the take.
    std::vector<SpeedPiece> speeds;  ///< In ascending order, apart from each other; at most kMaxSpeedPieces.
    std::vector<CameraKey> camera;   ///< In ascending order of steps; at most kMaxCameraKeys.
    /// Changes of how some people are shown; at most kMaxEdits, of kMaxEdited people together.
    std::vector<TakeEdit> edits;

    /// Number of camera keys.
    static constexpr std::size_t kMaxCameraKeys = 200;
    /// Length of a title.
    static constexpr std::size_t kMaxTitleBytes = 200;
    /// Number of speed pieces.
    static constexpr std::size_t kMaxSpeedPieces = 64;
    /// Number of edits.
    static constexpr std::size_t kMaxEdits = 200;
    /// Number of people with edits.
    static constexpr std::size_t kMaxEdited = 500;
    /// The first step of the part of a take with that many steps: below its last one.
    std::uint32_t firstStep(std::uint32_t steps) const;
    /// The last step of the part, at most `steps`.
    std::uint32_t lastStep(std::uint32_t steps) const;
    /// Seconds of the take per second that it is shown, at that time of the take [s].
    double speedAt(double seconds) const;
    /// Fails with InvalidArgument, naming the value, where it is not as described.
    Status check() const;
    /// Equal in all parts.
    friend bool operator==(const TakeAbout&, const TakeAbout&) = default;
};

/// Outcome of a replay.
struct ReplayReport {
    std::uint32_t steps = 0;     ///< Number of steps simulated.
    std::uint32_t compared = 0;  ///< Number of marks that matched.
    std::uint32_t unmarked = 0;  ///< Steps after the last mark, which no hash confirms.
    std::uint64_t hash = 0;      ///< Hash of the final state.
};

}  // namespace muster
