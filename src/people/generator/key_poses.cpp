#include "people/generator/key_poses.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster::generator {
namespace {

Curve curveOf(const std::vector<PointCurve::Point>& points, float Vec3::*part) {
    std::vector<Key> keys;
    for (const PointCurve::Point& point : points) keys.push_back({point.time, point.place.*part});
    return Curve::eased(std::move(keys));
}

std::vector<PointCurve::Point> pointsOf(const std::vector<FootKey>& keys, Vec3 FootKey::*part) {
    std::vector<PointCurve::Point> points;
    for (const FootKey& key : keys) points.push_back({key.time, key.*part});
    return points;
}

Curve anglesOf(const std::vector<FootKey>& keys, double FootKey::*angle) {
    std::vector<Key> angles;
    for (const FootKey& key : keys) angles.push_back({key.time, degrees(key.*angle)});
    return Curve::eased(std::move(angles));
}

bool isPlace(Channel channel) {
    return channel == Channel::HipsX || channel == Channel::HipsY || channel == Channel::HipsZ;
}

LegShape shapeOf(const Leg& leg, Vec3 hip) {
    const Vec3 toAnkle = leg.ankle - hip;
    const double d = std::clamp(
        std::sqrt(static_cast<double>(toAnkle.x) * toAnkle.x + static_cast<double>(toAnkle.z) * toAnkle.z),
        0.05, (kThigh + kShin) * 0.9999);
    const auto arcCosine = [](double c) { return arcTangent2(std::sqrt(std::max(0.0, 1.0 - c * c)), c); };
    LegShape shape;
    shape.knee = kPi - arcCosine((kThigh * kThigh + kShin * kShin - d * d) / (2.0 * kThigh * kShin));
    shape.thigh = arcTangent2(toAnkle.x, -toAnkle.z) +
                  arcCosine((kThigh * kThigh + d * d - kShin * kShin) / (2.0 * kThigh * d));
    if (shape.thigh > 0.75 * kPi) shape.thigh -= 2.0 * kPi;
    const Vec3 toes = rotate(leg.foot, {1.0f, 0.0f, 0.0f});
    const double flat = std::sqrt(static_cast<double>(toes.x) * toes.x +
                                  static_cast<double>(toes.y) * toes.y);
    shape.ankle = arcTangent2(toes.z, toes.x < 0.0f ? -flat : flat) - (shape.thigh - shape.knee);
    if (shape.ankle > 1.5) shape.ankle -= 2.0 * kPi;
    if (shape.ankle < -2.5) shape.ankle += 2.0 * kPi;
    shape.side = toAnkle.y;
    shape.yaw = toes.x < 0.0f ? arcTangent2(-toes.y, -toes.x) : arcTangent2(toes.y, toes.x);
    shape.toe = leg.toe;
    return shape;
}

}  // namespace

PointCurve::PointCurve(const std::vector<Point>& points)
    : x_(curveOf(points, &Vec3::x)), y_(curveOf(points, &Vec3::y)), z_(curveOf(points, &Vec3::z)) {}

Vec3 PointCurve::at(double time) const {
    return {static_cast<float>(x_.at(time)), static_cast<float>(y_.at(time)),
            static_cast<float>(z_.at(time))};
}

FootCurve::FootCurve(const std::vector<FootKey>& keys)
    : ankle_(pointsOf(keys, &FootKey::ankle)),
      knee_(pointsOf(keys, &FootKey::knee)),
      pitch_(anglesOf(keys, &FootKey::pitch)),
      toe_(anglesOf(keys, &FootKey::toe)) {}

Leg FootCurve::at(double time) const {
    Leg leg;
    leg.ankle = ankle_.at(time);
    leg.foot = turned(-pitch_.at(time), 0.0, 0.0);
    leg.toe = toe_.at(time);
    leg.knee = normalized(knee_.at(time), {1.0f, 0.0f, 0.0f});
    return leg;
}

Reach reachAt(const std::vector<HandContact>& holds, std::size_t side, double time) {
    const float out = side == 0 ? 1.0f : -1.0f;
    Reach reach;
    reach.elbow = {-0.6f, 0.6f * out, -0.1f};
    reach.hand = flatHand(side, -0.1 * out);
    double sum = 0.0;
    for (const HandContact& hold : holds) {
        const double near = time < hold.begin ? rise(hold.begin - hold.come, hold.begin, time)
                                              : 1.0 - rise(hold.end, hold.end + hold.go, time);
        if (near <= 0.0) continue;
        // Between two contacts the target moves from one to the other.
        sum += near;
        const Vec3 above = hold.wrist +
                           Vec3{0.0f, 0.0f, hold.touches ? static_cast<float>(0.15 * (1.0 - near)) : 0.0f};
        reach.wrist = lerp(reach.wrist, above, static_cast<float>(near / sum));
    }
    reach.weight = std::min(1.0, sum);
    return reach;
}

void addContacts(std::vector<Contact>& contacts, std::size_t side, const std::vector<HandContact>& holds) {
    for (const HandContact& hold : holds)
        if (hold.touches)
            contacts.push_back(
                {side == 0 ? Limb::LeftHand : Limb::RightHand, hold.begin, hold.end, hold.wrist});
}

BodyKeys::BodyKeys(const std::vector<ChannelKeys>& channels) {
    for (const ChannelKeys& line : channels)
        lines_.push_back({line.channel, Curve::eased(line.keys), isPlace(line.channel) ? 1.0 : degrees(1.0)});
}

ChannelValues BodyKeys::at(double time, const ChannelValues& base) const {
    ChannelValues body = base;
    for (const Line& line : lines_) body[line.channel] = line.scale * line.curve.at(time);
    return body;
}

Leg fromGround(const Placement& place, const Leg& leg) {
    const Quat back = yawTurn(-place.yaw);
    return {fromGround(place, leg.ankle), back * leg.foot, leg.toe, rotate(back, leg.knee)};
}

Reach fromGround(const Placement& place, Reach reach) {
    const Quat back = yawTurn(-place.yaw);
    reach.wrist = fromGround(place, reach.wrist);
    reach.hand = back * reach.hand;
    reach.elbow = rotate(back, reach.elbow);
    return reach;
}

LegJoin joinOf(const std::function<Figure(double)>& figure, std::size_t side, double time) {
    constexpr double kMoment = 1e-3;
    const auto shape = [&](double t) {
        const Figure at = figure(t);
        return shapeOf(at.legs[side], hipJoint(at.body, side));
    };
    const LegShape a = shape(time - kMoment), b = shape(time + kMoment);
    const double s = 0.5 / kMoment;
    return {time,
            shape(time),
            {(b.thigh - a.thigh) * s, (b.knee - a.knee) * s, (b.ankle - a.ankle) * s, (b.side - a.side) * s,
             (b.yaw - a.yaw) * s, (b.toe - a.toe) * s},
            1.0};
}

}  // namespace muster::generator
