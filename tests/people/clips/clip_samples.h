// Motions for tests: a made-up clip, files built by hand, and real recordings where they are at hand.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "base/maths.h"
#include "base/text_file.h"
#include "muster/clip.h"
#include "test_folders.h"

namespace muster::testing {

/// Somebody who swings all joints about changing axes and goes in a curve.
inline Clip wavingClip(bool cyclic, std::size_t frames = 30) {
    Clip clip{.name = "wave", .motion = "run", .cyclic = cyclic};
    for (std::size_t f = 0; f < frames; ++f) {
        const double turn = 2.0 * kPi * static_cast<double>(f) /
                            static_cast<double>(cyclic ? frames : frames - 1);
        BodyPose pose = restPose();
        pose.hips = {0.02f * static_cast<float>(sine(turn)), 0.01f,
                     0.9f + 0.03f * static_cast<float>(cosine(turn))};
        for (std::size_t j = 0; j < kJointCount; ++j) {
            const double k = static_cast<double>(j);
            const Vec3 axis = normalized(Vec3{static_cast<float>(sine(k)),
                                              static_cast<float>(cosine(1.7 * k)),
                                              static_cast<float>(sine(2.3 * k + 1.0))});
            pose.rotation[j] = axisAngle(axis, 1.2 * sine(turn + k));
        }
        clip.poses.push_back(pose);
    }
    for (std::size_t f = 0; f < frames + (cyclic ? 1 : 0); ++f) {
        const float at = static_cast<float>(f) / static_cast<float>(frames);
        clip.travel.push_back({1.5f * at, 0.3f * at * at, 0.2f * at});
    }
    return clip;
}

/// The largest differences between two clips.
struct ClipDifference {
    double place = 0.0;  ///< Of hips and travel [m].
    double turn = 0.0;   ///< Of joints and travel [rad].
};

inline ClipDifference differenceOf(const Clip& a, const Clip& b) {
    ClipDifference most;
    for (std::size_t f = 0; f < a.poses.size(); ++f) {
        most.place = std::max(most.place, static_cast<double>(distance(a.poses[f].hips, b.poses[f].hips)));
        for (std::size_t j = 0; j < kJointCount; ++j)
            most.turn = std::max(most.turn, angleBetween(a.poses[f].rotation[j], b.poses[f].rotation[j]));
    }
    for (std::size_t f = 0; f < a.travel.size(); ++f) {
        most.place = std::max({most.place, std::fabs(static_cast<double>(a.travel[f].x) - b.travel[f].x),
                               std::fabs(static_cast<double>(a.travel[f].y) - b.travel[f].y)});
        most.turn = std::max(most.turn, std::fabs(static_cast<double>(a.travel[f].yaw) - b.travel[f].yaw));
    }
    return most;
}

/// A person's skeleton for files made by hand: names of hips, spine, head, then left and right thigh, shin,
/// foot.
struct HandMade {
    std::array<std::string, 9> names{"Hips",     "Spine",      "Head",     "LeftUpLeg", "LeftLeg",
                                     "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"};
    double scale = 1.0;  ///< Units in a metre.
    bool zUp = false;    ///< Else Y.
    std::string motion = "Frames: 3\nFrame Time: 0.05\n";
    std::size_t frames = 3;

    /// "x y z" of a place given as left, up, ahead [m].
    std::string place(double left, double up, double ahead) const {
        char text[96];
        std::snprintf(text, sizeof(text), "%.6g %.6g %.6g", left * scale, (zUp ? -ahead : up) * scale,
                      (zUp ? up : ahead) * scale);
        return text;
    }
    std::string limb(std::size_t first, double side) const {
        std::string text = "JOINT " + names[first] + " { OFFSET " + place(side, -0.05, 0) +
                           " CHANNELS 3 Zrotation Xrotation Yrotation\n";
        text += "JOINT " + names[first + 1] + " { OFFSET " + place(0, -0.42, 0) +
                " CHANNELS 3 Zrotation Xrotation Yrotation\n";
        text += "JOINT " + names[first + 2] + " { OFFSET " + place(0, -0.41, 0) +
                " CHANNELS 3 Zrotation Xrotation Yrotation\n";
        return text + "End Site { OFFSET " + place(0, -0.06, 0.15) + " } } } }\n";
    }
    /// The file; the hips go 1 m ahead in every frame.
    std::string text() const {
        std::string out = "HIERARCHY\nROOT " + names[0] +
                          "\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
                          "Yrotation\n";
        out += "JOINT " + names[1] + " { OFFSET " + place(0, 0.1, 0) +
               " CHANNELS 3 Zrotation Xrotation Yrotation\n";
        out += "JOINT " + names[2] + " { OFFSET " + place(0, 0.5, 0) +
               " CHANNELS 3 Zrotation Xrotation Yrotation\n";
        out += "End Site { OFFSET " + place(0, 0.2, 0) + " } } }\n" + limb(3, 0.09) + limb(6, -0.09) +
               "}\nMOTION\n" + motion;
        for (std::size_t f = 0; f < frames; ++f) {
            out += place(0.0, 0.95, static_cast<double>(f));
            for (int j = 0; j < 9; ++j) out += " 0 0 0";
            out += "\n";
        }
        return out;
    }
};

inline std::string mocapFolder() {
    return sourceFolder() + "/../shared/mocap";
}

/// Names of the recordings without ".bvh", in order; empty where they are not at hand.
inline std::vector<std::string> mocapNames() {
    std::vector<std::string> names;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(mocapFolder(), missing))
        if (entry.path().extension() == ".bvh") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    if (names.empty()) std::printf("skipped: the recordings in shared/mocap are not there\n");
    return names;
}

}  // namespace muster::testing
