// A march that flows: the places of a formation are led along a route as an incompressible stream.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_banks.h"
#include "engine/orders/stream_flow.h"
#include "engine/orders/stream_line.h"
#include "engine/orders/stream_paths.h"
#include "engine/orders/stream_piece.h"
#include "engine/orders/stream_runs.h"
#include "engine/orders/stream_stretch.h"

namespace muster {

/// The reciprocal of the share of places, and of their holders, that may fall behind a march.
inline constexpr std::size_t kStragglers = 10;

/// Input of a march. All lists of places have the same length; place i starts at starts[i], stands at
/// offsets[i] while the ground is open, and ends at ends[i].
struct StreamDef {
    std::span<const Vec2> offsets;  ///< Offsets in the frame of the formation: x forward, y left [m].
    std::span<const Vec2> starts;   ///< Present positions [m].
    std::span<const Vec2> ends;     ///< Ends, on free ground [m].
    /// The route from the middle of the starts to that of the ends, two points or more [m].
    std::span<const Vec2> way;
    double spacing = 1.0;  ///< Spacing of the formation [m], above 0.
    double radius = 0.25;  ///< Radius of bodies [m], above 0.
    /// Least distance of places in narrow ground [m], above 0; the spacing where that is less.
    double closest = 1e9;
    bool drawn = false;  ///< True if the route is kept to even where the ground between is free.
    std::span<const Pose> poses = {};  ///< Poses of a march in one piece; none for one that may flow.
    bool measured = false;             ///< True if length() will be asked for.
};

/// Status of a plan.
enum class StreamStatus : std::uint8_t {
    Planning,  ///< The plan goes on.
    Straight,  ///< Every place goes straight from its start to its end, or all go in one piece.
    Flowing,   ///< The places go along the route.
    Blocked,   ///< The route is blocked, or the definition is bad: there is no march.
};

/// Plans a march, and gives the positions of its places as a function of one number q from 0 (start) to 1
/// (end). Owns its memory and reuses it.
class Stream {
public:
    /// Begins a plan from a copy of the definition.
    void start(const StreamDef& def);
    /// Goes on for about `operations` operations (of about 20 ns). The ground must stay as it is until the
    /// plan is done.
    StreamStatus advance(StreamGround ground, std::int64_t operations);

    StreamStatus status() const { return status_; }        ///< Status of the plan.
    std::int64_t operations() const { return spent_; }     ///< Operations since the start of the plan.
    std::size_t places() const { return starts_.size(); }  ///< Number of places.
    /// Length of the slowest of nine in ten places, in metres of good ground: at a speed they arrive after
    /// length() / speed. For a march that flows 0 unless its definition asks for it.
    double length() const { return length_; }

    /// The pose at `q` of a march in one piece.
    Pose pieceAt(double q) const { return piece_.empty() ? Pose{} : piece_.at(q); }
    /// The positions of the places at `q`, exactly their starts at 0 and their ends at 1. Only once planned.
    void at(double q, std::span<Vec2> places) const;
    /// The q after `dt` [s] > 0 at which nine in ten places have gone no faster than their `speeds` [m/s]
    /// above 0. `places` are those at `q`, and afterwards those at the result. `rate` is the growth of q per
    /// metre of the fastest of nine in ten places, as found by the last call, or 0; with it one try is the
    /// rule.
    double next(double q, double dt, std::span<const double> speeds, std::span<Vec2> places, double& rate);

private:
    enum class Stage : std::uint8_t {
        Straight,
        Line,
        Rows,
        Flow,
        Paths,
        Load,
        Steepen,
        Lay,
        Part,
        Smooth,
        Finish,
        Measure
    };
    /// Coordinates of a place that are computed once.
    struct Leg {
        double fromXi = 0.0, toXi = 0.0;  // Xi of start and end [m].
        double nominalXi = 0.0;           // Xi in the formation, at q = 0 [m].
        double shift = 0.0;               // Shift backwards in single order [m].
        Vec2 missFrom, missTo;            // Offsets of start and end from their coordinates [m].
    };

    void step(StreamGround ground);
    bool valid() const;
    void checkStraight(StreamGround ground);
    void startPiece(std::span<const Pose> poses);
    Vec2 straight(std::size_t i, double q, const Pose& pose) const;
    Vec2 miss(std::size_t i, double q) const;
    void makeLine();
    void placeOnLine();
    void reachOut();
    bool isWalledOff() const;
    bool centre();
    void startFlow();
    void enter(Stage stage);
    void stepCourses();
    void orderRows();
    void finish();
    bool formUp();
    void measure(StreamGround ground);
    static constexpr double kFade = 0.125;       // Share of the route over which order can be made.
    static constexpr std::int32_t kDepths = 64;  // Number of samples along the depth of the formation.
    using Depths = std::array<double, kDepths + 1>;

    void fillDepths();
    void closeUp(double q, Depths& ahead) const;
    Vec2 raw(std::size_t i, double q, const Depths& ahead) const;
    double overshoot(std::span<const Vec2> from, std::span<const Vec2> to, double reach,
                     std::span<const double> speeds);

    StreamStatus status_ = StreamStatus::Blocked;
    bool flows_ = false;  // False where every place goes straight on, or all go in one piece.
    Stage stage_ = Stage::Straight;
    std::size_t next_ = 0;
    std::int64_t spent_ = 0;
    double length_ = 0.0;
    std::vector<Vec2> offsets_, starts_, ends_, way_, moved_, last_;
    std::vector<double> moves_;   // Moves of places in a step, squared.
    std::vector<double> speeds_;  // Speeds on the ground under the places.
    double spacing_ = 1.0, radius_ = 0.25, closest_ = 1.0;
    double back_ = 0.0, fore_ = 0.0, startReach_ = 0.0,
           endReach_ = 0.0;  // Greatest distance of starts and ends from the ends of the route [m].
    // Shares of the route over which the formation is made and left.
    double fadeStart_ = 1.0, fadeEnd_ = 1.0;
    double orderRate_ = 1.0;     // Rate at which single order comes and goes at start and end.
    bool hollow_ = false;        // True if some rows of the formation are less full than wide.
    double nominalFront_ = 0.0;  // Xi of its front at q = 0 [m].
    double depthStep_ = 1.0;     // Distance between samples of its depth [m].
    Depths full_{};              // Share of its width that is full, by depth.
    bool centred_ = false, formed_ = false, measured_ = false;
    double startS_ = 0.0, endS_ = 0.0, low_ = 0.0, high_ = 0.0, travel_ = 0.0, most_ = 0.0;
    std::vector<double> half_, shift_;
    std::vector<std::uint8_t> street_;
    StreamPiece piece_;
    StreamLine line_;
    StreamRuns runs_;
    StreamFlow flow_;
    StreamPaths paths_;
    StreamBanks banks_;
    StreamStretch stretch_;
    std::vector<StreamCourse> courses_;
    std::vector<Leg> legs_;
    std::vector<std::uint32_t> beside_;  // Indices by ordinate in a row.
    std::vector<std::uint32_t> rank_;    // Indices by row of the formation.
};

}  // namespace muster
