#include "people/bodies/sculptor.h"

#include "base/maths.h"

namespace muster::bodies {

void Sculptor::makeArm() {
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
    tube(path, std::array{0.018f * s, 0.0165f * s, 0.0125f * s}, {0.066f * s, 0.803f, 1.398f}, 5, kBareArm);
}

void Sculptor::makeShoe() {
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

Ring Sculptor::shoeRing(float x, float width, float top) {
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
    const std::span<const Corner> corners = detail_.fine ? std::span<const Corner>(kCorners)
                                                         : std::span<const Corner>(kFew);
    // The sole curls up a little at heel and toes.
    const float curl = x > 0.15f ? (x - 0.15f) * 0.25f : x < -0.06f ? 0.004f : 0.0f;
    Ring ring;
    for (const Corner& c : corners)
        ring.push_back(
            mesh_.add(Vec3{x, 0.09f + c.y * width, curl + c.z * (top - curl)}, c.sole ? kSole : kShoe));
    return ring;
}

}  // namespace muster::bodies
