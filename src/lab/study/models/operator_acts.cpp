// Movements of an operator model's hands that carry out its decisions.
#include <algorithm>
#include <array>
#include <limits>

#include "lab/study/models/operator_model.h"
#include "lab/study/models/planner.h"

namespace muster {
namespace {

constexpr double kBoxMargin = 0.45;  // Distance from the characters that a box shall select to its sides [m].
constexpr double kTwoFingersTime = 0.04;  // Time between two fingers that come down together [s].
// Distance from a loop's first corner at which the finger comes down [m].
constexpr double kFreeDistance = 0.8;
constexpr double kGripShare = 0.8;  // Share of the crowd's half width at which two fingers come down.
// Distance to an item within which a character passes over it, or nearly [m].
constexpr double kPassingReach = 0.8;
constexpr double kPassingSpeed = 0.5;  // Least speed of a character that passes by [m/s].
constexpr double kGlanceTime = 0.2;    // Time between two pictures that tell which characters move [s].
constexpr double kLeastSelected = 0.5;
constexpr double kLeastOwnShare = 0.7;  // Least share of a formation in a part for the part to stand for it.
constexpr std::size_t kNoCharge = static_cast<std::size_t>(-1);

Vec2 nearestTo(std::span<const Vec2> points, Vec2 p) {
    Vec2 nearest = p;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 q : points) {
        if (distance(p, q) >= least) continue;
        least = distance(p, q);
        nearest = q;
    }
    return nearest;
}

}  // namespace

// The hand that is free first.
std::size_t OperatorModel::freeHand() const {
    return parameters_.hands > 1.5 && handFree_[1] < handFree_[0] ? 1 : 0;
}

// Time at which a hand has got from its position to `to` [s]; notes the new position.
double OperatorModel::reachHand(double now, Vec2 to, double width, std::size_t hand) {
    const double start = std::max(now, handFree_[hand]);
    const double there = start + noisy(motor_.point(millimetres(handAt_[hand], to), width * mmPerMetre_));
    handAt_[hand] = to;
    return there;
}

void OperatorModel::perform(double now, const Task& task) {
    switch (task.act) {
        case Act::Cut:
            return cut(now, cuts_[task.index]);
        case Act::Call:
            return call(now, static_cast<std::int32_t>(task.index));
        case Act::TakeOut:
            return takeOut(now, charges_[task.index]);
        case Act::Send:
            adopt(charges_[task.index], scene(now));
            return send(now, charges_[task.index]);
        case Act::Point: {
            Charge& charge = charges_[task.index];
            double at = now;
            if (selected_ != task.index) {
                select(at, charge);
                return;
            }
            at += noisy(motor_.factor() * parameters_.decideNext);
            point(at, charge, false);
            busyUntil_ = at;
            note("send", now, at, "next point");
            return;
        }
    }
}

void OperatorModel::cut(double now, const std::array<Vec2, 2>& line) {
    const std::size_t hand = freeHand();
    double at = now + noisy(motor_.factor() * parameters_.decideNext);
    at = reachHand(at, line[0], kTargetMetres, hand) + motor_.press();
    const double seconds = noisy(motor_.drag(millimetres(line[0], line[1]), kTargetMetres * mmPerMetre_));
    const PathLeg leg{line[1], seconds, 0.0};
    busyUntil_ = hand_.stroke(nextPointer_++, PointerButton::Left, {}, at, line[0], std::span(&leg, 1),
                              kTargetMetres * mmPerMetre_, script_);
    handAt_[hand] = line[1];
    handFree_[hand] = busyUntil_ + motor_.factor() * motor_.device().handOff;
    ++commands_;
    note("cut", now, busyUntil_, "");
}

// After a cut the characters that are seen to belong together are one part.
void OperatorModel::adopt(Charge& charge, const SeenScene& seen) {
    if (!repertoire_.draws || !divided_) return;
    std::vector<std::uint32_t> groups;
    for (std::size_t i = 0; i < seen.ids.size(); ++i)
        if (std::binary_search(charge.plan.part.ids.begin(), charge.plan.part.ids.end(), seen.ids[i]))
            groups.push_back(seen.groups[i]);
    if (groups.empty()) return;
    std::sort(groups.begin(), groups.end());
    std::uint32_t best = groups[0];
    std::ptrdiff_t most = 0;
    for (const std::uint32_t group : groups) {
        const std::ptrdiff_t count = std::count(groups.begin(), groups.end(), group);
        if (count <= most) continue;
        most = count;
        best = group;
    }
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < seen.ids.size(); ++i)
        if (seen.groups[i] == best) ids.push_back(seen.ids[i]);
    // As long as the cut is not seen yet, the operator goes by what was meant.
    if (static_cast<double>(most) < kLeastOwnShare * static_cast<double>(ids.size())) return;
    if (ids != charge.plan.part.ids) charge.plan.part.ids = std::move(ids);
}

