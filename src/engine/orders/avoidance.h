// Manoeuvres by which a formation meets no other one and no moving obstacle: it waits, or goes aside from its
// course (prioritised planning, Erdmann and Lozano-Perez 1987).
#pragma once

#include <span>
#include <vector>

#include "engine/orders/moving_box.h"

namespace muster {

/// A manoeuvre of a formation: it waits, then goes on beside its course.
struct Manoeuvre {
    double wait = 0.0;       ///< Time of waiting [s], 0 or more.
    double offCourse = 0.0;  ///< Distance to the left of its course [m].

    /// Lets an archive read or write the manoeuvre.
    template <class Archive>
    void visit(Archive& archive) {
        archive(wait, offCourse);
    }
    friend bool operator==(const Manoeuvre&, const Manoeuvre&) = default;
};

/// The manoeuvre of a group that keeps clear of others, as a world's state holds it.
struct Avoidance {
    Manoeuvre chosen;  ///< Its present manoeuvre.
    Vec2 side;         ///< Unit vector to the left of its course at the last choice; 0 before the first one.
    Vec2 offCourse;    ///< Offset from its course [m].
    double waited = 0.0;   ///< Time of waiting for moving obstacles [s].
    bool presses = false;  ///< True if it has waited for too long, and goes on whatever comes.

    /// Lets an archive read or write the avoidance.
    template <class Archive>
    void visit(Archive& archive) {
        archive(chosen, side, offCourse, waited, presses);
    }
};

/// A formation on its route.
struct CourseDef {
    MovingBox box;                ///< Present box of the formation.
    Vec2 middle;                  ///< The point that goes along the route, `offCourse` beside it [m].
    std::span<const Vec2> ahead;  ///< Corners of the route ahead, at least one [m].
    Vec2 side;                    ///< Unit vector to the left.
    double offCourse = 0.0;       ///< Distance to the left of its route [m].
    double speed = 0.0;           ///< Present speed [m/s].
    double cruise = 1.0;          ///< Undisturbed speed [m/s], above 0.
    double acceleration = 4.0;    ///< Acceleration [m/s^2], above 0.
};

/// The course of a formation or obstacle: parts in time, each at one velocity.
using Course = std::vector<MovingBox>;

/// Time after a manoeuvre's wait for which contacts count [s].
inline constexpr double kCourseHorizon = 12.0;
/// Time for which courses are known [s]: a formation waits no longer than the horizon.
inline constexpr double kKnownAhead = 2.0 * kCourseHorizon;
/// Share of its speed at which a formation goes aside.
inline constexpr double kSideShare = 0.6;
/// Share of its speed that is left along its route meanwhile: the other side of a right triangle.
inline constexpr double kOnwardShare = 0.8;

/// Lists the course of a manoeuvre until a time [s].
void listCourse(const CourseDef& def, const Manoeuvre& manoeuvre, double until, Course& course);
/// Time at which two courses first come as near as `margin` [m] to each other [s]; infinite where they do
/// not.
double firstContact(std::span<const MovingBox> course, std::span<const MovingBox> other, double margin);
/// Approximate time that a manoeuvre costs [s].
double timeLost(const CourseDef& def, const Manoeuvre& manoeuvre);

}  // namespace muster
