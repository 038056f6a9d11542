// The fields of sorts of persons and of areas in scenario and gesture files.
#pragma once

#include <string>
#include <vector>

#include "files/scenario/describe_units.h"
#include "muster/area.h"
#include "muster/people.h"

namespace muster {

inline constexpr const char* kAdultsWord = "adults";  ///< Stands for adults().

/// The fields of a distribution; the enclosing key may also hold the number that everybody has.
template <class Visitor>
void describeDistribution(Visitor& v, Distribution& drawn) {
    constexpr NumberRange kAny{-1e9, 1e9};
    describeWord(v, "spread", drawn.spread, kSpreadWords, "Its kind.", Need::Required);
    v.number("a", drawn.a, kAny,
             "The value of all, the least, the mean, the logarithm's mean, the shape, or Weibull's scale.");
    v.number("b", drawn.b, kAny, "The most, the deviation, the logarithm's, the scale, or Weibull's shape.");
    v.number("least", drawn.least, {0.0, 1e9}, "What lies below does not occur.");
    v.number("most", drawn.most, {0.0, 1e9}, "What lies above does not occur.");
}

/// True where a number says it all.
bool isPlainNumber(const Distribution& drawn);

void describeDrawn(FieldReader& v, const char* key, Distribution& drawn, const char* unit, const char* about);
void describeDrawn(FieldWriter& v, const char* key, Distribution& drawn, const char* unit, const char* about);
void describeDrawn(FieldSchema& v, const char* key, Distribution& drawn, const char* unit, const char* about);

/// The fields of one sort of persons.
template <class Visitor>
void describeSort(Visitor& v, PeopleDef& sort) {
    v.text("name", sort.name, "For people.");
    v.number("share", sort.share, {1e-9, 1e9}, "Of the group; shares are divided by their sum.");
    v.whole("class", sort.unitClass, {0.0, 255.0}, "For roles; 0 for none.");
    describeDrawn(v, "speed", sort.speed, "m/s", "Top speed in the open.");
    describeDrawn(v, "radius", sort.radius, "m", "Radius of the body.");
    describeDrawn(v, "headway", sort.headway, "s", "Time that it keeps from who is ahead.");
    describeDrawn(v, "premovement", sort.premovement, "s", "Until it sets out on its first order.");
    describeDrawn(v, "age", sort.age, "years", "Above 0 it gives the speed, as RiMEA has it.");
    describeOwnShare(v, "upstairs", sort.upstairs, kUpstairs);
    describeOwnShare(v, "downstairs", sort.downstairs, kDownstairs);
}

void describePeople(FieldReader& v, std::vector<PeopleDef>& people);
void describePeople(FieldWriter& v, std::vector<PeopleDef>& people);
void describePeople(FieldSchema& v, std::vector<PeopleDef>& people);

/// An area without the group of a source, which is put by `putGroup()`.
template <class Visitor, class PutGroup>
void describeArea(Visitor& v, AreaDef& area, PutGroup putGroup) {
    const AreaDef usual;
    v.text("name", area.name, "Shown on its tag.");
    describeWord(v, "kind", area.kind, kAreaKindWords, "What it does.", Need::Required);
    v.points("polygon", area.polygon, 3, kMaxCorners, "Its corners.", Need::Required);
    v.flag("open", area.open, "False: nobody leaves or comes here for now.");
    v.number("rate", area.rate, {0.0, 1000.0, "1/s"},
             "For exit: the most who leave, 0 for as many as come. For source: how many come on average.");
    v.points("queue", area.queue, 2, kMaxCorners,
             "For exit: the line in which people queue, from who is next to the last.");
    putGroup();
    if (takesPart<Visitor>(area.from != usual.from))
        v.number("from", area.from, kTime,
                 "For exit: when it opens. For source with a rate: when it begins.");
    if (takesPart<Visitor>(area.until != usual.until))
        v.number("until", area.until, kTime,
                 "For exit: when it closes. For source with a rate: when it ends.");
    if (takesPart<Visitor>(area.most != usual.most))
        v.whole("most", area.most, {0.0, kMaxCharacters}, "For source with a rate: in all; 0 for no end.");
    v.list("timetable", area.timetable, kMaxCorners, "For source: further people, by ascending times.",
           [](auto& item, Arrivals& arrivals) {
               item.number("t", arrivals.time, kTime, "When.", Need::Required);
               item.whole("count", arrivals.count, {1.0, kMaxCharacters}, "How many.", Need::Required);
           });
}

template <class Visitor>
void describeArea(Visitor& v, AreaDef& area, std::size_t groups) {
    describeArea(v, area, [&] {
        if (!takesPart<Visitor>(area.kind == AreaKind::Source || area.group != 0)) return;
        const double most = Visitor::kSchema ? static_cast<double>(kMaxGroups) - 1.0
                                             : static_cast<double>(groups) - 1.0;
        v.whole("group", area.group, {0.0, most},
                "For source: index of the group whom its people join, from 0.");
    });
}

}  // namespace muster
