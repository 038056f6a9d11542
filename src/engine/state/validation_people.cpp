// What the fields of areas and of sorts of persons have to be together.
#include <algorithm>

#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

constexpr double kLongest = 1e9;    // Any time [s].
constexpr double kMostShape = 1e4;  // Of a gamma distribution; a narrower one is a normal one.

Status isTimetable(const std::vector<Arrivals>& timetable) {
    if (timetable.size() > kMaxCorners)
        return {StatusCode::LimitExceeded, "timetable has " + std::to_string(timetable.size()) +
                                               " entries, at most " + std::to_string(kMaxCorners) +
                                               " are allowed"};
    double before = 0.0;
    for (std::size_t k = 0; k < timetable.size(); ++k) {
        const std::string where = "timetable[" + std::to_string(k) + "]";
        if (Status s = first({validate(timetable[k]), inRange("time", timetable[k].time, before, kLongest)});
            !s.ok())
            return s.within(where);
        before = timetable[k].time;
    }
    return {};
}

// What is drawn lies from `low` to `high`.
Status drawsFrom(const Distribution& drawn, double low, double high) {
    if (drawn.spread == Spread::Constant) return isOwn("a", drawn.a, low, high);
    const double lowest = drawn.quantile(1e-9), highest = drawn.quantile(1.0 - 1e-9);
    if (lowest >= low && highest <= high) return {};
    return invalidArgument("it reaches from " + numberText(lowest) + " to " + numberText(highest) +
                           ", expected numbers in [" + numberText(low) + ", " + numberText(high) +
                           "]; least and most cut it off");
}

}  // namespace

Status isDistribution(const char* what, const Distribution& drawn, double low, double high) {
    Status status = validate(drawn);
    if (status.ok()) status = drawsFrom(drawn, low, high);
    return status.within(what);
}

Status relations(const Distribution& d) {
    if (Status s = inRange("most", d.most, d.least, 1e9); !s.ok()) return s;
    if (d.spread == Spread::Uniform && d.b < d.a)
        return invalidArgument("b is " + numberText(d.b) + ", expected a number of at least a, " +
                               numberText(d.a));
    const bool scaled = d.spread == Spread::Gamma || d.spread == Spread::Weibull;
    if (scaled && !(d.a >= 1e-6 && d.b >= 1e-6))
        return invalidArgument("shape and scale are to be 1e-6 or more");
    if (d.spread == Spread::Gamma && !(d.a <= kMostShape))
        return invalidArgument("a is " + numberText(d.a) + ", expected a shape of at most " +
                               numberText(kMostShape));
    if ((d.spread == Spread::Normal || d.spread == Spread::LogNormal) && d.b < 0.0)
        return invalidArgument("b is " + numberText(d.b) + ", expected a deviation of 0 or more");
    if (d.spread == Spread::LogNormal && !(std::max(d.a, d.b) <= 50.0))
        return invalidArgument("the numbers of the logarithm are to be 50 or less");
    return {};
}

Status relations(const AreaDef& d) {
    if (Status s = first({inRange("until", d.until, d.from, kLongest), isTimetable(d.timetable)}); !s.ok())
        return s;
    if (!d.queue.empty() && (d.kind != AreaKind::Exit || d.queue.size() < 2))
        return invalidArgument("a queue is a line of two or more points before an exit");
    if (!d.timetable.empty() && d.kind != AreaKind::Source)
        return invalidArgument("only a source has a timetable");
    return {};
}

Status validatePeople(const std::vector<PeopleDef>& people) {
    return each("people", people, 100);
}

}  // namespace muster
