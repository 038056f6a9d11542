#include "engine/steering/crowd_bodies.h"

#include <functional>

#include "engine/steering/character_arrays.h"

namespace muster {
namespace {

// Share of the correction by its mass with which a character that holds its ground gives way to others.
constexpr double kFirmShare = 0.002;

bool isUsual(const Body& body) {
    return body.radius == 0.0 && body.maxSpeed == 0.0 && body.acceleration == 0.0 && body.mass == 1.0 &&
           body.headway == 0.0;
}

}  // namespace

void CrowdBodies::reset(const Parameters::Character& def) {
    def_ = def;
    largest_ = def.radius;
    fastest_ = def.maxSpeed;
    radius_.clear();
    longestBraking_ = brakingTime(0);
    longestHeadway_ = def.headway;
    ring_ = {};
}

void CrowdBodies::resolve(const Parameters::Character& def, const Characters& now,
                          std::span<const std::uint8_t> firmness, const Ring& ring) {
    reset(def);
    ring_ = ring;
    const bool normal = std::adjacent_find(firmness.begin(), firmness.end(), std::not_equal_to()) ==
                        firmness.end();
    const bool driven = std::all_of(now.driver.begin(), now.driver.end(),
                                    [](Driver driver) { return driver == Driver::Muster; });
    if (normal && driven && std::all_of(now.body.begin(), now.body.end(), isUsual)) return;
    const std::size_t count = now.size();
    for (auto* array : {&radius_, &maxSpeed_, &acceleration_, &headway_, &nearTime_, &inverseMass_})
        array->resize(count);
    firmness_.resize(count);
    group_.assign(now.group.begin(), now.group.end());
    largest_ = fastest_ = longestHeadway_ = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Body body = i < now.body.size() ? now.body[i] : Body{};
        radius_[i] = radiusOf(def, body);
        maxSpeed_[i] = maxSpeedOf(def, body);
        acceleration_[i] = accelerationOf(def, body);
        headway_[i] = headwayOf(def, body);
        nearTime_[i] = nearTime(headway_[i], brakingTime(i));
        const bool outside = i < now.driver.size() && now.driver[i] == Driver::Outside;
        inverseMass_[i] = outside ? 0.0 : 1.0 / body.mass;
        firmness_[i] = group_[i] < firmness.size() ? firmness[group_[i]] : std::uint8_t{0};
        largest_ = std::max(largest_, radius_[i]);
        fastest_ = std::max(fastest_, maxSpeed_[i]);
        longestBraking_ = std::max(longestBraking_, brakingTime(i));
        longestHeadway_ = std::max(longestHeadway_, headway_[i]);
    }
}

double CrowdBodies::ownShare(std::size_t a, std::size_t b) const {
    double own = inverseMass_[a], other = inverseMass_[b];
    if (group_[a] != group_[b] && firmness_[a] != firmness_[b])
        (firmness_[a] > firmness_[b] ? own : other) *= kFirmShare;
    const double sum = own + other;
    return sum > 0.0 ? own / sum : 0.0;
}

void CrowdBodies::shorten(std::span<const Vec2> positions, NeighbourList& neighbours) const {
    if (alike()) return;
    const double most = neighbours.listedReach() - 2.0 * largest_;
    neighbours.dropPairs([&](NeighbourPair pair) {
        const double reach = touching(pair.low, pair.high) + std::min(most, nearGap(pair.low, pair.high));
        return lengthSquared(between(positions[pair.low], positions[pair.high])) > reach * reach;
    });
}

}  // namespace muster
