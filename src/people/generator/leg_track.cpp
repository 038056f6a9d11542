#include "people/generator/leg_track.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster::generator {
namespace {

constexpr double kRateStep = 5e-4;  // Time step of finite differences [s].

double pitchOf(const Step& step, double time) {
    const double landing = time - step.begin, leaving = step.end - time;
    if (step.strike != 0.0 && landing < step.flat) {
        const double left = 1.0 - std::max(0.0, landing) / step.flat;
        return step.strike * left * left;
    }
    if (step.push != 0.0 && leaving < step.rise) {
        const double done = 1.0 - std::max(0.0, leaving) / step.rise;
        return -step.push * done * done * (1.6 - 0.6 * done);
    }
    return 0.0;
}

constexpr Vec3 kSole{0.0f, 0.0f, 0.03f};  // Vector from the sole to the joint of the toes [m].

/// Direction of a knee: perpendicular to the line from hip to ankle, forwards, rotated by `yaw`.
Vec3 kneeAhead(Vec3 hip, Vec3 ankle, double yaw) {
    const Vec3 toAnkle = ankle - hip;
    return rotate(yawTurn(yaw), normalized(Vec3{-toAnkle.z, 0.0f, toAnkle.x}, {1.0f, 0.0f, 0.0f}));
}

/// Lifts the foot until heel and toes are above the ground; `share` (0 to 1) scales the lift.
void keepClear(double share, Leg& leg) {
    const Quat toes = leg.foot * axisAngle({0.0f, 1.0f, 0.0f}, leg.toe);
    const Vec3 ball = rotate(leg.foot, kBall);
    const float low = leg.ankle.z +
                      std::min({rotate(leg.foot, kHeel).z, rotate(leg.foot, kBall - kSole).z,
                                (ball + rotate(toes, kToeTip - kBall)).z, (ball - rotate(toes, kSole)).z});
    const double lack = 0.015 * share - low, soft = 0.01 * share;
    leg.ankle.z += static_cast<float>(0.5 * (lack + std::sqrt(lack * lack + soft * soft)));
}

/// Arc cosine by the engine's own arc tangent, which gives equal bits on all platforms.
double arcCosine(double c) {
    c = std::clamp(c, -1.0, 1.0);
    return arcTangent2(std::sqrt(1.0 - c * c), c);
}

Quat footTurn(double yaw, double pitch) {
    return turned(-pitch, 0.0, yaw);
}

LegShape scaled(const LegShape& a, double s) {
    return {a.thigh * s, a.knee * s, a.ankle * s, a.side * s, a.yaw * s, a.toe * s};
}
LegShape difference(const LegShape& a, const LegShape& b) {
    return {a.thigh - b.thigh, a.knee - b.knee, a.ankle - b.ankle,
            a.side - b.side,   a.yaw - b.yaw,   a.toe - b.toe};
}

/// The spline through both ends and the keys between them, with the rates of the ends.
Curve through(const LegJoin& from, const LegJoin& to, const std::vector<Key>& keys, double LegShape::*part) {
    const double length = to.time - from.time;
    std::vector<Key> all{{from.time, from.shape.*part}};
    for (const Key& key : keys) all.push_back({from.time + key.time * length, key.value});
    all.push_back({to.time, to.shape.*part});
    return Curve::spline(std::move(all), from.rate.*part, to.rate.*part);
}

/// The keys of a swing that remain if it begins late or ends early.
std::vector<Key> inside(const std::vector<Key>& keys, double wholeBegin, double wholeEnd, double begin,
                        double end) {
    std::vector<Key> out;
    for (const Key& key : keys) {
        const double share = (wholeBegin + key.time * (wholeEnd - wholeBegin) - begin) / (end - begin);
        if (share > 0.15 && share < 0.9) out.push_back({share, key.value});
    }
    return out;
}

}  // namespace

Vec3 rolledAnkle(Vec3 anchor, double yaw, double pitch) {
    const Vec3 pivot = pitch > 0.0 ? kHeel : kBall;
    return anchor + rotate(yawTurn(yaw), pivot) - rotate(footTurn(yaw, pitch), pivot);
}

Leg standingLeg(Vec3 anchor, double yaw, double pitch) {
    Leg leg;
    leg.ankle = rolledAnkle(anchor, yaw, pitch);
    leg.foot = footTurn(yaw, pitch);
    leg.toe = std::min(0.0, pitch);
    leg.knee = rotate(yawTurn(yaw), {1.0f, 0.0f, 0.0f});
    return leg;
}

LegTrack::LegTrack(std::size_t side, std::vector<Step> steps, Course course, std::optional<LegJoin> before,
                   std::optional<LegJoin> after)
    : side_(side), steps_(std::move(steps)), course_(std::move(course)) {
    for (std::size_t i = 0; i + 1 < steps_.size(); ++i) {
        const Step &a = steps_[i], &b = steps_[i + 1];
        LegJoin from = edge(a, a.end, false), to = edge(b, b.begin, true);
        if (before && before->time > from.time && before->time < to.time) from = *before;
        if (after && after->time < to.time && after->time > from.time) to = *after;
        Swing left;
        left.thigh = inside(a.swing.thigh, a.end, b.begin, from.time, to.time);
        left.knee = inside(a.swing.knee, a.end, b.begin, from.time, to.time);
        left.ankle = inside(a.swing.ankle, a.end, b.begin, from.time, to.time);
        flights_.push_back(flight(from, to, left));
    }
}

const Step* LegTrack::standing(double time) const {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        if (time <= steps_[i].end) return time >= steps_[i].begin || i == 0 ? &steps_[i] : nullptr;
    }
    return &steps_.back();
}

