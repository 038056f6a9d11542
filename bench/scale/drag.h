// Two fingers that lead a formation along a course.
#pragma once

#include "muster/world.h"
#include "scale/scenes.h"

namespace muster::scale {

/// Drags the first group of a world as a user would: two fingers on its flanks, moved 20 times a second.
class Drag {
public:
    /// Along this course; `side` is the formation's [m].
    Drag(const Course& course, double side) : course_(course), side_(side) {}
    /// Submits what the fingers do in the coming step; call before each step. Fails where the world refuses.
    Status before(World& world);

private:
    Status give(World& world, CommandBody body);

    Course course_;
    double side_;
    std::uint32_t sequence_ = 0;
};

}  // namespace muster::scale