// Draws a loop round a few characters with a finger, from the corner that is freest.
void OperatorModel::takeOut(double now, const Charge& charge) {
    const std::size_t hand = freeHand();
    const double chosen = now + noisy(motor_.factor() * parameters_.decideNext);
    const Box box = seen(charge, chosen + 0.5).bounds.grown(kTakenMargin);
    const std::array<Vec2, 4> corners{box.min, Vec2{box.max.x, box.min.y}, box.max,
                                      Vec2{box.min.x, box.max.y}};
    const SeenScene& scene = memory_.at(chosen - delay());
    std::size_t first = 0;
    double freest = -1.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double room = distance(corners[i], nearestTo(scene.positions, corners[i]));
        if (room <= freest) continue;
        freest = room;
        first = i;
    }
    // The loop begins and ends farther out, where no finger takes the formation.
    const Vec2 outside = studyRules().box.clamp(
        corners[first] + normalized(corners[first] - (box.min + box.max) * 0.5) * kFreeDistance);
    double at = reachHand(chosen, outside, kTargetMetres, hand) + motor_.press();
    std::vector<PathLeg> legs;
    Vec2 from = outside;
    for (std::size_t i = 0; i <= corners.size() + 1; ++i) {
        const Vec2 to = i <= corners.size() ? corners[(first + i) % corners.size()] : outside;
        legs.push_back({to, noisy(motor_.draw(millimetres(from, to), kTargetMetres * mmPerMetre_)), 0.0});
        from = to;
    }
    busyUntil_ = hand_.stroke(nextPointer_++, PointerButton::Left, {}, at, outside, legs,
                              kTargetMetres * mmPerMetre_, script_);
    handAt_[hand] = outside;
    handFree_[hand] = busyUntil_ + motor_.factor() * motor_.device().handOff;
    divided_ = true;
    ++commands_;
    note("loop", now, busyUntil_, std::to_string(charge.plan.part.ids.size()) + " are taken out");
}

// Whether somebody is seen to move by a point.
bool OperatorModel::passes(const SeenScene& scene, Vec2 point) const {
    const SeenScene& before = memory_.at(scene.time - kGlanceTime);
    for (std::size_t i = 0; i < scene.ids.size(); ++i)
        if (distance(scene.positions[i], point) < kPassingReach &&
            distance(scene.positions[i], before.positions[i]) > kGlanceTime * kPassingSpeed)
            return true;
    return false;
}

// Two taps by an item call a character, which is expected to be the nearest one.
void OperatorModel::call(double now, std::int32_t item) {
    const std::size_t hand = freeHand();
    const double chosen = now + noisy(motor_.factor() * parameters_.decideNext);
    const Vec2 to = tours_.items()[item];
    // The operator calls no character for an item that has gone, nor to a point that somebody passes.
    const SeenScene& scene = memory_.at(now - delay());
    if (scene.collected[item] != 0 || passes(scene, to)) return;
    double at = reachHand(chosen, to, kTargetMetres, hand);
    for (std::int32_t tap = 0; tap < 2; ++tap)
        at = hand_.click(PointerButton::Left, {}, at, to, kTargetMetres * mmPerMetre_, script_) +
             (tap == 0 ? kBetweenTaps : 0.0);
    busyUntil_ = at;
    handFree_[hand] = at + motor_.factor() * motor_.device().handOff;
    ++commands_;
    Charge charge;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.ids.size(); ++i) {
        if (distance(scene.positions[i], to) >= least) continue;
        if (divided_ && std::binary_search(scene.busy.begin(), scene.busy.end(), scene.groups[i]) &&
            std::count(scene.groups.begin(), scene.groups.end(), scene.groups[i]) == 1)
            continue;
        least = distance(scene.positions[i], to);
        charge.plan.part = seenPart({scene.ids[i]}, {scene.positions[i]});
    }
    if (charge.plan.part.ids.empty()) return;
    charge.plan.stops = {item};
    charge.plan.way = {to};
    charge.meant = {item};
    charge.point = 1;
    charge.sentAt = at;
    for (Charge& other : charges_)
        std::erase_if(other.plan.part.ids, [&](std::uint32_t id) { return id == charge.plan.part.ids[0]; });
    charges_.push_back(std::move(charge));
    divided_ = true;
    note("call", now, busyUntil_, "");
}

void OperatorModel::send(double now, Charge& charge) {
    if (charge.plan.way.empty()) return;
    ++commands_;
    if (repertoire_.draws) return charge.plan.width > 0.0 ? sweep(now, charge) : draw(now, charge);
    double at = now + noisy(motor_.factor() * parameters_.attention);
    select(at, charge);
}

