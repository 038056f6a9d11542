// How a formation goes so that it meets no other one and no moving obstacle: it waits, or goes aside from its
// course (prioritised planning, Erdmann and Lozano-Perez 1987).
#pragma once

#include <span>
#include <vector>

#include "engine/orders/moving_box.h"

namespace muster {

/// How a formation goes: it waits, then goes on beside its course.
struct Manoeuvre {
    double wait = 0.0;       ///< [s], 0 or more.
    double offCourse = 0.0;  ///< How far to the left of its course [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(wait, offCourse);
    }
    friend bool operator==(const Manoeuvre&, const Manoeuvre&) = default;
};

/// What a group does to keep clear of others, as a world's state holds it.
struct Avoidance {
    Manoeuvre chosen;  ///< What it does.
    Vec2 side;         ///< To the left of its course as that was chosen, of unit length; 0 where nothing was.
    Vec2 offCourse;    ///< How far it is beside its course [m].
    double waited = 0.0;   ///< How long it has waited for moving obstacles [s].
    bool presses = false;  ///< It has waited for too long, and goes on whatever comes.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(chosen, side, offCourse, waited, presses);
    }
};

/// A formation on its way.
struct CourseDef {
    MovingBox box;                ///< Where it is.
    Vec2 middle;                  ///< What goes along the way, `offCourse` beside it [m].
    std::span<const Vec2> ahead;  ///< Corners of the way ahead, at least one [m].
    Vec2 side;                    ///< To the left, of unit length.
    double offCourse = 0.0;       ///< How far it is beside its way [m].
    double speed = 0.0;           ///< At which it goes [m/s].
    double cruise = 1.0;          ///< At which it would go [m/s], above 0.
    double acceleration = 4.0;    ///< [m/s^2], above 0.
};

/// Where something goes: parts in time, each at one velocity.
using Course = std::vector<MovingBox>;

/// So long after it goes on contacts count [s].
inline constexpr double kCourseHorizon = 12.0;
/// So far ahead courses are known [s]: a formation waits no longer than the horizon.
inline constexpr double kKnownAhead = 2.0 * kCourseHorizon;
/// Share of its speed at which a formation goes aside.
inline constexpr double kSideShare = 0.6;
/// Share of its speed that is left on its way meanwhile: the other side of a right triangle.
inline constexpr double kOnwardShare = 0.8;

/// The course of a manoeuvre for so many seconds.
void listCourse(const CourseDef& def, const Manoeuvre& manoeuvre, double until, Course& course);
/// When two courses first come as near as `margin` [m] to each other [s]; infinite where they do not.
double firstContact(std::span<const MovingBox> course, std::span<const MovingBox> other, double margin);
/// By how much later it arrives by a manoeuvre, about [s].
double timeLost(const CourseDef& def, const Manoeuvre& manoeuvre);

}  // namespace muster
