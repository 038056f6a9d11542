// Samples functions of time into clips.
#pragma once

#include <functional>
#include <string>

#include "muster/clip.h"
#include "people/generator/course.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

inline constexpr double kFrameRate = 60.0;  ///< Frames per second of every clip.

/// The description of a clip as functions of time.
struct ClipDef {
    std::string name;                      ///< Name of the clip.
    std::string motion;                    ///< Name of the clip's motion.
    bool cyclic = false;                   ///< True if it repeats.
    int frames = 60;                       ///< Number of frame intervals in one play.
    std::function<Figure(double)> figure;  ///< Figure in the travelling frame by time [s].
    /// Travelling frame by time [s]; it starts at the origin of the ground.
    std::function<Placement(double)> travel;
    std::vector<Contact> contacts;  ///< Contacts in any order.
    double entryPhase = 0.0;        ///< Entry phase as in Clip::entryPhase.
    double exitPhase = 0.0;         ///< Exit phase as in Clip::exitPhase.
    ClipObstacle obstacle;          ///< Obstacle that the clip crosses, if any.
};

/// Samples the description into a clip.
Clip makeClip(ClipDef plan);

/// Adds the contacts of a foot's steps that overlap the clip. A cyclic clip gets the steps that begin in it.
void addContacts(std::vector<Contact>& contacts, std::size_t side, const std::vector<Step>& steps,
                 double duration, bool cyclic);

}  // namespace muster::generator