// Gives a formation its square back by two taps.
double OperatorModel::tapTwice(double at, Vec2 where, double millimetres) {
    for (std::int32_t tap = 0; tap < 2; ++tap)
        at = hand_.click(PointerButton::Left, {}, at, where, millimetres, script_) + kBetweenTaps;
    ++commands_;
    return at;
}

// True where one of the items that a part is led to lies by a point of its way.
bool OperatorModel::isStop(const PlannedPart& plan, Vec2 point) const {
    const double reach = std::max(plan.part.bounds.width(), plan.part.bounds.height()) + kTargetMetres;
    return std::any_of(plan.stops.begin(), plan.stops.end(),
                       [&](std::int32_t stop) { return distance(tours_.items()[stop], point) < reach; });
}

// Takes a formation with a finger or the mouse and draws its way.
void OperatorModel::draw(double now, Charge& charge) {
    const std::size_t hand = freeHand();
    const double chosen = now + noisy(motor_.factor() * (parameters_.attention + parameters_.decideNext));
    const SeenPart about = seen(charge, chosen + 0.5);
    const double width = std::max(kTargetMetres, std::min(about.bounds.width(), about.bounds.height()));
    double at = reachHand(chosen, about.centre, width, hand) + motor_.press();
    if (charge.plan.square) at = tapTwice(at, about.centre, width * mmPerMetre_);
    // The gesture takes the character nearest to the formation's middle, which may stand beside it; the way
    // is drawn as far beside its own.
    const SeenPart there = seen(charge, at);
    const Vec2 from = nearestTo(there.positions, there.centre);
    const Vec2 beside = from - there.centre;
    const double tolerance = toleranceOf(there) * mmPerMetre_;
    std::vector<PathLeg> legs;
    Vec2 last = from;
    // The way was planned from an earlier position of the part, which moves on meanwhile.
    for (const Vec2 middle : charge.plan.way) {
        const Vec2 p = studyRules().box.clamp(middle + beside);
        const double mm = millimetres(last, p);
        // Pauses for a decision are at items, not where the way bends round a block.
        const bool stop = isStop(charge.plan, middle);
        const double pause = stop ? noisy(motor_.factor() * parameters_.decideNext) : 0.0;
        const bool ends = &middle == &charge.plan.way.back();
        legs.push_back({p, noisy(motor_.draw(mm, ends ? kTargetMetres * mmPerMetre_ : tolerance)), pause});
        last = p;
    }
    busyUntil_ = hand_.carry(nextPointer_++, at, from, legs, width * mmPerMetre_, kTargetMetres * mmPerMetre_,
                             script_);
    charge.sentAt = busyUntil_;
    charge.point = charge.plan.way.size();
    handAt_[hand] = last;
    handFree_[hand] = busyUntil_ + motor_.factor() * motor_.device().handOff;
    note("draw", now, busyUntil_, std::to_string(charge.plan.stops.size()) + " stops");
}

// Two fingers take the crowd by its sides, spread it, and draw two ways beside each other.
void OperatorModel::sweep(double now, Charge& charge) {
    const double chosen = now + noisy(motor_.factor() * (parameters_.attention + parameters_.decideNext +
                                                         parameters_.secondHand));
    const SeenPart part = seen(charge, chosen + 0.5);
    const Vec2 across = perpendicular(charge.plan.along);
    double low = 0.0;
    double high = 0.0;
    for (const Vec2 p : part.positions) {
        low = std::min(low, dot(p - part.centre, across));
        high = std::max(high, dot(p - part.centre, across));
    }
    const std::array<Vec2, 2> grips{part.centre + across * (kGripShare * low),
                                    part.centre + across * (kGripShare * high)};
    const double at = std::max(reachHand(chosen, grips[0], kTargetMetres, 0),
                               reachHand(chosen, grips[1], kTargetMetres, 1));
    const double half = 0.5 * charge.plan.width;
    const double spread = noisy(motor_.drag(half * mmPerMetre_, kTargetMetres * mmPerMetre_));
    std::vector<PathLeg> common;
    Vec2 last = part.centre;
    for (const Vec2 p : charge.plan.way) {
        const double seconds = noisy(motor_.draw(millimetres(last, p), 2.0 * kTargetMetres * mmPerMetre_));
        common.push_back({p, seconds, noisy(motor_.factor() * parameters_.decideNext)});
        last = p;
    }
    std::vector<ScriptedInput> both;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 side = across * (i == 0 ? -half : half);
        std::vector<PathLeg> legs{{part.centre + side, spread, 0.0}};
        for (const PathLeg& leg : common) legs.push_back({leg.to + side, leg.seconds, leg.pause});
        busyUntil_ = hand_.stroke(nextPointer_++, PointerButton::Left, {},
                                  at + (i == 0 ? 0.0 : kTwoFingersTime), grips[i], legs,
                                  kTargetMetres * mmPerMetre_, both);
        handAt_[i] = legs.back().to;
        handFree_[i] = busyUntil_ + motor_.factor() * motor_.device().handOff;
    }
    std::stable_sort(both.begin(), both.end(),
                     [](const ScriptedInput& a, const ScriptedInput& b) { return a.time < b.time; });
    script_.insert(script_.end(), both.begin(), both.end());
    charge.sentAt = busyUntil_;
    charge.point = charge.plan.way.size();
    note("sweep", now, busyUntil_, std::to_string(static_cast<int>(charge.plan.width)) + " m wide");
}