LegShape LegTrack::standingShape(const Step& step, double time) const {
    const Placement place = course_.travel(time);
    const double pitch = pitchOf(step, time);
    const Vec3 ankle = fromGround(place, rolledAnkle(step.anchor, step.yaw, pitch)),
               hip = hipJoint(course_.body(time), side_);
    const double x = ankle.x - hip.x, z = hip.z - ankle.z;
    const double d = std::clamp(std::sqrt(x * x + z * z), 0.05, (kThigh + kShin) * 0.9999);
    LegShape shape;
    shape.knee = kPi - arcCosine((kThigh * kThigh + kShin * kShin - d * d) / (2.0 * kThigh * kShin));
    shape.thigh = arcTangent2(x, z) +
                  arcCosine((kThigh * kThigh + d * d - kShin * kShin) / (2.0 * kThigh * d));
    shape.ankle = pitch - (shape.thigh - shape.knee);
    shape.side = ankle.y - hip.y;
    shape.yaw = step.yaw - place.yaw;
    shape.toe = std::min(0.0, pitch);
    return shape;
}

LegJoin LegTrack::edge(const Step& step, double time, bool landing) const {
    const double inner = landing ? time + kRateStep : time - kRateStep;
    LegJoin join{time, standingShape(step, time), {}, 0.0};
    join.rate = scaled(difference(standingShape(step, inner), join.shape), 1.0 / (inner - time));
    join.rate.toe = landing ? 0.0 : join.rate.toe;
    return join;
}

LegTrack::Flight LegTrack::flight(const LegJoin& from, const LegJoin& to, const Swing& swing) const {
    Flight out{from.time, to.time, from.clear, to.clear, {}, {}, {}, {}, {}, {}};
    out.thigh = through(from, to, swing.thigh, &LegShape::thigh);
    out.knee = through(from, to, swing.knee, &LegShape::knee);
    out.ankle = through(from, to, swing.ankle, &LegShape::ankle);
    out.side = through(from, to, {}, &LegShape::side);
    out.yaw = through(from, to, {}, &LegShape::yaw);
    std::vector<Key> toe{{from.time, from.shape.toe}, {to.time, to.shape.toe}};
    // The toes are straight after 35 % of the swing, unless the swing ends before that.
    if (to.shape.toe > -0.01) toe.insert(toe.begin() + 1, {from.time + 0.35 * (to.time - from.time), 0.0});
    out.toe = Curve::eased(std::move(toe));
    return out;
}

LegShape LegTrack::shapeAt(double time) const {
    if (const Step* step = standing(time)) return standingShape(*step, time);
    for (const Flight& flight : flights_) {
        if (time > flight.end) continue;
        return {flight.thigh.at(time), flight.knee.at(time), flight.ankle.at(time),
                flight.side.at(time),  flight.yaw.at(time),  flight.toe.at(time)};
    }
    return standingShape(steps_.back(), time);
}

LegJoin LegTrack::join(double time) const {
    LegJoin join{time, shapeAt(time), {}, clearAt(time)};
    join.rate = scaled(difference(shapeAt(time + kRateStep), shapeAt(time - kRateStep)), 0.5 / kRateStep);
    return join;
}

Leg LegTrack::swinging(const Flight& flight, double time) const {
    const Vec3 hip = hipJoint(course_.body(time), side_);
    const double thigh = flight.thigh.at(time), shin = thigh - std::max(0.02, flight.knee.at(time));
    const double pitch = shin + flight.ankle.at(time);
    Leg leg;
    leg.ankle = {static_cast<float>(hip.x + kThigh * sine(thigh) + kShin * sine(shin)),
                 static_cast<float>(hip.y + flight.side.at(time)),
                 static_cast<float>(hip.z - kThigh * cosine(thigh) - kShin * cosine(shin))};
    leg.foot = footTurn(flight.yaw.at(time), pitch);
    leg.toe = flight.toe.at(time);
    leg.knee = kneeAhead(hip, leg.ankle, 0.6 * flight.yaw.at(time));
    return leg;
}

double LegTrack::clearAt(double time) const {
    for (const Flight& flight : flights_) {
        if (time > flight.end || time < flight.begin) continue;
        const double share = (time - flight.begin) / (flight.end - flight.begin), off = 2.0 * share - 1.0;
        const double free = 1.0 - off * off;
        return 1.0 - (1.0 - (share < 0.5 ? flight.clearBegin : flight.clearEnd)) * (1.0 - free * free);
    }
    return 0.0;
}

Leg LegTrack::standingAt(const Step& step, double time) const {
    const Placement place = course_.travel(time);
    Leg leg = standingLeg(step.anchor, step.yaw, pitchOf(step, time));
    leg.ankle = fromGround(place, leg.ankle);
    leg.foot = yawTurn(-place.yaw) * leg.foot;
    leg.knee = kneeAhead(hipJoint(course_.body(time), side_), leg.ankle, 0.6 * (step.yaw - place.yaw));
    return leg;
}

Leg LegTrack::legAt(double time, bool clear) const {
    if (const Step* step = standing(time)) return standingAt(*step, time);
    for (const Flight& flight : flights_) {
        if (time > flight.end) continue;
        Leg leg = swinging(flight, time);
        if (clear) keepClear(clearAt(time), leg);
        return leg;
    }
    return standingAt(steps_.back(), time);
}

Leg LegTrack::at(double time) const {
    return legAt(time, true);
}

Leg LegTrack::inAir(double time) const {
    return legAt(time, false);
}

}  // namespace muster::generator
