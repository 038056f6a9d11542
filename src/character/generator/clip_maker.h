// Turns functions of time into clips.
#pragma once

#include <functional>
#include <string>

#include "character/generator/course.h"
#include "character/generator/leg_track.h"
#include "muster/clip.h"

namespace muster::generator {

inline constexpr double kFrameRate = 60.0;  ///< Frames a second of every clip.

/// What a clip is made of.
struct ClipDef {
    std::string name;
    std::string motion;
    bool cyclic = false;
    int frames = 60;                          ///< Intervals between poses in one play.
    std::function<Figure(double)> figure;     ///< In the travelling frame, by time [s].
    std::function<Placement(double)> travel;  ///< Starts at the ground's origin.
    std::vector<Contact> contacts;            ///< In any order.
    double entryPhase = 0.0;
    double exitPhase = 0.0;
    ClipObstacle obstacle;
};

/// The clip.
Clip makeClip(ClipDef plan);

/// Adds a foot's stays that reach into the clip; in a cyclic one those that begin in it.
void addContacts(std::vector<Contact>& contacts, std::size_t side, const std::vector<Step>& steps,
                 double duration, bool cyclic);

}  // namespace muster::generator