// Selects a part: by its digit where it has been kept, else by a box round it. The result is looked at then.
void OperatorModel::select(double& at, Charge& charge) {
    const auto index = static_cast<std::size_t>(&charge - charges_.data());
    const double begun = at;
    const bool kept = charge.digit != 0 && charge.sentAt >= 0.0;
    if (selected_ != index) {
        if (kept) {
            at += noisy(motor_.factor() *
                        (parameters_.chooseBase + parameters_.chooseSlope * 2.0 + parameters_.key));
            hand_.key(charge.digit, {}, at, script_);
        } else {
            const Box box = seen(charge, at + 0.7).bounds.grown(kBoxMargin);
            const Vec2 first{box.min.x, box.max.y};
            const Vec2 second{box.max.x, box.min.y};
            at = reachHand(at, first, kTargetMetres, 0) + motor_.press();
            const PathLeg leg{
                second, noisy(motor_.drag(millimetres(first, second), kTargetMetres * mmPerMetre_)), 0.0};
            const bool paper = scheme_.kind == SchemeKind::MousePaper;
            at = hand_.stroke(1, paper ? PointerButton::Right : PointerButton::Left, {}, at, first,
                              std::span(&leg, 1), kTargetMetres * mmPerMetre_, script_);
            handAt_[0] = second;
            if (charge.digit != 0) {
                at += noisy(motor_.factor() * 2.0 * parameters_.key);
                hand_.key(charge.digit, {false, true, false}, at, script_);
            }
        }
        note("select", begun, at, "");
    }
    // The next movement goes on at once; the selection is seen on the way.
    selected_ = index;
    checkSelection_ = index;
    checkAt_ = at + motor_.device().latency + 0.05;
    busyUntil_ = at;
}

// Takes the characters that are seen to be selected as the part.
void OperatorModel::adoptSelected(double now, Charge& charge) {
    checkSelection_ = kNoCharge;
    const std::vector<std::uint32_t>& found = memory_.at(now - motor_.device().latency).selected;
    const std::vector<std::uint32_t>& ids = charge.plan.part.ids;
    std::ptrdiff_t common = 0;
    for (const std::uint32_t id : found) common += std::binary_search(ids.begin(), ids.end(), id) ? 1 : 0;
    if (static_cast<double>(common) < kLeastSelected * static_cast<double>(ids.size())) {
        ++misses_;
        selected_ = kNoCharge;
        const auto index = static_cast<std::size_t>(&charge - charges_.data());
        charge.digit = charge.sentAt < 0.0 ? charge.digit : std::uint8_t{0};
        tasks_.push_back({charge.point == 0 ? Act::Send : Act::Point, index});
        note("again", now, now, "the selection was missed");
        return;
    }
    // A character that was selected with the part belongs to it from now on.
    for (Charge& other : charges_) {
        if (&other == &charge) continue;
        std::erase_if(other.plan.part.ids,
                      [&](std::uint32_t id) { return std::binary_search(found.begin(), found.end(), id); });
    }
    charge.plan.part.ids = found;
    double at = now;
    const std::size_t last = repertoire_.queues ? charge.plan.way.size() : charge.point + 1;
    const std::size_t first = charge.point;
    while (charge.point < last) {
        at += noisy(motor_.factor() * parameters_.decideNext);
        point(at, charge, charge.point > first);
    }
    busyUntil_ = at;
    note("send", now, at, std::to_string(last - first) + " points");
}

// Clicks on the next point of a part's way.
void OperatorModel::point(double& at, Charge& charge, bool add) {
    const Vec2 to = charge.plan.way[charge.point];
    const double width = toleranceOf(seen(charge, at));
    at = reachHand(at, to, width, 0) + motor_.press();
    const bool paper = scheme_.kind == SchemeKind::MousePaper;
    Modifiers modifiers{.shift = add};
    at = hand_.click(paper ? PointerButton::Left : PointerButton::Right, modifiers, at, to,
                     width * mmPerMetre_, script_);
    ++charge.point;
    ++commands_;
    charge.sentAt = at;
}

}  // namespace muster
