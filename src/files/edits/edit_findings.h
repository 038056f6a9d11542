// What is wrong with edited paths: overlaps with others and with obstacles, and speeds that nobody has.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "muster/take.h"

namespace muster {

class Environment;

/// Where somebody went in the recording.
struct RecordedPath {
    std::uint32_t person = 0;  ///< Id.
    double radius = 0.25;      ///< Of the body [m].
    double topSpeed = 2.0;     ///< [m/s]
    double first = 0.0;        ///< Time of the first point [s].
    std::vector<Vec2> points;  ///< At even times [m].
};

/// The kinds of findings.
enum class FindingKind : std::uint8_t {
    Person,    ///< Overlaps with somebody.
    Obstacle,  ///< Goes through an obstacle that stands still.
    Outside,   ///< Leaves the ground.
    Speed,     ///< Is faster than the person can go.
};

/// Something wrong with the path of an edited person.
struct EditFinding {
    std::uint32_t person = 0;                ///< Whose path.
    FindingKind kind = FindingKind::Person;  ///< What.
    std::uint32_t other = 0;                 ///< Id of the other person or the obstacle.
    double from = 0.0, to = 0.0;             ///< Times in the take [s].
    Vec2 where;                              ///< Where it is worst [m].
    double worst = 0.0;                      ///< Depth of the overlap [m], or the speed [m/s].
    std::string text;                        ///< In words, without the person.
};

/// Looks along the edited paths, in steps of a tenth of a second and only where they differ from the recorded
/// ones. `paths` in ascending order of ids, with points `spacing` [s] apart, up to `end` [s] of the take. Of
/// a person there are at most 20 findings, the first ones.
std::vector<EditFinding> findTroubles(const std::vector<TakeEdit>& edits, std::span<const RecordedPath> paths,
                                      double spacing, double end, const Environment& environment);

/// Where pins of these paths have to be, so that nobody of the edit is in an obstacle there: each is moved by
/// the least that one of its people needs.
void keepClear(TakeEdit& edit, std::span<const RecordedPath> paths, double spacing,
               const Environment& environment);

}  // namespace muster
