// A body is lofted through cuts: a trunk in trousers and shirt from whose corners legs and sleeves grow, so
// that skin bends without seams at hips and shoulders; arms, neck, head, hair and shoes are lofts of their
// own that begin hidden in the others.
#include "muster/bodies/body.h"

#include <algorithm>
#include <cmath>

#include "bodies/mesh_builder.h"
#include "bodies/shape.h"
#include "muster/base/maths.h"

namespace muster {
namespace bodies {
namespace {

constexpr Vec3 kSkin{0.745f, 0.397f, 0.212f}, kShirt{0.012f, 0.115f, 0.638f},
    kTrousers{0.012f, 0.024f, 0.069f}, kHair{0.042f, 0.019f, 0.009f}, kShoes{0.78f, 0.75f, 0.71f},
    kSoles{0.25f, 0.24f, 0.22f};

constexpr Stuff kTrunkShirt{BodyRegion::Shirt, Part::Trunk, kShirt};
constexpr Stuff kSleeves{BodyRegion::Shirt, Part::Arm, kShirt};
constexpr Stuff kPants{BodyRegion::Trousers, Part::Trunk, kTrousers};
constexpr Stuff kLegs{BodyRegion::Trousers, Part::Leg, kTrousers};
constexpr Stuff kBareArm{BodyRegion::Skin, Part::Arm, kSkin};
constexpr Stuff kBareNeck{BodyRegion::Skin, Part::Trunk, kSkin};
constexpr Stuff kFace{BodyRegion::Skin, Part::Head, kSkin};
constexpr Stuff kHeadHair{BodyRegion::Hair, Part::Head, kHair};
constexpr Stuff kShoe{BodyRegion::Shoes, Part::Shoe, kShoes};
constexpr Stuff kSole{BodyRegion::Shoes, Part::Shoe, kSoles};

/// How many corners the rings have.
struct Detail {
    bool fine;
    std::size_t trunk, limb, arm, head;
};
constexpr Detail kFine{true, 16, 12, 8, 12};
constexpr Detail kCoarse{false, 8, 6, 4, 6};

/// Builds one body.
class Sculptor {
public:
    Sculptor(const Shape& shape, const Detail& detail) : shape_(shape), detail_(detail) {}

    BodyMesh make() {
        makeTrunk();
        makeNeckAndHead();
        makeHair();
        for (const bool right : {false, true}) {
            mirrored_ = right;
            mesh_.setMirrored(right);
            makeLeg();
            makeSleeve();
            makeArm();
            makeShoe();
        }
        return mesh_.finish();
    }

private:
    /// Corners on an ellipse lie inside it; coarse rings are widened to keep the area.
    static float widening(std::size_t corners) {
        const double step = 2.0 * kPi / static_cast<double>(corners);
        return static_cast<float>(std::sqrt(step / sine(step)));
    }
    static double angleOf(std::size_t k, std::size_t corners) {
        return 2.0 * kPi * static_cast<double>(k) / static_cast<double>(corners);
    }

    /// On a level cut, at an angle from straight ahead to the left.
    static Vec3 levelPoint(const Section& cut, double angle, float widen) {
        const float c = static_cast<float>(cosine(angle)), s = static_cast<float>(sine(angle));
        return {(c > 0.0f ? cut.front : cut.back) * c * widen, cut.middle + cut.side * s * widen, cut.along};
    }
    std::vector<Vec3> levelRing(const Section& cut, std::size_t corners, double first = 0.0) const {
        std::vector<Vec3> points;
        for (std::size_t k = 0; k < corners; ++k)
            points.push_back(levelPoint(cut, first + angleOf(k, corners), widening(corners)));
        return points;
    }
    /// A cut through an arm, from the top round by the front.
    std::vector<Vec3> armRing(const Section& cut, std::size_t corners) const {
        std::vector<Vec3> points;
        const float widen = widening(corners);
        for (std::size_t k = 0; k < corners; ++k) {
            const float c = static_cast<float>(cosine(angleOf(k, corners)));
            const float s = static_cast<float>(sine(angleOf(k, corners)));
            points.push_back({(s > 0.0f ? cut.front : cut.back) * s * widen, cut.along,
                              cut.middle + cut.side * c * widen});
        }
        return points;
    }

    bool wanted(const Section& cut) const { return detail_.fine || cut.far; }

