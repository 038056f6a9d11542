#include "lab/picture/pose_strip.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/maths.h"
#include "lab/picture/debug_draw.h"

namespace muster {
namespace {

constexpr double kTopMargin = 0.15;     // Margin of a row above the highest head [m].
constexpr double kGroundDepth = 0.45;   // Visible depth below the ground [m].
constexpr double kPoolDepth = 1.0;      // Visible depth below a pool's rim [m].
constexpr double kTitleHeight = 0.3;    // Height of the title [m].
constexpr double kWaterHeight = -0.10;  // Height of the water [m].

/// A parallel projection.
struct View {
    Vec3 right, up, towards;  // Axes of the screen, and the direction towards the eye.

    Vec2 flat(Vec3 p) const { return {dot(p, right), dot(p, up)}; }
    float depth(Vec3 p) const { return dot(p, towards); }
};

View viewFrom(double yaw, double rise) {
    const auto c = static_cast<float>(cosine(yaw)), s = static_cast<float>(sine(yaw));
    const auto cr = static_cast<float>(cosine(rise)), sr = static_cast<float>(sine(rise));
    return {{-s, c, 0.0f}, {-sr * c, -sr * s, cr}, {cr * c, cr * s, sr}};
}

/// A part of the body: a capsule with two radii.
struct Part {
    Vec3 a, b;
    float ra, rb;  // Radii at both ends [m].
    Colour colour;
};

Colour mixed(Colour a, Colour b, double t) {
    const auto part = [t](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(x + (y - x) * t);
    };
    return {part(a.red, b.red), part(a.green, b.green), part(a.blue, b.blue), a.opacity};
}

/// The convex outline of two discs.
std::vector<Vec2> outline(Vec2 a, Vec2 b, double ra, double rb) {
    const Vec2 offset = b - a;
    const double d = std::sqrt(offset.x * offset.x + offset.y * offset.y);
    std::vector<Vec2> loop;
    const bool separate = d > std::fabs(ra - rb) + 1e-6;
    const double heading = separate ? arcTangent2(offset.y, offset.x) : 0.0;
    const double tilt = separate
                            ? arcTangent2(std::sqrt(std::max(0.0, d * d - (ra - rb) * (ra - rb))), ra - rb)
                            : kPi;
    const auto arc = [&](Vec2 centre, double radius, double from, double to) {
        for (int i = 0; i <= 12; ++i) {
            const double angle = from + (to - from) * i / 12.0;
            loop.push_back({centre.x + radius * cosine(angle), centre.y + radius * sine(angle)});
        }
    };
    if (!separate) {
        arc(ra > rb ? a : b, std::max(ra, rb), 0.0, 2.0 * kPi);
        return loop;
    }
    arc(b, rb, heading - tilt, heading + tilt);
    arc(a, ra, heading + tilt, heading + 2.0 * kPi - tilt);
    return loop;
}

std::vector<Part> partsOf(const JointTransforms& joints) {
    using enum JointRole;
    const Colour skin = Colour::of(0xD9A27E), shirt = Colour::of(0xC9503C), hair = Colour::of(0x4A352B);
    const Colour sides[2] = {Colour::of(0x33507A), Colour::of(0x7FA3D4)};
    const Colour sleeves[2] = {Colour::of(0x8E2F22), Colour::of(0xDB7A63)};
    const auto at = [&](JointRole role) { return joints[index(role)].translation; };
    const auto off = [&](JointRole role, Vec3 v) { return joints[index(role)].apply(v); };
    std::vector<Part> parts{
        {at(Hips), at(Spine), 0.125f, 0.115f, mixed(sides[0], sides[1], 0.5)},
        {at(Spine), off(Chest, {0.0f, 0.0f, 0.10f}), 0.115f, 0.13f, shirt},
        {off(Chest, {0.0f, 0.09f, 0.14f}), off(Chest, {0.0f, -0.09f, 0.14f}), 0.095f, 0.095f, shirt},
        {at(Neck), at(Head), 0.055f, 0.05f, skin},
        {off(Head, {0.02f, 0.0f, 0.05f}), off(Head, {0.01f, 0.0f, 0.10f}), 0.075f, 0.088f, skin},
        {off(Head, {-0.02f, 0.0f, 0.09f}), off(Head, {-0.01f, 0.0f, 0.115f}), 0.078f, 0.085f, hair},
        {off(Head, {0.10f, 0.0f, 0.055f}), off(Head, {0.112f, 0.0f, 0.045f}), 0.014f, 0.016f, skin},
    };
    for (std::size_t side = 0; side < 2; ++side) {
        const auto of = [&](JointRole left) { return static_cast<JointRole>(index(left) + 4 * side); };
        const Colour leg = sides[side], sleeve = sleeves[side],
                     bare = mixed(skin, sleeve, side == 0 ? 0.35 : 0.0);
        const float out = side == 0 ? 1.0f : -1.0f;
        parts.push_back({off(of(LeftUpLeg), {0.0f, 0.0f, -0.02f}), at(of(LeftLeg)), 0.088f, 0.058f, leg});
        parts.push_back({at(of(LeftLeg)), off(of(LeftLeg), {-0.012f, 0.0f, -0.15f}), 0.057f, 0.056f, leg});
        parts.push_back({off(of(LeftLeg), {-0.012f, 0.0f, -0.15f}), at(of(LeftFoot)), 0.056f, 0.04f, leg});
        parts.push_back({off(of(LeftFoot), {-0.02f, 0.0f, -0.04f}), off(of(LeftToeBase), {0.0f, 0.0f, 0.0f}),
                         0.04f, 0.03f, mixed(leg, hair, 0.6)});
        parts.push_back({at(of(LeftToeBase)), off(of(LeftToeBase), {0.045f, 0.0f, -0.006f}), 0.03f, 0.024f,
                         mixed(leg, hair, 0.6)});
        parts.push_back({at(of(LeftArm)), at(of(LeftForeArm)), 0.055f, 0.042f, sleeve});
        parts.push_back({at(of(LeftForeArm)), at(of(LeftHand)), 0.042f, 0.03f, bare});
        parts.push_back(
            {at(of(LeftHand)), off(of(LeftHand), {0.0f, 0.08f * out, 0.0f}), 0.03f, 0.036f, bare});
        parts.push_back({off(of(LeftHand), {0.0f, 0.08f * out, 0.0f}),
                         off(of(LeftHand), {0.0f, 0.15f * out, 0.0f}), 0.03f, 0.02f, bare});
    }
    return parts;
}

/// One pose of the strip.
struct Cell {
    View view;
    Vec2 origin;    // Origin of the character's frame in the picture [m].
    double half;    // Half of the column's width [m].
    Travel travel;  // The character's frame in the clip's coordinates.
};

class Strip {
public:
    Strip(const Clip& clip, DebugDraw& draw) : clip_(clip), draw_(draw) {}

