// Units: what single characters are, what they are in their formation, and how groups are divided (SPEC B2,
// B10, B13, B15).
#pragma once

#include <cstdint>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/vec2.h"

namespace muster {

/// The body of a character. A number of 0 stands for the parameter of that name.
struct Body {
    double radius = 0.0;        ///< Radius [m], 0 or 0.05 to 1.5.
    double maxSpeed = 0.0;      ///< Top speed in the open [m/s], 0 or 0.01 to 50.
    double acceleration = 0.0;  ///< Top acceleration [m/s^2], 0 or 0.01 to 1000.
    double mass = 1.0;    ///< Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less.
    double supply = 1.0;  ///< Units that it supplies to places (SPEC A1), above 0 and at most 1000.
    std::uint8_t unitClass = 0;  ///< Class, for roles; 0 for none.
    double headway = 0.0;        ///< Time that it keeps from who is ahead [s], 0 or 0.02 to 5.
    double premovement = 0.0;    ///< Time from its first order until it sets out [s], 0 to 1e7; no parameter.
    double upstairs = 0.0;    ///< Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
    double downstairs = 0.0;  ///< Speed down stairs as a share of that in the open, 0.01 to 1; 0: theirs.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(radius, maxSpeed, acceleration, mass, supply, unitClass);
        archive.since(7, headway, premovement, upstairs, downstairs);
    }
    friend bool operator==(const Body&, const Body&) = default;
};

/// Characters of a class take their places in a part of the formation: as many as there are such characters.
/// Roles choose in their order; who is of no role takes what is left. (Ranks by class: several roles in
/// front.)
struct RoleDef {
    RoleArea area = RoleArea::Front;  ///< Where.
    std::uint8_t unitClass = 1;       ///< Who, 1 or more.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(area, unitClass);
    }
    friend bool operator==(const RoleDef&, const RoleDef&) = default;
};

}  // namespace muster
