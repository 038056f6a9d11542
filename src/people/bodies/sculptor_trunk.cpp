#include "people/bodies/sculptor.h"

#include "base/maths.h"

namespace muster::bodies {

void Sculptor::makePelvis() {
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
}

void Sculptor::makeShirt() {
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

void Sculptor::coverShirt() {
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

void Sculptor::makeLeg() {
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

void Sculptor::makeSleeve() {
    const std::size_t quarter = detail_.trunk / 4, reach = detail_.trunk / 8;
    const Ring &top = shirt_[hole_[1]], &bottom = shirt_[hole_[0]];
    Ring inner;
    for (std::size_t i = 0; i <= reach; ++i) inner.push_back(column(top, quarter - i));
    for (std::size_t r = hole_[1] - 1; r > hole_[0]; --r) inner.push_back(column(shirt_[r], quarter - reach));
    for (std::size_t i = 0; i <= 2 * reach; ++i) inner.push_back(column(bottom, quarter - reach + i));
    for (std::size_t r = hole_[0] + 1; r < hole_[1]; ++r) inner.push_back(column(shirt_[r], quarter + reach));
    for (std::size_t i = 0; i < reach; ++i) inner.push_back(column(top, quarter + reach - i));
    for (const Section& cut : shape_.sleeve) {
        if (!wanted(cut)) continue;
        const Ring ring = mesh_.add(armRing(cut, detail_.limb), kSleeves);
        mesh_.bridge(inner, ring);
        inner = ring;
    }
    turnIn(inner, kSleeves, 0.7f, {0.0f, -0.006f, 0.0f}, true);
}

}  // namespace muster::bodies