    void makeTrunk() {
        Ring below;
        for (const Section& cut : shape_.pelvis) {
            if (!wanted(cut)) continue;
            auto points = levelRing(cut, detail_.trunk);
            if (below.empty()) {
                for (std::size_t k = 0; k < points.size(); ++k) {
                    const double c = cosine(angleOf(k, detail_.trunk));
                    points[k].z -= shape_.midDrop * static_cast<float>(c * c);
                }
            }
            const Ring ring = mesh_.add(points, kPants);
            if (below.empty()) hips_ = ring;
            if (!below.empty()) mesh_.bridge(below, ring);
            below = ring;
        }
        std::size_t holeBegin = 0, holeEnd = 0;
        for (std::size_t s = 0; s < shape_.shirt.size(); ++s) {
            if (s == shape_.holeBegin) holeBegin = shirt_.size();
            if (s == shape_.holeEnd) holeEnd = shirt_.size();
            if (wanted(shape_.shirt[s]))
                shirt_.push_back(mesh_.add(levelRing(shape_.shirt[s], detail_.trunk), kTrunkShirt));
        }
        hole_[0] = holeBegin, hole_[1] = holeEnd;
        coverShirt();
        turnIn(shirt_.front(), kTrunkShirt, 0.86f, {0.0f, 0.0f, 0.004f}, false);
        turnIn(shirt_.back(), kTrunkShirt, 0.8f, {0.0f, 0.0f, -0.012f}, true);
    }

    /// The shirt's surface but for the holes of the sleeves.
    void coverShirt() {
        const std::size_t n = detail_.trunk, quarter = n / 4, reach = n / 8;
        for (std::size_t r = 0; r + 1 < shirt_.size(); ++r) {
            for (std::size_t k = 0; k < n; ++k) {
                const bool side = (k >= quarter - reach && k < quarter + reach) ||
                                  (k >= 3 * quarter - reach && k < 3 * quarter + reach);
                if (side && r >= hole_[0] && r < hole_[1]) continue;
                const std::array lower{shirt_[r][k], shirt_[r][(k + 1) % n]};
                const std::array upper{shirt_[r + 1][k], shirt_[r + 1][(k + 1) % n]};
                mesh_.bridge(lower, upper, false);
            }
        }
    }

    /// Cloth at an edge goes inwards, unshared so that the edge is sharp.
    void turnIn(const Ring& edge, const Stuff& stuff, float scale, Vec3 shift, bool left) {
        if (!detail_.fine) return;
        const Vec3 middle = mesh_.middle(edge);
        std::vector<Vec3> outer, inner;
        for (std::uint32_t v : edge) {
            outer.push_back(mesh_.at(v));
            inner.push_back(middle + shift + (mesh_.at(v) - middle) * scale);
        }
        const Ring from = mesh_.add(outer, stuff), to = mesh_.add(inner, stuff);
        left ? mesh_.bridge(from, to) : mesh_.bridge(to, from);
    }

    std::uint32_t column(const Ring& ring, std::size_t k) const {
        return ring[mirrored_ ? (ring.size() - k) % ring.size() : k];
    }

    void makeLeg() {
        const std::size_t half = detail_.trunk / 2, gaps = detail_.limb - half - 1;
        Ring above;
        for (std::size_t k = 0; k <= half; ++k) above.push_back(column(hips_, k));
        if (crotch_.empty()) {
            const float front = mesh_.at(hips_[0]).x, back = mesh_.at(hips_[half]).x;
            for (std::size_t g = 1; g <= gaps; ++g) {
                const float t = static_cast<float>(g) / static_cast<float>(gaps + 1);
                crotch_.push_back(mesh_.add(Vec3{back + (front - back) * t, 0.0f, shape_.crotch}, kPants));
            }
        }
        above.insert(above.end(), crotch_.begin(), crotch_.end());
        const double first = 0.5 * kPi - angleOf(half / 2, detail_.limb);
        for (const Section& cut : shape_.leg) {
            if (!wanted(cut)) continue;
            const Ring ring = mesh_.add(levelRing(cut, detail_.limb, first), kLegs);
            mesh_.bridge(ring, above);
            above = ring;
        }
        turnIn(above, kLegs, 0.6f, {0.0f, 0.0f, 0.01f}, false);
    }