    void cell(const Cell& cell, double time) {
        surroundings(cell);
        BodyPose pose;
        clip_.sample(time, pose);
        JointTransforms joints;
        jointTransforms(pose, {}, joints);
        std::vector<Part> parts = partsOf(joints);
        std::stable_sort(parts.begin(), parts.end(), [&](const Part& a, const Part& b) {
            return cell.view.depth(a.a + a.b) < cell.view.depth(b.a + b.b);
        });
        for (const Part& one : parts) part(cell, one);
        water(cell);
        marks(cell, time);
    }

private:
    Vec2 flat(const Cell& cell, Vec3 p) const { return cell.origin + cell.view.flat(p); }
    /// Transforms a point from the clip's coordinates to the character's frame.
    Vec3 seen(const Cell& cell, Vec3 p) const {
        const Quat back = yawTurn(-cell.travel.yaw);
        return rotate(back, p - Vec3{cell.travel.x, cell.travel.y, 0.0f});
    }
    void box(const Cell& cell, Vec3 low, Vec3 high, Colour colour) {
        std::vector<Vec2> corners;
        for (int i = 0; i < 8; ++i) {
            const Vec3 p{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
            const Vec2 at = flat(cell, p);
            corners.push_back({std::clamp(at.x, cell.origin.x - cell.half, cell.origin.x + cell.half), at.y});
        }
        const std::vector<Vec2> hull = hullOf(corners);
        if (hull.size() > 2) draw_.area({{hull}}, colour, {Colour::of(0x555555, 0.6), 0.8});
    }
    static std::vector<Vec2> hullOf(std::vector<Vec2> points) {
        std::sort(points.begin(), points.end(),
                  [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
        std::vector<Vec2> hull;
        for (int pass = 0; pass < 2; ++pass) {
            const std::size_t base = hull.size();
            for (Vec2 p : points) {
                while (hull.size() >= base + 2 &&
                       cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
                    hull.pop_back();
                hull.push_back(p);
            }
            hull.pop_back();
            std::reverse(points.begin(), points.end());
        }
        return hull;
    }
    bool wet() const { return clip_.motion == "swim"; }
    void surroundings(const Cell& cell) {
        const double left = cell.origin.x - cell.half, right = cell.origin.x + cell.half;
        draw_.line(std::vector<Vec2>{{left, cell.origin.y}, {right, cell.origin.y}},
                   {Colour::of(0x777777), 1.2, wet() ? 3.0 : 0.0});
        if (clip_.obstacle.height > 0.0f) {
            const float middle = static_cast<float>(clip_.length()) * 0.5f - cell.travel.x,
                        deep = 0.5f * clip_.obstacle.thickness;
            const float wide = 0.45f;
            box(cell, {middle - deep, -wide, 0.0f}, {middle + deep, wide, clip_.obstacle.height},
                Colour::of(0xB9A58F, 0.75));
        }
    }
    void water(const Cell& cell) {
        if (!wet()) return;
        const double left = cell.origin.x - cell.half, right = cell.origin.x + cell.half,
                     top = cell.origin.y + kWaterHeight;
        draw_.area({{std::vector<Vec2>{{left, top}, {right, top}, {right, top - 0.45}, {left, top - 0.45}}}},
                   Colour::of(0x4FA3C7, 0.28), {});
    }
    void part(const Cell& cell, const Part& p) {
        const Vec2 a = flat(cell, p.a), b = flat(cell, p.b);
        const Colour dark = mixed(p.colour, Colour::of(0x101010), 0.45);
        draw_.area({{outline(a, b, p.ra, p.rb)}}, p.colour, {dark, 0.9});
        const Vec2 light{-0.25, 0.3};
        draw_.area({{outline(a + light * static_cast<double>(p.ra), b + light * static_cast<double>(p.rb),
                             0.55 * p.ra, 0.55 * p.rb)}},
                   mixed(p.colour, Colour::of(0xFFFFFF), 0.18), {});
    }
    void marks(const Cell& cell, double time) {
        for (std::size_t limb = 0; limb < kLimbCount; ++limb) {
            const Contact* contact = clip_.contactAt(static_cast<Limb>(limb), time);
            if (contact == nullptr) continue;
            Vec3 anchor = contact->anchor;
            if (clip_.cyclic && contact->end > clip_.duration() && time < contact->begin) {
                const Travel cycle = clip_.travel.back();
                const Quat back = yawTurn(-cycle.yaw);
                anchor = rotate(back, anchor - Vec3{cycle.x, cycle.y, 0.0f});
            }
            draw_.disc(flat(cell, seen(cell, anchor)), 0.022, Colour::of(limb % 2 == 0 ? 0x2D8A3E : 0x9BE36B),
                       {Colour::of(0x134D1D), 0.8});
        }
    }

    const Clip& clip_;
    DebugDraw& draw_;
};

/// The greatest height of a head in the clip [m].
double topOf(const Clip& clip) {
    double top = clip.obstacle.height;
    for (const BodyPose& pose : clip.poses) {
        JointTransforms joints;
        jointTransforms(pose, {}, joints);
        top = std::max(top, static_cast<double>(joints[index(JointRole::Head)].apply({0.0f, 0.0f, 0.19f}).z));
    }
    return top;
}

}  // namespace

std::string poseStrip(const Clip& clip, const PoseStripDef& def, bool png) {
    std::vector<View> rows;
    if (def.side) rows.push_back(viewFrom(-0.5 * kPi, 0.0));
    if (def.front) rows.push_back(viewFrom(0.0, 0.0));
    if (def.oblique) rows.push_back(viewFrom(-0.25 * kPi, 0.35));
    const double width = def.poses * def.columnWidth, rowTop = std::max(0.5, topOf(clip)) + kTopMargin,
                 row = rowTop + (clip.motion == "swim" ? kPoolDepth : kGroundDepth);
    const Box view{{0.0, 0.0}, {width, kTitleHeight + row * static_cast<double>(rows.size())}};
    const auto pixels = static_cast<std::int32_t>(width * def.pixelsPerMetre);
    const auto draw = png ? makePngDraw(view, pixels, Colour::of(0xF4F1EA))
                          : makeSvgDraw(view, pixels, Colour::of(0xF4F1EA));
    char title[160];
    std::snprintf(title, sizeof(title), "%s   %.2f s   %.2f m   %.2f m/s", clip.name.c_str(), clip.duration(),
                  clip.length(), clip.speed());
    draw->text({0.1, view.max.y - 0.5 * kTitleHeight}, title, 16.0, Colour::of(0x222222), TextAnchor::Left);
    Strip strip(clip, *draw);
    const double step = 1.0 / std::max(1, clip.cyclic ? def.poses : def.poses - 1);
    for (std::int32_t column = 0; column < def.poses; ++column) {
        const double share = def.begin + (def.end - def.begin) * column * step,
                     time = share * clip.duration();
        const double x = (column + 0.5) * def.columnWidth;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const double y = view.max.y - kTitleHeight - row * static_cast<double>(r) - rowTop;
            strip.cell({rows[r], {x, y}, 0.5 * def.columnWidth, clip.travelAt(time)}, time);
        }
        char label[32];
        std::snprintf(label, sizeof(label), "%.2f s", time);
        draw->text({x, 0.12}, label, 11.0, Colour::of(0x555555), TextAnchor::Centre);
    }
    return draw->document();
}

}  // namespace muster
