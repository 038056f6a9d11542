// Checks of areas and of sorts of persons.
#include <algorithm>

#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

constexpr double kLongest = 1e9;      // Any time [s].
constexpr double kMostRate = 1000.0;  // Of people by an area [1/s].
constexpr double kMostShape = 1e4;    // Of a gamma distribution; a narrower one is a normal one.

Status isTimetable(const std::vector<Arrivals>& timetable) {
    if (timetable.size() > kMaxCorners)
        return {StatusCode::LimitExceeded, "timetable has " + std::to_string(timetable.size()) +
                                               " entries, at most " + std::to_string(kMaxCorners) +
                                               " are allowed"};
    double before = 0.0;
    for (std::size_t k = 0; k < timetable.size(); ++k) {
        const std::string where = "timetable[" + std::to_string(k) + "]";
        if (Status s = first({inRange("time", timetable[k].time, before, kLongest),
                              inRange("count", timetable[k].count, 1, kMaxCharacters)});
            !s.ok())
            return s.within(where);
        before = timetable[k].time;
    }
    return {};
}

// What is drawn is 0, which stands for a parameter, or in its range.
Status isDistribution(const char* what, const Distribution& drawn, double low, double high) {
    const auto check = [&]() -> Status {
        if (drawn.spread > Spread::Weibull) return invalidArgument("its kind is not known");
        if (Status s = first({inRange("a", drawn.a, -1e9, 1e9), inRange("b", drawn.b, -1e9, 1e9),
                              inRange("least", drawn.least, 0.0, 1e9),
                              inRange("most", drawn.most, drawn.least, 1e9)});
            !s.ok())
            return s;
        const Spread spread = drawn.spread;
        if (spread == Spread::Constant) return isOwn("a", drawn.a, low, high);
        if (spread == Spread::Uniform && drawn.b < drawn.a)
            return invalidArgument("b is " + numberText(drawn.b) + ", expected a number of at least a, " +
                                   numberText(drawn.a));
        const bool scaled = spread == Spread::Gamma || spread == Spread::Weibull;
        if (scaled && !(drawn.a >= 1e-6 && drawn.b >= 1e-6))
            return invalidArgument("shape and scale are to be 1e-6 or more");
        if (spread == Spread::Gamma && !(drawn.a <= kMostShape))
            return invalidArgument("a is " + numberText(drawn.a) + ", expected a shape of at most " +
                                   numberText(kMostShape));
        if ((spread == Spread::Normal || spread == Spread::LogNormal) && drawn.b < 0.0)
            return invalidArgument("b is " + numberText(drawn.b) + ", expected a deviation of 0 or more");
        if (spread == Spread::LogNormal && !(std::max(drawn.a, drawn.b) <= 50.0))
            return invalidArgument("the numbers of the logarithm are to be 50 or less");
        const double lowest = drawn.quantile(1e-9), highest = drawn.quantile(1.0 - 1e-9);
        if (lowest >= low && highest <= high) return {};
        return invalidArgument("it reaches from " + numberText(lowest) + " to " + numberText(highest) +
                               ", expected numbers in [" + numberText(low) + ", " + numberText(high) +
                               "]; least and most cut it off");
    };
    return check().within(what);
}

}  // namespace

Status validateArea(const AreaDef& area) {
    if (area.kind > AreaKind::Waiting) return invalidArgument("kind is not known");
    if (Status s = first({validateName(area.name), validateShape("polygon", area.polygon),
                          inRange("rate", area.rate, 0.0, kMostRate), arePlaces("queue", area.queue),
                          inRange("from", area.from, 0.0, kLongest),
                          inRange("until", area.until, area.from, kLongest),
                          inRange("most", area.most, 0, kMaxCharacters), isTimetable(area.timetable)});
        !s.ok())
        return s;
    if (!area.queue.empty() && (area.kind != AreaKind::Exit || area.queue.size() < 2))
        return invalidArgument("a queue is a line of two or more points before an exit");
    if (!area.timetable.empty() && area.kind != AreaKind::Source)
        return invalidArgument("only a source has a timetable");
    return {};
}

Status validatePeople(const std::vector<PeopleDef>& people) {
    if (people.size() > kMaxSorts)
        return {StatusCode::LimitExceeded, "people: there are more than 100 sorts"};
    for (std::size_t k = 0; k < people.size(); ++k) {
        const PeopleDef& sort = people[k];
        const Status s = first({validateName(sort.name), inRange("share", sort.share, 1e-9, 1e9),
                                isDistribution("speed", sort.speed, 0.01, 50.0),
                                isDistribution("radius", sort.radius, 0.05, 1.5),
                                isDistribution("headway", sort.headway, 0.02, 5.0),
                                isDistribution("premovement", sort.premovement, 0.0, 1e7),
                                isDistribution("age", sort.age, 5.0, 90.0),
                                isOwn("upstairs", sort.upstairs, 0.01, 1.0),
                                isOwn("downstairs", sort.downstairs, 0.01, 1.0)});
        if (!s.ok()) return s.within("people[" + std::to_string(k) + "]");
    }
    return {};
}

}  // namespace muster
