// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// What single characters are, and how the persons of a group differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"

namespace muster {

/// The body of a character. A number of 0 stands for the parameter of that name.
struct Body {
    double radius = 0.0;         ///< Radius, 0 or 0.05 to 1.5 [m].
    double maxSpeed = 0.0;       ///< Top speed in the open, 0 or 0.01 to 50 [m/s].
    double acceleration = 0.0;   ///< Top acceleration, 0 or 0.01 to 1000 [m/s^2].
    double mass = 1.0;           ///< Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way
                                 ///< less.
    double supply = 1.0;         ///< Units that it supplies to places (SPEC A1), above 0 and at most 1000.
    std::uint8_t unitClass = 0;  ///< Class, for roles; 0 for none.
    double headway = 0.0;        ///< Time that it keeps from who is ahead, 0 or 0.02 to 5 [s].
    double premovement = 0.0;    ///< Time from its first order until it sets out, 0 to 1e7 [s]; no parameter.
    double upstairs = 0.0;       ///< Speed up stairs as a share of that in the open, 0.01 to 1; 0: the
                                 ///< stairs'.
    double downstairs = 0.0;     ///< Speed down stairs as a share of that in the open, 0.01 to 1; 0: the
                                 ///< stairs'.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(radius, maxSpeed, acceleration, mass, supply, unitClass);
        archive.since(7, headway, premovement, upstairs, downstairs);
    }
    /// Equal in all parts.
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
    /// Equal in all parts.
    friend bool operator==(const RoleDef&, const RoleDef&) = default;
};

/// The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not
/// drawn, and what lies inside is drawn in its proportions. A constant is as it is.
struct Distribution {
    Spread spread = Spread::Constant;  ///< Its kind.
    double a = 0.0;                    ///< First number, in the unit of what is drawn but for LogNormal.
    double b = 0.0;                    ///< Second number; not read for Constant.
    double least = 0.0;                ///< The smallest value that occurs.
    double most = 1e9;                 ///< The largest one.

    /// Everybody has `value`.
    static Distribution constant(double value) { return {Spread::Constant, value, 0.0, 0.0, 1e9}; }
    /// Evenly from `low` to `high`.
    static Distribution uniform(double low, double high) { return {Spread::Uniform, low, high, 0.0, 1e9}; }
    /// A normal distribution, cut off below `least` and above `most`.
    static Distribution normal(double mean, double deviation, double least, double most);
    /// The value below which a share `p` of persons lie, 0 < p < 1; relative error about 1e-9 or better. The
    /// same bits on every machine.
    double quantile(double p) const;

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(spread, a, b, least, most);
    }
    /// Equal in all parts.
    friend bool operator==(const Distribution&, const Distribution&) = default;
};

/// One sort of persons in a group. What is constantly 0 is not drawn: it is that of GroupDef::bodies, or of
/// the parameters where that is 0, too.
///
/// Each new person of a group is drawn: those who are there when the group is made, those whom ChangeGroup or
/// AddCharacters without bodies adds, and those who come by a source. Bodies that AddCharacters or
/// ChangeCharacters give are as given. Of those who are there when the group is made so many are of each sort
/// as its share says, by largest remainders, at random ranks; who comes later is of a sort at random, by its
/// share. Each number depends on the seed of the world, the id of the person and which number it is, and on
/// nothing else.
struct PeopleDef {
    std::string name;            ///< Name for display: "Women over 50".
    double share = 1.0;          ///< Share of the group, above 0; shares are divided by their sum.
    std::uint8_t unitClass = 0;  ///< Class, for roles; 0 for none.
    Distribution speed;          ///< Top speed in the open, 0 or 0.01 to 50 [m/s].
    Distribution radius;         ///< Radius of the body, 0 or 0.05 to 1.5 [m].
    Distribution headway;        ///< Time that it keeps from who is ahead, 0 or 0.02 to 5 [s].
    Distribution premovement;    ///< Time until it sets out on its first order, 0 to 1e7 [s].
    Distribution age;            ///< Age, 0 or 5 to 90 [years]; above 0 it gives the top speed in the place
                                 ///< of `speed`, as RiMEA has it.
    double upstairs = 0.0;       ///< Speed up stairs as a share of that in the open, 0 or 0.01 to 1.
    double downstairs = 0.0;     ///< Speed down stairs as a share of that in the open, 0 or 0.01 to 1.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, share, unitClass, speed, radius, headway, premovement, age, upstairs, downstairs);
    }
    /// Equal in all parts.
    friend bool operator==(const PeopleDef&, const PeopleDef&) = default;
};

}  // namespace muster
