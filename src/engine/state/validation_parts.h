// Checks of single values, which validations are made of, and numbers in messages.
#pragma once

#include <cstdio>
#include <initializer_list>
#include <span>
#include <string>

#include "muster/obstacle.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// Fails unless `low` <= value <= `high`.
Status inRange(const char* what, double value, double low, double high);
/// The same for a number of a body or a person, where 0 stands for another one.
Status isOwn(const char* what, double value, double low, double high);
/// Fails where a position is not finite or too far away.
Status isPlace(const char* what, Vec2 p);
/// Fails where one of the positions is, or there are too many.
Status arePlaces(const char* what, std::span<const Vec2> points);
/// Fails where a path is bad.
Status isPath(const TimedPath& path);
/// The first failure of several checks.
Status first(std::initializer_list<Status> checks);

/// A number as people write it.
inline std::string numberText(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.6g", value);
    return buffer;
}

}  // namespace muster
