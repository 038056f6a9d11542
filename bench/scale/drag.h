// Two fingers that drag a formation along a course.
#pragma once

#include "muster/world.h"
#include "scale/crowd_scenes.h"

namespace muster::scale {

/// Drags the first group of a world as a user would: two fingers on its flanks, moved 20 times a second.
class Drag {
public:
    /// Drags along `course`; `side` is that of the formation [m].
    Drag(const Course& course, double side) : course_(course), side_(side) {}
    /// Submits the touches of the coming step; must be called before each step. Fails as World::submit does.
    Status before(World& world);

private:
    Status give(World& world, CommandBody body);

    Course course_;
    double side_;
    std::uint32_t sequence_ = 0;
};

}  // namespace muster::scale