    void makeSleeve() {
        const std::size_t quarter = detail_.trunk / 4, reach = detail_.trunk / 8;
        const Ring &top = shirt_[hole_[1]], &bottom = shirt_[hole_[0]];
        Ring inner;
        for (std::size_t i = 0; i <= reach; ++i) inner.push_back(column(top, quarter - i));
        for (std::size_t r = hole_[1] - 1; r > hole_[0]; --r)
            inner.push_back(column(shirt_[r], quarter - reach));
        for (std::size_t i = 0; i <= 2 * reach; ++i) inner.push_back(column(bottom, quarter - reach + i));
        for (std::size_t r = hole_[0] + 1; r < hole_[1]; ++r)
            inner.push_back(column(shirt_[r], quarter + reach));
        for (std::size_t i = 0; i < reach; ++i) inner.push_back(column(top, quarter + reach - i));
        for (const Section& cut : shape_.sleeve) {
            if (!wanted(cut)) continue;
            const Ring ring = mesh_.add(armRing(cut, detail_.limb), kSleeves);
            mesh_.bridge(inner, ring);
            inner = ring;
        }
        turnIn(inner, kSleeves, 0.7f, {0.0f, -0.006f, 0.0f}, true);
    }

    void makeArm() {
        Ring inner;
        for (const Section& cut : shape_.arm) {
            if (!wanted(cut)) continue;
            const Ring ring = mesh_.add(armRing(cut, detail_.arm), kBareArm);
            if (!inner.empty()) mesh_.bridge(inner, ring);
            inner = ring;
        }
        const Section& last = shape_.arm.back();
        mesh_.cap(inner, {0.0f, last.along + 0.012f, last.middle - 0.001f}, kBareArm);
        if (!detail_.fine) return;
        const float s = shape_.handSize;
        const std::array path{Vec3{0.016f, 0.722f, 1.403f}, Vec3{0.046f * s, 0.748f, 1.401f},
                              Vec3{0.062f * s, 0.785f, 1.399f}};
        tube(path, std::array{0.018f * s, 0.0165f * s, 0.0125f * s}, {0.066f * s, 0.803f, 1.398f}, 5,
             kBareArm);
    }

    /// Round cuts along a path, closed at its end.
    void tube(std::span<const Vec3> path, std::span<const float> radii, Vec3 tip, std::size_t corners,
              const Stuff& stuff, float flat = 1.0f) {
        Ring before;
        for (std::size_t i = 0; i < path.size(); ++i) {
            const Vec3 next = i + 1 < path.size() ? path[i + 1] : tip;
            const Vec3 way = normalized(next - path[i == 0 ? 0 : i - 1]);
            const Vec3 u = normalized(cross({0.0f, 1.0f, 0.3f}, way), {1.0f, 0.0f, 0.0f});
            const Vec3 v = cross(way, u);
            std::vector<Vec3> points;
            for (std::size_t k = 0; k < corners; ++k) {
                const float c = static_cast<float>(cosine(angleOf(k, corners)));
                const float s = static_cast<float>(sine(angleOf(k, corners)));
                points.push_back(path[i] + (u * c + v * (s * flat)) * radii[i]);
            }
            const Ring ring = mesh_.add(points, stuff);
            if (!before.empty()) mesh_.bridge(before, ring);
            before = ring;
        }
        mesh_.cap(before, tip, stuff);
    }

