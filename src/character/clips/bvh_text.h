// BVH text written frame by frame.
#pragma once

#include <array>
#include <string>

#include "muster/clip.h"

namespace muster {

/// Writes poses of Muster's skeleton as BVH, frame by frame.
class BvhFrameWriter {
public:
    /// For a body of that size, 1 for the skeleton's own.
    explicit BvhFrameWriter(float size = 1.0f) : size_(size) {}

    /// The file up to the word MOTION, that included.
    std::string hierarchy() const;
    /// The two lines behind it; the number of frames takes 10 columns, so that it can be written again in
    /// place.
    static std::string motionHead(std::size_t frames, double rate);
    /// Adds one line to `text`: the root on the ground [m, rad], and the pose, hips as for a body of size 1.
    /// Angles go on from those of the line before without jumps.
    void append(const Travel& root, const BodyPose& pose, std::string& text);

private:
    struct Angles {
        double z = 0.0, x = 0.0, y = 0.0;
    };
    static Angles anglesOf(Quat rotation, const Angles& before);
    static void put(double value, std::string& text);
    static void putAngles(const Angles& angles, std::string& text);

    float size_ = 1.0f;
    double rootTurn_ = 0.0;
    std::array<Angles, kJointCount> before_{};
};

}  // namespace muster
