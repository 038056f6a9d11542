// Decisions of an operator: parts of the crowd, and a way for each. One planner serves all control schemes.
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
inline constexpr double kTargetMetres = 1.0;  // Width of a target, which is that of an item's reach [m].
inline constexpr double kBetweenTaps = 0.15;  // Time between two taps on one spot [s].
inline constexpr double kTakenMargin = 0.55;  // Distance of a loop from the characters that it takes out [m].
inline constexpr std::array<double, 4> kWidths{8.0, 12.0, 16.0, 20.0};

/// The gestures that a scheme offers.
struct Repertoire {
    bool touch = false;    ///< True for fingers, false for a mouse.
    bool draws = false;    ///< A stroke is a way that a formation follows to its end.
    bool queues = false;   ///< Points can be added behind those that are not reached yet.
    bool divides = false;  ///< Parts can be sent apart.
    bool spreads = false;  ///< Two fingers set a formation's width and draw two ways at once.
    bool calls = false;    ///< Two taps call whoever is nearest.
    /// Characters that are sent keep about their offsets from each other; else they gather.
    bool keepsShape = false;
    ///< gather.
    bool keepsGroups = false;  ///< A digit brings a selection back.
};

/// The repertoire of a scheme.
Repertoire repertoireOf(const SchemeDef& def);

/// A part of the crowd as it is seen.
struct SeenPart {
    std::vector<std::uint32_t> ids;  ///< Its characters, ascending.
    std::vector<Vec2> positions;     ///< Positions of the characters [m].
    Vec2 centre;                     ///< Mean of the positions [m].
    Box bounds;                      ///< Box round the positions [m].
};

/// Makes a part from its characters.
SeenPart seenPart(std::vector<std::uint32_t> ids, std::vector<Vec2> positions);
/// Width of the target to which a part is sent, or of the path along which it is drawn [m]: an item's reach,
/// and more for a part that comes broadly over the target anyway.
double toleranceOf(const SeenPart& part);

/// A part and the way that is planned for it.
struct PlannedPart {
    SeenPart part;                    ///< The part.
    std::vector<std::int32_t> stops;  ///< Items that the part is led to, in this order; empty for a sweep.
    std::vector<Vec2> way;  ///< Points to which the part's middle is to go, one after the other [m].
    double width = 0.0;     ///< Width of the front for a sweep [m]; 0 to leave the shape as it is.
    bool square = false;    ///< Whether the formation becomes a square again first.
    Vec2 along;             ///< Unit vector of a sweep's first lane.
    double reforms = 0.0;   ///< Expected time for taking another shape first [s].
    bool stages = false;    ///< Whether the part goes to the start of a later sweep, which is decided there.
    double later = 0.0;     ///< Expected time of that sweep [s].
};

/// A plan for all parts, and the time that it would take.
struct OperatorPlan {
    std::vector<std::array<Vec2, 2>> cuts;  ///< Lines that divide the crowd first [m].
    std::vector<PlannedPart> parts;         ///< Parts in the order in which they are sent.
    double seconds = 0.0;                   ///< Estimated time until all items are collected [s].
    std::string text;                       ///< Words for the log that name the plan.
};

/// Knowledge of the planner about people, device and crowd.
struct PlannerDef {
    Repertoire repertoire;          ///< Gestures that the scheme offers.
    OperatorParameters parameters;  ///< The operator's constants.
    double mmPerMetre = 13.3;       ///< Scale of the display [mm/m].
    double itemRadius = 0.5;        ///< Distance to an item at which a character collects it [m].
    double speed = 2.0;             ///< Speed at which people are known to walk [m/s].
    double spacing = 1.0;           ///< Distance between neighbours in formation [m].
    Box border;                     ///< Border of the ground [m].
};

/// Makes plans by one estimate of times, with the same candidates for all schemes as far as they can be done.
class Planner {
public:
    Planner(const PlannerDef& def, const TourFinder& tours, const Motor& motor);

    /// The best plan for the whole crowd that is found; `open`: the items that are left.
    OperatorPlan plan(const SeenPart& crowd, std::span<const std::int32_t> open, Chance& chance) const;
    /// The task of an idle part: a way as it is, as a square again, or, where `sweeps`, a sweep.
    PlannedPart renewed(const SeenPart& part, std::span<const std::int32_t> open, bool sweeps,
                        Chance& chance) const;
    /// A few of a part's characters, those next to the nearest of these items, and their way; none where the
    /// part is as small itself, or cannot be divided.
    std::optional<PlannedPart> fetched(const SeenPart& part, std::span<const std::int32_t> open,
                                       Chance& chance) const;
    /// Expected time until a part has collected the items that it is led to [s].
    double partSeconds(const PlannedPart& part) const;
    /// Expected time for which the operator is busy with taking a few out of a part [s].
    double takeOutSeconds(const PlannedPart& few) const;
    /// Expected time for which the operator is busy with calling somebody to an item [s].
    double callSeconds() const;
    /// A way for a part as it is.
    PlannedPart next(const SeenPart& part, std::span<const std::int32_t> open, Chance& chance) const;

    /// Expected time for which the operator is busy with sending one part [s].
    double sendSeconds(const PlannedPart& part) const;
    /// The sweep of a part over items.
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
