// What an operator decides to do: parts of the crowd, and a way for each. One planner serves all control
// schemes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/study/models/motor.h"
#include "lab/study/models/tour.h"
#include "studio/gestures/control_scheme.h"

namespace muster {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();
inline constexpr double kTargetMetres = 1.0;  // What is aimed at is as large as an item's reach [m].
inline constexpr double kBetweenTaps = 0.15;  // Between two taps on one spot [s].
inline constexpr double kTakenMargin = 0.55;  // A loop is drawn so far round those whom it takes out [m].
inline constexpr std::array<double, 4> kWidths{8.0, 12.0, 16.0, 20.0};

/// What can be done with a scheme.
struct Repertoire {
    bool touch = false;        ///< Fingers, else a mouse.
    bool draws = false;        ///< A stroke is a way that a formation follows to its end.
    bool queues = false;       ///< Points can be added behind those that are not reached yet.
    bool divides = false;      ///< Parts can be sent apart.
    bool spreads = false;      ///< Two fingers set a formation's width and draw two ways at once.
    bool calls = false;        ///< Two taps call whoever is nearest.
    bool keepsShape = false;   ///< Those who are sent keep about their places beside each other; else they
                               ///< gather.
    bool keepsGroups = false;  ///< A digit brings a selection back.
};

/// The repertoire of a scheme.
Repertoire repertoireOf(const SchemeDef& def);

/// A part of the crowd as it is seen.
struct SeenPart {
    std::vector<std::uint32_t> ids;  ///< Its characters, ascending.
    std::vector<Vec2> positions;     ///< Theirs [m].
    Vec2 centre;                     ///< Mean of them [m].
    Box bounds;                      ///< Round them [m].
};

/// Makes a part from its characters.
SeenPart seenPart(std::vector<std::uint32_t> ids, std::vector<Vec2> positions);
/// How wide the target is at which a part is sent, or the path along which it is drawn [m]: as wide as an
/// item's reach, and wider for those who come broadly over it anyway.
double toleranceOf(const SeenPart& part);

/// A part and what it is to do.
struct PlannedPart {
    SeenPart part;                    ///< Who.
    std::vector<std::int32_t> stops;  ///< Items that it is led to, in this order; empty for a sweep.
    std::vector<Vec2> way;            ///< Where its middle is to go, one point after the other [m].
    double width = 0.0;               ///< Width of the front for a sweep [m]; 0 to leave the shape as it is.
    bool square = false;              ///< The formation becomes a square again first.
    Vec2 along;                       ///< For a sweep: the unit vector of its first lane.
    double reforms = 0.0;             ///< Expected time for taking another shape first [s].
    bool stages = false;              ///< It goes where it will sweep from; that is decided there.
    double later = 0.0;               ///< Expected time of what it does then [s].
};

/// What is to be done, and what it would take.
struct OperatorPlan {
    std::vector<std::array<Vec2, 2>> cuts;  ///< Lines that divide the crowd first [m].
    std::vector<PlannedPart> parts;         ///< In the order in which they are sent.
    double seconds = 0.0;                   ///< Estimate until all items are collected [s].
    std::string text;                       ///< What it is, for the log.
};

/// What the planner knows of people, device and crowd.
struct PlannerDef {
    Repertoire repertoire;          ///< What can be done.
    OperatorParameters parameters;  ///< The operator's constants.
    double mmPerMetre = 13.3;       ///< On the display.
    double itemRadius = 0.5;        ///< How near a character must come [m].
    double speed = 2.0;             ///< At which people are known to walk [m/s].
    double spacing = 1.0;           ///< Between neighbours in formation [m].
    Box border;                     ///< The ground [m].
};

/// Makes plans by one estimate of times, with the same candidates for all schemes as far as they can be done.
class Planner {
public:
    Planner(const PlannerDef& def, const TourFinder& tours, const Motor& motor);

    /// The best plan for the whole crowd that is found; `open`: the items that are left.
    OperatorPlan plan(const SeenPart& crowd, std::span<const std::int32_t> open, Chance& chance) const;
    /// What a part that is idle shall do: a way as it is, as a square again, or, where `sweeps`, a sweep.
    PlannedPart renewed(const SeenPart& part, std::span<const std::int32_t> open, bool sweeps,
                        Chance& chance) const;
    /// A few of a part's characters, those next to the nearest of these items, and their way; none where the
    /// part is as small itself, or cannot be divided.
    std::optional<PlannedPart> fetched(const SeenPart& part, std::span<const std::int32_t> open,
                                       Chance& chance) const;
    /// Expected time until a part has collected what it is led to [s].
    double partSeconds(const PlannedPart& part) const;
    /// Expected time for which the operator is busy with taking a few out of a part [s].
    double takeOutSeconds(const PlannedPart& few) const;
    /// Expected time for which the operator is busy with calling somebody to an item [s].
    double callSeconds() const;
    /// A way for a part as it is.
    PlannedPart next(const SeenPart& part, std::span<const std::int32_t> open, Chance& chance) const;

    /// Expected time for which the operator is busy with sending one part [s].
    double sendSeconds(const PlannedPart& part) const;
    /// How a part would sweep up items.
    Sweep sweepOf(const SeenPart& part) const;

private:
    OperatorPlan cells(const SeenPart& crowd, std::int32_t columns, std::int32_t rows) const;
    std::vector<std::vector<std::int32_t>> stretchesOf(Vec2 from, std::span<const std::int32_t> tour,
                                                       std::int32_t count) const;
    OperatorPlan divided(const SeenPart& crowd, std::span<const std::int32_t> tour, std::int32_t columns,
                         std::int32_t rows, Chance& chance) const;
    OperatorPlan swept(const SeenPart& crowd, std::span<const std::int32_t> open, Vec2 along,
                       double width) const;
    OperatorPlan parted(const SeenPart& crowd, std::span<const std::int32_t> open, std::int32_t columns,
                        double share) const;
    void lead(PlannedPart& part, std::span<const std::int32_t> order) const;
    double estimate(const OperatorPlan& plan) const;
    double estimateQueued(const OperatorPlan& plan) const;
    double estimateAttended(const OperatorPlan& plan) const;
    double selectSeconds(const PlannedPart& part) const;
    double clickSeconds(const PlannedPart& part, double metres) const;
    double cutSeconds() const;
    double walkSeconds(const PlannedPart& part) const;
    double foldSeconds(const PlannedPart& part) const;
    PlannedPart bestSweep(const SeenPart& part, std::span<const std::int32_t> open, double loosest) const;
    std::optional<PlannedPart> staged(const PlannedPart& sweep, std::span<const std::int32_t> open) const;
    double sweepSeconds(const PlannedPart& part) const;
    Vec2 aimedAt(Vec2 from, Vec2 item, const Sweep& sweep) const;
    std::vector<Vec2> wayOver(Vec2 from, std::span<const std::int32_t> stops, const Sweep& sweep) const;
    bool collectedOn(const PlannedPart& part, const Sweep& sweep, std::int32_t item) const;
    double beyondBorder(const PlannedPart& part) const;

    PlannerDef def_;
    const TourFinder* tours_;
    const Motor* motor_;
};

}  // namespace muster
