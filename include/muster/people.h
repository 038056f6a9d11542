// People: how the persons of a group differ from each other. The numbers of each are drawn by the world's
// seed.
#pragma once

#include <cstdint>
#include <string>

#include "muster/generated/enumerations.h"
#include "muster/status.h"

namespace muster {

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
    static Distribution normal(double mean, double deviation, double least, double most) {
        return {Spread::Normal, mean, deviation, least, most};
    }
    /// The value below which a share `p` of persons lie, 0 < p < 1; relative error about 1e-9 or better. The
    /// same bits on every machine.
    double quantile(double p) const;

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(spread, a, b, least, most);
    }
    friend bool operator==(const Distribution&, const Distribution&) = default;
};

/// One sort of persons in a group. What is constantly 0 is not drawn: it is that of GroupDef::bodies, or of
/// the parameters where that is 0, too.
///
/// Each new person of a group is drawn: those who are there when the group is made, those whom SetCount or
/// AddCharacters without bodies adds, and those who come by a source. Bodies that AddCharacters or SetBodies
/// give are as given. Of those who are there when the group is made so many are of each sort as its share
/// says, by largest remainders, at random ranks; who comes later is of a sort at random, by its share. Each
/// number depends on the seed of the world, the id of the person and which number it is, and on nothing else.
struct PeopleDef {
    std::string name;            ///< Name for display: "Women over 50".
    double share = 1.0;          ///< Share of the group, above 0; shares are divided by their sum.
    std::uint8_t unitClass = 0;  ///< Class, for roles; 0 for none.
    Distribution speed;          ///< Top speed in the open [m/s], 0 or 0.01 to 50.
    Distribution radius;         ///< Radius of the body [m], 0 or 0.05 to 1.5.
    Distribution headway;        ///< Time that it keeps from who is ahead [s], 0 or 0.02 to 5.
    Distribution premovement;    ///< Time until it sets out on its first order [s], 0 to 1e7.
    /// Age [years], 0 or 5 to 90; above 0 it gives the top speed in the place of `speed`, by
    /// walkingSpeedAtAge().
    Distribution age;
    double upstairs = 0.0;    ///< Speed up stairs as a share of that in the open, 0 or 0.01 to 1.
    double downstairs = 0.0;  ///< Speed down stairs as a share of that in the open, 0 or 0.01 to 1.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, share, unitClass, speed, radius, headway, premovement, age, upstairs, downstairs);
    }
    friend bool operator==(const PeopleDef&, const PeopleDef&) = default;
};

/// Adults: their free speed has the mean 1.34 m/s and the deviation 0.26 m/s (Weidmann 1993), cut off at 0.5
/// and 2.2 m/s.
PeopleDef adults();
/// The mean free speed of persons by age [m/s]: the figure of the RiMEA guideline (test 7), after Weidmann
/// 1993, linear between knots. 20 to 70 years: the middle of the ranges that JuPedSim's test of RiMEA 4.1.1
/// allows, 1.62, 1.54, 1.48, 1.41, 1.27 and 1.07 for 20, 30, 40, 50, 60 and 70 years. Children (0.75, 1.20
/// and 1.47 for 5, 10 and 15 years) and 80 years (0.70): as others have read them off the figure, where
/// readings differ by up to 0.09 at 5 years and 0.01 at 80. The figure ends there; at 90 years it is the
/// least speed of persons of reduced mobility by RiMEA's table 2, 0.46. Younger and older persons have the
/// speeds at the ends.
double walkingSpeedAtAge(double years);

}  // namespace muster
