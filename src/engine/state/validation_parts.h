// Checks of single values, which validations are made of, and numbers in messages. Each fails with
// InvalidArgument or LimitExceeded, naming the field `what`.
#pragma once

#include <cstdio>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/state/generated/definition_checks.h"

namespace muster {

/// A number as people write it.
inline std::string numberText(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.6g", value);
    return buffer;
}

/// A number from `low` to `high`.
Status inRange(const char* what, double value, double low, double high);
/// The same for a number of a body or a person, where 0 stands for another one.
Status isOwn(const char* what, double value, double low, double high);
/// The same for a number that stands for another one where it is negative.
Status isOwnOrNegative(const char* what, double value, double low, double high);
/// True of a position that is finite and not too far away: NaN is not.
bool isInWorld(Vec2 p);
/// Such a position.
Status isPlace(const char* what, Vec2 p);
/// At most so many of them.
Status arePlaces(const char* what, std::span<const Vec2> points, std::size_t most);
/// A text that is not too long.
Status isText(const char* what, const std::string& value);
/// A simple polygon.
Status isShape(const char* what, std::span<const Vec2> corners);
/// The same, or no corners.
Status isShapeOrNone(const char* what, std::span<const Vec2> corners);
/// A path whose times rise.
Status isPath(const TimedPath& path);
/// A distribution of which all that is drawn lies from `low` to `high`, or is 0, which stands for a
/// parameter.
Status isDistribution(const char* what, const Distribution& drawn, double low, double high);
/// The first failure of several checks.
Status first(std::initializer_list<Status> checks);

/// A value of an enumeration.
template <class Enum>
Status isKnown(Enum value, Enum last, const char* called) {
    return value <= last ? Status{} : invalidArgument(std::string(called) + " is not known");
}
/// The same, or none.
template <class Enum>
Status isKnown(const std::optional<Enum>& value, Enum last, const char* called) {
    return value ? isKnown(*value, last, called) : Status{};
}

/// A list that is not too long.
Status atMost(const char* what, std::size_t count, std::size_t most);
/// The same, of numbers from `low` to `high`.
Status eachInRange(const char* what, std::span<const double> values, std::size_t most, double low,
                   double high);
/// The same, of definitions; the message names the index.
template <class Item>
Status each(const char* what, const std::vector<Item>& items, std::size_t most) {
    if (Status s = atMost(what, items.size(), most); !s.ok()) return s;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (Status s = validate(items[i]); !s.ok())
            return s.within(std::string(what) + "[" + std::to_string(i) + "]");
    return {};
}
/// A definition that may be none, by a check of its own.
template <class Definition, class Check>
Status checkIfAny(const std::optional<Definition>& definition, const Check& check) {
    return definition ? check(*definition) : Status{};
}
/// The same by the check of all of its kind.
template <class Definition>
Status validateIfAny(const std::optional<Definition>& definition) {
    return checkIfAny(definition, [](const Definition& def) { return validate(def); });
}

}  // namespace muster