    void makeNeckAndHead() {
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

    void makeNoseAndEars() {
        const float x = sectionAt(1.58f).front;
        const Ring nose =
            mesh_.add(std::array{Vec3{x - 0.002f, 0.0f, 1.622f}, Vec3{x - 0.004f, -0.016f, 1.576f},
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

    /// The head's cut at a height between its first and last.
    Section sectionAt(float height) const {
        std::size_t s = 1;
        while (s + 1 < shape_.head.size() && shape_.head[s].along < height) ++s;
        const Section &a = shape_.head[s - 1], &b = shape_.head[s];
        const float t = (height - a.along) / (b.along - a.along);
        return {height, a.side + (b.side - a.side) * t, a.front + (b.front - a.front) * t,
                a.back + (b.back - a.back) * t};
    }

    /// Where hair begins at an angle from straight ahead: high over the face, low at temples and nape.
    float hairline(double angle) const {
        const double turn = angle > kPi ? 2.0 * kPi - angle : angle;
        constexpr double kBrow = 0.75, kTemple = 1.25;
        const float brow = detail_.fine ? 1.690f : 1.674f;
        if (turn <= kBrow) return brow;
        if (turn <= kTemple)
            return brow + (shape_.hairSides - brow) * static_cast<float>((turn - kBrow) / (kTemple - kBrow));
        const float t = std::min(1.0f, static_cast<float>((turn - kTemple) / (2.45 - kTemple)));
        return shape_.hairSides + (shape_.hairNape - shape_.hairSides) * t;
    }

    void makeHair() {
        // Outwards from the head at shares of the height between hairline and crown.
        struct Row {
            float share, out;
        };
        static constexpr std::array kRows{Row{0.0f, -0.35f}, Row{0.02f, 0.7f}, Row{0.3f, 1.0f},
                                          Row{0.62f, 1.05f}, Row{0.9f, 1.0f}};
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

    void makeTail() {
        const std::array path{Vec3{-0.080f, 0.0f, 1.672f}, Vec3{-0.118f, 0.0f, 1.668f},
                              Vec3{-0.150f, 0.0f, 1.635f}, Vec3{-0.160f, 0.0f, 1.575f},
                              Vec3{-0.146f, 0.0f, 1.505f}};
        const std::array radii{0.026f, 0.020f, 0.036f, 0.038f, 0.026f};
        if (detail_.fine)
            tube(path, radii, {-0.128f, 0.0f, 1.452f}, 7, kHeadHair);
        else
            tube(std::array{path[1], path[3]}, std::array{0.026f, 0.038f}, {-0.128f, 0.0f, 1.452f}, 3,
                 kHeadHair);
    }

    void makeShoe() {
        struct Slice {
            float x, width, top;
            bool far;
        };
        static constexpr std::array kSlices{
            Slice{-0.072f, 0.028f, 0.066f, true}, Slice{-0.012f, 0.036f, 0.118f, false},
            Slice{0.038f, 0.039f, 0.098f, true},  Slice{0.080f, 0.044f, 0.077f, false},
            Slice{0.125f, 0.048f, 0.061f, false}, Slice{0.170f, 0.043f, 0.050f, true},
            Slice{0.196f, 0.028f, 0.040f, false},
        };
        Ring behind;
        for (const Slice& slice : kSlices) {
            if (!detail_.fine && !slice.far) continue;
            const Ring ring = shoeRing(slice.x, slice.width * shape_.footWidth, slice.top);
            if (behind.empty())
                mesh_.cap(ring, {slice.x - 0.006f, 0.09f, 0.035f}, kShoe, false);
            else
                mesh_.bridge(behind, ring);
            behind = ring;
        }
        mesh_.cap(behind, {mesh_.at(behind[0]).x + 0.010f, 0.09f, 0.018f}, kShoe);
    }

    /// From the sole's inner corner round by the outer side, seen from the toes.
    Ring shoeRing(float x, float width, float top) {
        struct Corner {
            float y, z;
            bool sole;
        };
        static constexpr std::array kCorners{Corner{-0.85f, 0.0f, true},   Corner{0.85f, 0.0f, true},
                                             Corner{1.0f, 0.24f, false},   Corner{0.86f, 0.62f, false},
                                             Corner{0.45f, 0.94f, false},  Corner{-0.45f, 0.94f, false},
                                             Corner{-0.86f, 0.62f, false}, Corner{-1.0f, 0.24f, false}};
        static constexpr std::array kFew{Corner{-1.0f, 0.0f, true}, Corner{1.0f, 0.0f, true},
                                         Corner{0.6f, 1.0f, false}, Corner{-0.6f, 1.0f, false}};
        const std::span<const Corner> corners =
            detail_.fine ? std::span<const Corner>(kCorners) : std::span<const Corner>(kFew);
        // The sole curls up a little at heel and toes.
        const float curl = x > 0.15f ? (x - 0.15f) * 0.25f : x < -0.06f ? 0.004f : 0.0f;
        Ring ring;
        for (const Corner& c : corners)
            ring.push_back(
                mesh_.add(Vec3{x, 0.09f + c.y * width, curl + c.z * (top - curl)}, c.sole ? kSole : kShoe));
        return ring;
    }

    const Shape& shape_;
    Detail detail_;
    MeshBuilder mesh_;
    Ring hips_, crotch_;
    std::vector<Ring> shirt_;
    std::array<std::size_t, 2> hole_{};
    bool mirrored_ = false;
};

}  // namespace
}  // namespace bodies

const char* bodyRegionName(BodyRegion region) {
    static constexpr const char* kNames[kBodyRegionCount] = {"skin", "shirt", "trousers", "hair", "shoes"};
    return kNames[static_cast<std::size_t>(region)];
}

BodyMesh makeBody(BodyKind kind, BodyLevel level) {
    using namespace bodies;
    return Sculptor(kind == BodyKind::Broad ? broadShape() : narrowShape(),
                    level == BodyLevel::Near ? kFine : kCoarse)
        .make();
}

Vec3 skinned(const BodyVertex& vertex, const JointTransforms& joints) {
    static const JointTransforms kRest = [] {
        JointTransforms rest;
        jointTransforms(restPose(), {}, rest);
        return rest;
    }();
    Vec3 sum;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 local = vertex.position - kRest[vertex.joints[k]].translation;
        sum += joints[vertex.joints[k]].apply(local) * vertex.weights[k];
    }
    return sum;
}

}  // namespace muster
