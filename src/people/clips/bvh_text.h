// BVH text written frame by frame.
#pragma once

#include <array>
#include <string>

#include "muster/clip.h"

namespace muster {

/// Writes poses of Muster's skeleton as BVH, frame by frame.
class BvhFrameWriter {
public:
    /// Writes for a body of this size; 1 is the skeleton's own size.
    explicit BvhFrameWriter(float size = 1.0f) : size_(size) {}

    /// The file's text up to and including the word MOTION.
    std::string hierarchy() const;
    /// The two lines after it. The number of frames has a fixed width of 10 columns, so that it can be
    /// overwritten later.
    static std::string motionHead(std::size_t frames, double rate);
    /// Appends one frame to `text`: the root on the ground [m, rad] and the pose, whose hips are those of a
    /// body of size 1. Angles continue those of the previous frame without jumps of 360 degrees.
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
