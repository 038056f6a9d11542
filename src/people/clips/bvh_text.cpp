#include <array>
#include <cmath>
#include <cstdio>

#include "base/maths.h"
#include "muster/clip.h"
#include "people/clips/bvh_text.h"

namespace muster {
namespace {

constexpr double kCentimetres = 100.0;  // Centimetres per metre.
constexpr double kDegrees = 180.0 / kPi;

/// The OFFSET line of a point in Muster's axes. The file's (X, Y, Z) are Muster's (y, z, x).
std::string offsetLine(Vec3 p, float size, const std::string& indent) {
    char text[96];
    const double scale = kCentimetres * static_cast<double>(size);
    std::snprintf(text, sizeof(text), "OFFSET %.6f %.6f %.6f\n", p.y * scale, p.z * scale, p.x * scale);
    return indent + text;
}

void putJoint(std::size_t joint, std::size_t depth, float size, std::string& text) {
    const auto& bones = skeleton();
    const std::string outer(depth, '\t'), inner(depth + 1, '\t');
    text += outer + "JOINT " + bones[joint].name + "\n" + outer + "{\n";
    const bool hips = joint == 0;
    text += offsetLine(hips ? Vec3{} : bones[joint].offset, size, inner);
    text += inner + (hips ? "CHANNELS 6 Xposition Yposition Zposition " : "CHANNELS 3 ") +
            "Zrotation Xrotation Yrotation\n";
    bool leaf = true;
    for (std::size_t child = joint + 1; child < kJointCount; ++child) {
        if (bones[child].parent != static_cast<std::int32_t>(joint)) continue;
        putJoint(child, depth + 1, size, text);
        leaf = false;
    }
    if (leaf)
        text += inner + "End Site\n" + inner + "{\n" + offsetLine(bones[joint].tip, size, inner + "\t") +
                inner + "}\n";
    text += outer + "}\n";
}

/// The angle plus the multiple of 360 degrees that brings it nearest to `before`.
double nearest(double angle, double before) {
    return angle + 2.0 * kPi * std::floor((before - angle) / (2.0 * kPi) + 0.5);
}

}  // namespace

std::string BvhFrameWriter::hierarchy() const {
    // The offset of the hips is zero, because some programs add it to the position channels and others
    // replace it by them.
    std::string text = "HIERARCHY\nROOT Root\n{\n" + offsetLine({}, size_, "\t") +
                       "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
    putJoint(0, 1, size_, text);
    return text + "}\nMOTION\n";
}

std::string BvhFrameWriter::motionHead(std::size_t frames, double rate) {
    char text[96];
    std::snprintf(text, sizeof(text), "Frames: %-10zu\nFrame Time: %.9f\n", frames, 1.0 / rate);
    return text;
}

BvhFrameWriter::Angles BvhFrameWriter::anglesOf(Quat rotation, const Angles& before) {
    // R = Rz Rx Ry in the file's axes, where the vector part of a quaternion is permuted as points are.
    const double w = rotation.w, x = rotation.y, y = rotation.z, z = rotation.x;
    const double n = 1.0 / (w * w + x * x + y * y + z * z);
    const double r00 = 1.0 - 2.0 * n * (y * y + z * z), r01 = 2.0 * n * (x * y - w * z),
                 r02 = 2.0 * n * (x * z + w * y);
    const double r10 = 2.0 * n * (x * y + w * z), r11 = 1.0 - 2.0 * n * (x * x + z * z),
                 r12 = 2.0 * n * (y * z - w * x);
    const double r21 = 2.0 * n * (y * z + w * x);
    // The rotation about z comes first. If that about x is a right angle (gimbal lock), z keeps its previous
    // angle.
    Angles best;
    double least = 1e9;
    const bool upright = std::fabs(r01) + std::fabs(r11) > 1e-6;
    const double first = upright ? arcTangent2(-r01, r11) : before.z;
    for (int other = 0; other < 2; ++other) {
        // The other angles follow from Rz^-1 R, which is well conditioned near gimbal lock too.
        const double a = first + other * kPi, c = cosine(a), s = sine(a);
        const Angles found{nearest(a, before.z), nearest(arcTangent2(r21, c * r11 - s * r01), before.x),
                           nearest(arcTangent2(c * r02 + s * r12, c * r00 + s * r10), before.y)};
        const double change = std::fabs(found.z - before.z) + std::fabs(found.x - before.x) +
                              std::fabs(found.y - before.y);
        if (change >= least) continue;
        least = change;
        best = found;
    }
    return best;
}

void BvhFrameWriter::put(double value, std::string& text) {
    char buffer[40];
    const int length = std::snprintf(buffer, sizeof(buffer), "%.6f ", value);
    text.append(buffer, static_cast<std::size_t>(length));
}

void BvhFrameWriter::putAngles(const Angles& angles, std::string& text) {
    put(angles.z * kDegrees, text);
    put(angles.x * kDegrees, text);
    put(angles.y * kDegrees, text);
}

void BvhFrameWriter::append(const Travel& root, const BodyPose& pose, std::string& text) {
    rootTurn_ = nearest(root.yaw, rootTurn_);
    put(root.y * kCentimetres, text);
    put(0.0, text);
    put(root.x * kCentimetres, text);
    putAngles({0.0, 0.0, rootTurn_}, text);
    const double scale = kCentimetres * static_cast<double>(size_);
    put(pose.hips.y * scale, text);
    put(pose.hips.z * scale, text);
    put(pose.hips.x * scale, text);
    // Joints are written in the order of the hierarchy, which is the skeleton's: depth first, parents before
    // children.
    for (std::size_t j = 0; j < kJointCount; ++j) {
        before_[j] = anglesOf(pose.rotation[j], before_[j]);
        putAngles(before_[j], text);
    }
    text.back() = '\n';
}

std::string bvhText(const Clip& clip) {
    BvhFrameWriter writer;
    const std::size_t frames = clip.poses.size() + (clip.cyclic ? 1 : 0);
    std::string text = writer.hierarchy() + BvhFrameWriter::motionHead(frames, clip.rate);
    for (std::size_t f = 0; f < frames; ++f)
        writer.append(clip.travel[f], clip.poses[f % clip.poses.size()], text);
    return text;
}

}  // namespace muster
