#include "people/bodies/sculptor.h"

#include <algorithm>

#include "base/maths.h"

namespace muster::bodies {

void Sculptor::makeNeckAndHead() {
    Ring below;
    for (const Section& cut : shape_.neck) {
        if (!wanted(cut)) continue;
        const Ring ring = mesh_.add(levelRing(cut, detail_.arm), kBareNeck);
        if (!below.empty()) mesh_.bridge(below, ring);
        below = ring;
    }
    below.clear();
    for (const Section& cut : shape_.head) {
        if (!wanted(cut)) continue;
        const Ring ring = mesh_.add(levelRing(cut, detail_.head), kFace);
        if (below.empty())
            mesh_.cap(ring, mesh_.middle(ring) + Vec3{0.0f, 0.0f, -0.004f}, kFace, false);
        else
            mesh_.bridge(below, ring);
        below = ring;
    }
    if (detail_.fine) makeNoseAndEars();
}

void Sculptor::makeNoseAndEars() {
    const float x = sectionAt(1.58f).front;
    const Ring nose = mesh_.add(std::array{Vec3{x - 0.002f, 0.0f, 1.622f}, Vec3{x - 0.004f, -0.016f, 1.576f},
                                           Vec3{x - 0.002f, 0.0f, 1.566f}, Vec3{x - 0.004f, 0.016f, 1.576f}},
                                kFace);
    const std::uint32_t tip = mesh_.add(Vec3{x + 0.021f, 0.0f, 1.582f}, kFace);
    for (std::size_t i = 0; i < 4; ++i) mesh_.triangle(nose[(i + 1) % 4], nose[i], tip);
    for (const bool right : {false, true}) {
        mesh_.setMirrored(right);
        const float y = sectionAt(1.6f).side;
        const std::array path{Vec3{0.004f, y - 0.006f, 1.598f}, Vec3{-0.004f, y + 0.012f, 1.602f}};
        tube(path, std::array{0.024f, 0.030f}, {-0.008f, y + 0.014f, 1.604f}, 6, kFace, 0.62f);
    }
    mesh_.setMirrored(false);
}

Section Sculptor::sectionAt(float height) const {
    std::size_t s = 1;
    while (s + 1 < shape_.head.size() && shape_.head[s].along < height) ++s;
    const Section &a = shape_.head[s - 1], &b = shape_.head[s];
    const float t = (height - a.along) / (b.along - a.along);
    return {height, a.side + (b.side - a.side) * t, a.front + (b.front - a.front) * t,
            a.back + (b.back - a.back) * t};
}

float Sculptor::hairline(double angle) const {
    const double turn = angle > kPi ? 2.0 * kPi - angle : angle;
    constexpr double kBrow = 0.75, kTemple = 1.25;
    const float brow = detail_.fine ? 1.690f : 1.674f;
    if (turn <= kBrow) return brow;
    if (turn <= kTemple)
        return brow + (shape_.hairSides - brow) * static_cast<float>((turn - kBrow) / (kTemple - kBrow));
    const float t = std::min(1.0f, static_cast<float>((turn - kTemple) / (2.45 - kTemple)));
    return shape_.hairSides + (shape_.hairNape - shape_.hairSides) * t;
}

void Sculptor::makeHair() {
    // A row of hair: its distance outwards from the head by the share of the height from hairline to crown.
    struct Row {
        float share, out;
    };
    static constexpr std::array kRows{Row{0.0f, -0.35f}, Row{0.02f, 0.7f}, Row{0.3f, 1.0f}, Row{0.62f, 1.05f},
                                      Row{0.9f, 1.0f}};
    const float crown = 1.733f;
    Ring below;
    for (std::size_t r = detail_.fine ? 0 : 1; r < kRows.size(); r += detail_.fine ? 1 : 2) {
        std::vector<Vec3> points;
        for (std::size_t k = 0; k < detail_.head; ++k) {
            const double angle = angleOf(k, detail_.head);
            const float line = hairline(angle);
            const Section cut = sectionAt(line + (crown - line) * kRows[r].share);
            const Vec3 p = levelPoint(cut, angle, widening(detail_.head));
            const Vec3 out = normalized(p - Vec3{0.005f, 0.0f, 1.62f});
            points.push_back(p + out * (shape_.hairThick * kRows[r].out));
        }
        const Ring ring = mesh_.add(points, kHeadHair);
        if (!below.empty()) mesh_.bridge(below, ring);
        below = ring;
    }
    mesh_.cap(below, {-0.004f, 0.0f, 1.742f + shape_.hairThick * 0.6f}, kHeadHair);
    if (shape_.tied) makeTail();
}

void Sculptor::makeTail() {
    const std::array path{Vec3{-0.080f, 0.0f, 1.672f}, Vec3{-0.118f, 0.0f, 1.668f},
                          Vec3{-0.150f, 0.0f, 1.635f}, Vec3{-0.160f, 0.0f, 1.575f},
                          Vec3{-0.146f, 0.0f, 1.505f}};
    const std::array radii{0.026f, 0.020f, 0.036f, 0.038f, 0.026f};
    if (detail_.fine)
        tube(path, radii, {-0.128f, 0.0f, 1.452f}, 7, kHeadHair);
    else
        tube(std::array{path[1], path[3]}, std::array{0.026f, 0.038f}, {-0.128f, 0.0f, 1.452f}, 3, kHeadHair);
}

}  // namespace muster::bodies
