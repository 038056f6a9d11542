// Which way a mesh goes so that it meets no other mesh and no moving obstacle: reciprocal velocity obstacles
// (van den Berg, Lin and Manocha 2008) over manoeuvres of bounded acceleration (van den Berg, Snape, Guy and
// Manocha 2011).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/function_ref.h"
#include "engine/orders/moving_box.h"

namespace muster {

/// How a mesh goes: for some time at a speed, along its way or at an angle to it, and then by its way again.
struct Manoeuvre {
    double speed = 0.0;    ///< [m/s], 0 or more.
    double angle = 0.0;    ///< To the way, counter-clockwise [rad]; 0 follows it round its corners.
    double seconds = 0.0;  ///< So long [s].
    bool stops = false;    ///< It stops then.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(speed, angle, seconds, stops);
    }
};

/// What a group does to keep clear of others, as a world's state holds it.
struct Avoidance {
    bool under = false;      ///< It goes along a way.
    bool hindered = false;   ///< It goes otherwise than it would alone.
    Manoeuvre chosen;        ///< What it does.
    Vec2 velocity;           ///< Of its mesh in the last step [m/s].
    double left = 0.0;       ///< Least way left so far [m].
    std::uint32_t got = 0;   ///< Step in which it last got on.
    double pressTo = 0.0;    ///< It presses on until no more way is left [m].
    std::uint8_t press = 0;  ///< 0: it keeps clear; 1: of moving obstacles alone; 2: of nothing.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(under, hindered, chosen, velocity, left, got, pressTo, press);
    }
};

/// Something to keep clear of.
struct Neighbour {
    MovingBox box;        ///< Where it is and how it moves.
    double margin = 0.5;  ///< To keep to it [m].
    bool isMesh = false;  ///< A mesh, whose future is less certain.
    bool shares = false;  ///< It keeps clear as well, and takes half of the change.
};

/// Who keeps clear.
struct AvoidanceQuery {
    MovingBox own;                ///< The mesh now, and its velocity.
    Vec2 middle;                  ///< What goes along the way [m].
    std::span<const Vec2> ahead;  ///< Corners of the way ahead, at least one [m].
    bool wheels = true;           ///< It faces along its way.
    double preferred = 0.0;       ///< Speed that it would have alone [m/s].
    double cruise = 1.0;          ///< Speed on a straight way [m/s], above 0.
    double top = 1.0;             ///< Top speed [m/s].
    double acceleration = 4.0;    ///< Top acceleration [m/s^2], above 0.
    Manoeuvre last;               ///< What it does, and for how long it will.
    bool hindered = false;        ///< That is not what it would do alone.
};

/// What it is to do.
struct AvoidanceChoice {
    Manoeuvre manoeuvre;
    bool hindered = false;  ///< Not what it would do alone.
    bool free = true;       ///< False where it meets somebody whatever it does.
};

/// Where a manoeuvre leads: parts in time, each at one velocity.
struct Course {
    static constexpr std::size_t kMost = 16;
    std::array<MovingBox, kMost> parts;
    std::size_t count = 0;
};

/// Who is slower stands, and is not counted upon to keep clear [m/s].
inline constexpr double kMeshStands = 0.3;
/// Of meshes, contacts so far ahead count [s].
inline constexpr double kMeshHorizon = 8.0;
/// Of moving obstacles, whose paths are known [s].
inline constexpr double kMoverHorizon = 12.0;

/// Time until it has arrived by a manoeuvre and the way from where that ends, about [s].
double arrivalOf(const AvoidanceQuery& query, const Manoeuvre& manoeuvre);
/// The course of a manoeuvre up to the horizon of moving obstacles.
Course courseOf(const AvoidanceQuery& query, const Manoeuvre& manoeuvre);

/// When a course meets a neighbour first [s]; infinite where it does not within the horizon.
double firstContact(const AvoidanceQuery& query, const Course& course, bool stops, const Neighbour& neighbour,
                    double margin);

/// Chooses manoeuvres. Memory is reused.
class Avoider {
public:
    /// Says whether the ground permits to go at a velocity [m/s].
    using HasRoom = FunctionRef<bool(Vec2)>;

    Avoider();  ///< Takes its memory.

    /// The manoeuvre that loses least time among those that meet nobody; where there is none, the one that
    /// meets somebody last.
    AvoidanceChoice choose(const AvoidanceQuery& query, std::span<const Neighbour> neighbours,
                           HasRoom hasRoom);

private:
    struct Candidate {
        Manoeuvre manoeuvre;
        double contact = 0.0;  // With whom it was looked at first [s].
        bool kept = false;     // What it does already.
    };
    /// A neighbour, and the margins that are left.
    struct Near {
        Neighbour neighbour;
        double stopMargin = 0.0;  // [m]
    };
    /// Who is in the way first.
    struct Hindrance {
        double contact = std::numeric_limits<double>::infinity();  // [s]
        bool stands = false;
        bool isMesh = false;
        bool fromLeft = false;  // It keeps clear as well, and comes from the left.
        std::size_t who = 0;    // Number of the neighbour.
    };

    void readNeighbours(const AvoidanceQuery& query, std::span<const Neighbour> neighbours);
    double contactOf(const AvoidanceQuery& query, const Candidate& candidate, bool whole);
    Hindrance hindranceOf(const AvoidanceQuery& query, const Manoeuvre& alone) const;
    double costOf(const AvoidanceQuery& query, const Hindrance& hindrance, double alone,
                  const Manoeuvre& manoeuvre) const;
    AvoidanceChoice latest(const AvoidanceQuery& query, HasRoom hasRoom);
    void listCandidates(const AvoidanceQuery& query, const Hindrance& hindrance, double alone);

    std::vector<Near> near_;
    std::vector<Vec2> met_;  // Directions to moving obstacles that it overlaps already.
    std::vector<Candidate> candidates_;
    std::vector<std::pair<double, std::int32_t>> order_;  // Of candidates by cost.
    std::size_t first_ = 0;  // The neighbour that was met last: it is looked at first.
};

}  // namespace muster
