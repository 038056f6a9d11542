// People: how the persons of a group differ from each other. The numbers of each are drawn by the world's seed.
#pragma once

#include <cstdint>
#include <string>

#include "muster/status.h"

namespace muster {

/// How a number is spread over persons.
enum class Spread : std::uint8_t {
    Constant,   ///< All have `a`.
    Uniform,    ///< Evenly from `a` to `b`.
    Normal,     ///< Mean `a`, standard deviation `b`.
    LogNormal,  ///< Its logarithm has the mean `a` and the standard deviation `b`.
    Gamma,      ///< Shape `a`, scale `b`.
    Weibull,    ///< Scale `a`, shape `b`.
};

/// The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not drawn.
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
    /// The value below which a share `p` of persons lie, 0 < p < 1.
    double quantile(double p) const;

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(spread, a, b, least, most);
    }
    friend bool operator==(const Distribution&, const Distribution&) = default;
};

/// One sort of persons in a group. A number of 0 stands for that of the parameters, as in Body.
struct PeopleDef {
    std::string name;                ///< Name for display: "Women over 50".
    double share = 1.0;              ///< Share of the group, above 0; shares are divided by their sum.
    std::uint8_t unitClass = 0;      ///< Class, for roles; 0 for none.
    Distribution speed;              ///< Top speed in the open [m/s], 0 or 0.01 to 50.
    Distribution radius;             ///< Radius of the body [m], 0 or 0.05 to 1.5.
    Distribution headway;            ///< Time that it keeps from who is ahead [s], 0 or 0.02 to 5.
    Distribution premovement;        ///< Time until it sets out on its first order [s], 0 to 1e7.
    /// Age [years]; above 0 it gives the top speed in the place of `speed`, by walkingSpeedAtAge().
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
/// The mean free speed of persons by age [m/s] (RiMEA guideline, after Weidmann 1993), 5 to 90 years.
double walkingSpeedAtAge(double years);

}  // namespace muster
