// Decisions of an operator model, and its picture of the scene.
#include "lab/study/models/operator_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kWayMargin = 0.8;      // Distance that ways keep off blocks [m].
constexpr double kKnownSpeed = 2.0;     // Speed at which people are known to walk [m/s].
constexpr double kStandingSpeed = 0.3;  // Speed below which a character is seen to stand [m/s].
constexpr double kIdleLookTime = 0.4;  // Time that the operator looks at a part to see whether it stands [s].
constexpr double kStuckLookTime = 2.0;   // Time that the operator looks at a part with a way ahead [s].
constexpr double kOrderGraceTime = 1.2;  // Time after an order in which no movement is expected [s].
// Distance to the start of a later sweep within which a part has reached it [m].
constexpr double kStagedReach = 1.5;
// Distance of a part's middle to a point within which the part has reached it [m].
constexpr double kPointReach = 1.3;
constexpr double kMissedSeconds = 5.0;  // Expected cost of an item that was missed, once more [s].
// Number of items up to which they are left-overs that a few characters can fetch.
constexpr std::size_t kMostLeftOvers = 3;
// Difference of the distances to two legs below which they count as one [m].
constexpr double kSameLegDistance = 0.3;
// Distance aside of an item within which a front may still come over it [m].
constexpr double kPassedBeside = 2.0;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::vector<Box> blocksOf(const Trial& trial) {
    std::vector<Box> blocks;
    for (const ObstacleId id : trial.world().obstacleIds()) {
        const Polygon outline = trial.world().obstacle(id).outline;
        Box box{outline[0], outline[0]};
        for (const Vec2 p : outline) {
            box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
            box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
        }
        blocks.push_back(box);
    }
    return blocks;
}

std::vector<Vec2> itemsOf(const Trial& trial) {
    std::vector<Vec2> items;
    for (const ItemDef& item : trial.world().items()) items.push_back(item.position);
    return items;
}

// The seed is hashed apart, so that a model's factor of time and its later draws do not depend on each other.
double ownFactor(const OperatorParameters& parameters, std::uint64_t seed) {
    return Chance(seed * 2 + 1).logNormal(parameters.between);
}

}  // namespace

OperatorModel::OperatorModel(const Trial& trial, const OperatorParameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      chance_(seed * 2),
      motor_(parameters, repertoireOf(namedScheme(trial.def().scheme).value().def).touch,
             ownFactor(parameters, seed)),
      repertoire_(repertoireOf(namedScheme(trial.def().scheme).value().def)),
      scheme_(namedScheme(trial.def().scheme).value().def),
      view_(trial.view()),
      ground_(blocksOf(trial), studyRules().box, kWayMargin),
      tours_(ground_, itemsOf(trial)),
      hand_(view_, motor_, chance_) {
    const Vec2 a = view_.screenOf({0.0, 0.0}).value();
    const Vec2 b = view_.screenOf({1.0, 0.0}).value();
    mmPerMetre_ = distance(a, b) * view_.mmPerPixel;
    PlannerDef def{.repertoire = repertoire_,
                   .parameters = parameters,
                   .mmPerMetre = mmPerMetre_,
                   .itemRadius = studyRules().itemRadius,
                   .speed = kKnownSpeed,
                   .spacing = studyRules().spacing,
                   .border = studyRules().box.grown(-0.5)};
    planner_ = std::make_unique<Planner>(def, tours_, motor_);
    // Hands begin beside the crowd.
    handAt_ = {Vec2{0.0, -6.0}, Vec2{0.0, -8.0}};
}

OperatorModel::~OperatorModel() = default;

double OperatorModel::delay() const {
    return motor_.device().latency + motor_.factor() * parameters_.reaction;
}

void OperatorModel::note(const char* kind, double from, double to, std::string text) {
    decisions_.push_back({step_, kind, to - from, std::move(text)});
    busySeconds_ += to - from;
}

void OperatorModel::direct(Trial& trial) {
    step_ = trial.world().stepCount();
    memory_.look(trial);
    const double now = trial.world().time();
    if (now >= busyUntil_) think(now);
    play(trial);
}

// Makes the events that are due.
void OperatorModel::play(Trial& trial) {
    const double now = trial.world().time() + 1e-9;
    for (; played_ < script_.size() && script_[played_].time <= now; ++played_)
        if (!trial.input(script_[played_].event).ok()) ++misses_;
    if (played_ < script_.size()) return;
    script_.clear();
    played_ = 0;
}

void OperatorModel::think(double now) {
    const SeenScene& seen = scene(now);
    if (!begun_) {
        begin(now, seen);
    } else if (checkSelection_ != kNone) {
        if (now >= checkAt_) adoptSelected(now, charges_[checkSelection_]);
    } else if (!tasks_.empty()) {
        const Task task = tasks_.back();
        tasks_.pop_back();
        perform(now, task);
    } else {
        watch(now, seen);
    }
}

// Takes in the scene and makes the first plan.
void OperatorModel::begin(double now, const SeenScene& seen) {
    begun_ = true;
    const std::vector<std::int32_t> open = openItems(seen);
    const OperatorPlan plan = planner_->plan(seenPart(seen.ids, seen.positions), open, chance_);
    cuts_ = plan.cuts;
    divided_ = !cuts_.empty();
    for (const PlannedPart& part : plan.parts) {
        Charge charge{.plan = part, .meant = sweptBy(part, open)};
        if (repertoire_.keepsGroups && plan.parts.size() > 1)
            charge.digit = static_cast<std::uint8_t>('1' + charges_.size());
        charges_.push_back(std::move(charge));
    }
    for (std::size_t i = charges_.size(); i-- > 0;)
        if (!charges_[i].plan.way.empty()) tasks_.push_back({Act::Send, i});
    if (repertoire_.draws)
        for (std::size_t i = cuts_.size(); i-- > 0;) tasks_.push_back({Act::Cut, i});
    const double takeIn = parameters_.takeIn + parameters_.takeInItem * static_cast<double>(open.size());
    busyUntil_ = now + noisy(motor_.factor() * takeIn) + noisy(motor_.factor() * parameters_.decide);
    nextPlan_ = busyUntil_ + parameters_.replan;
    char text[96];
    std::snprintf(text, sizeof(text), "%s, %.1f s expected", plan.text.c_str(), plan.seconds);
    note("plan", now, busyUntil_, text);
}

std::vector<std::int32_t> OperatorModel::openItems(const SeenScene& seen) const {
    std::vector<std::int32_t> open;
    for (std::size_t i = 0; i < seen.collected.size(); ++i)
        if (seen.collected[i] == 0) open.push_back(static_cast<std::int32_t>(i));
    return open;
}

std::vector<std::int32_t> OperatorModel::sweptBy(const PlannedPart& part,
                                                 std::span<const std::int32_t> open) const {
    std::vector<std::int32_t> swept = part.stops;
    if (part.way.empty()) return swept;
    const Sweep sweep = planner_->sweepOf(part.part);
    for (const std::int32_t item : open) {
        if (std::find(swept.begin(), swept.end(), item) != swept.end()) continue;
        Vec2 at = part.part.centre;
        bool found = part.width > 0.0 && part.stops.empty();  // A sweep is meant for all items.
        for (const Vec2 to : part.way) {
            found = found || sweep.collects(at, to, tours_.items()[item]);
            at = to;
        }
        if (found) swept.push_back(item);
    }
    return swept;
}

// Where a part is seen at the time `at`: its picture, moved on as it was seen to move.
SeenPart OperatorModel::seen(const Charge& charge, double at) const {
    const double latest = at - delay();
    const SeenScene& now = memory_.at(latest);
    const SeenScene& before = memory_.at(now.time - 0.2);
    std::vector<std::uint32_t> ids;
    std::vector<Vec2> positions;
    Vec2 moved;
    for (std::size_t i = 0; i < now.ids.size(); ++i) {
        if (!std::binary_search(charge.plan.part.ids.begin(), charge.plan.part.ids.end(), now.ids[i]))
            continue;
        ids.push_back(now.ids[i]);
        positions.push_back(now.positions[i]);
        moved += now.positions[i] - before.positions[i];
    }
    if (ids.empty()) return charge.plan.part;
    const double passed = now.time - before.time;
    const double ahead = std::clamp(at - now.time, 0.0, 1.5);
    const Vec2 shift = passed > 0.0 ? moved / static_cast<double>(ids.size()) * (ahead / passed) : Vec2{};
    for (Vec2& p : positions) p += shift;
    return seenPart(std::move(ids), std::move(positions));
}

bool OperatorModel::idle(const Charge& charge, const SeenScene& now) const {
    if (now.time < charge.sentAt + kOrderGraceTime) return false;
    // A part with a way ahead is stuck only where it has stood for longer.
    bool waits = true;
    for (std::size_t i = 0; i < now.ids.size() && waits; ++i)
        if (std::binary_search(charge.plan.part.ids.begin(), charge.plan.part.ids.end(), now.ids[i]))
            waits = std::binary_search(now.busy.begin(), now.busy.end(), now.groups[i]);
    if (waits && now.time < charge.sentAt + kStuckLookTime) return false;
    const std::int32_t looks = waits ? static_cast<std::int32_t>(kStuckLookTime / kIdleLookTime) : 1;
    // The part stands where it is not seen to move between any two of the last pictures.
    for (std::int32_t k = 0; k < looks; ++k) {
        const SeenScene& after = memory_.at(now.time - k * kIdleLookTime);
        const SeenScene& before = memory_.at(after.time - kIdleLookTime);
        const double passed = after.time - before.time;
        if (passed <= 0.5 * kIdleLookTime) return false;
        double moved = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < after.ids.size(); ++i) {
            if (!std::binary_search(charge.plan.part.ids.begin(), charge.plan.part.ids.end(), after.ids[i]))
                continue;
            moved += distance(after.positions[i], before.positions[i]);
            count += 1.0;
        }
        if (count > 0.0 && moved / count / passed >= kStandingSpeed) return false;
    }
    return true;
}

// Whether the rest of a part's way meets none of the open items that it was meant for.
bool OperatorModel::spent(const Charge& charge, const SeenScene& now) const {
    if (charge.sentAt < 0.0 || now.time < charge.sentAt + kOrderGraceTime || charge.plan.way.empty())
        return false;
    if (charge.point < charge.plan.way.size()) return false;
    const SeenPart part = seen(charge, now.time + delay());
    if (charge.plan.stages) return distance(part.centre, charge.plan.way.back()) < kStagedReach;
    return std::none_of(charge.meant.begin(), charge.meant.end(), [&](std::int32_t item) {
        return now.collected[item] == 0 && comesOver(charge, part, item);
    });
}

// Whether a part comes over an item on the rest of its way.
bool OperatorModel::comesOver(const Charge& charge, const SeenPart& part, std::int32_t item) const {
    const std::vector<Vec2>& way = charge.plan.way;
    // The leg on which the part's middle is; the first one where legs lie on each other.
    std::size_t leg = 0;
    double least = std::numeric_limits<double>::infinity();
    Vec2 from = charge.plan.part.centre;
    for (std::size_t k = 0; k < way.size(); ++k) {
        const double away = distanceToSegment(part.centre, from, way[k]);
        if (away < least - kSameLegDistance) leg = k;
        least = std::min(least, away);
        from = way[k];
    }
    const Sweep sweep = planner_->sweepOf(part);
    Vec2 at = part.centre;
    for (std::size_t k = leg; k < way.size(); ++k) {
        if (sweep.collects(at, way[k], tours_.items()[item])) return true;
        if (charge.plan.width > 0.0 && aheadOfFront(charge, part, at, way[k], tours_.items()[item]))
            return true;
        at = way[k];
    }
    return false;
}

// Whether a wide front that is on its way from `at` to `to` still comes over an item.
bool OperatorModel::aheadOfFront(const Charge& charge, const SeenPart& part, Vec2 at, Vec2 to, Vec2 item) {
    const double length = distance(at, to);
    if (length < 1e-6) return false;
    const Vec2 along = (to - at) / length;
    const Vec2 across = perpendicular(along);
    if (std::abs(dot(item - at, across)) > 0.5 * charge.plan.width + 0.5) return false;
    if (dot(item - to, along) > 1.0) return false;
    const double depth = at == part.centre ? 0.0 : -1.0;
    if (dot(item - at, along) > depth) return true;
    return at == part.centre && std::any_of(part.positions.begin(), part.positions.end(), [&](Vec2 p) {
               return dot(item - p, along) > 0.3 && std::abs(dot(item - p, across)) < kPassedBeside;
           });
}

// Whether a part that has to be led from point to point is where its next point can be given.
bool OperatorModel::due(const Charge& charge, const SeenScene& seen) const {
    if (repertoire_.draws || repertoire_.queues || charge.point == 0) return false;
    if (charge.point >= charge.plan.way.size()) return false;
    const Vec2 target = charge.plan.way[charge.point - 1];
    const std::int32_t stop = charge.plan.stops[charge.point - 1];
    if (seen.collected[stop] != 0) return true;
    Vec2 centre;
    double count = 0.0;
    for (std::size_t i = 0; i < seen.ids.size(); ++i) {
        if (!std::binary_search(charge.plan.part.ids.begin(), charge.plan.part.ids.end(), seen.ids[i]))
            continue;
        centre += seen.positions[i];
        count += 1.0;
    }
    return count > 0.0 && distance(centre / count, target) < kPointReach;
}

// Looks at one part after the other: a part that is due gets its next point, an idle one a new way.
void OperatorModel::watch(double now, const SeenScene& seen) {
    for (std::size_t i = 0; i < charges_.size(); ++i) {
        Charge& charge = charges_[i];
        if (!due(charge, seen)) continue;
        // Points whose items have gone in the meantime are passed over.
        while (charge.point + 1 < charge.plan.way.size() &&
               seen.collected[charge.plan.stops[charge.point]] != 0)
            ++charge.point;
        if (seen.collected[charge.plan.stops[charge.point]] != 0) {
            charge.point = charge.plan.way.size();
            continue;
        }
        tasks_.push_back({Act::Point, i});
        return;
    }
    if (now < nextPlan_) return;
    renew(now, seen);
}

std::vector<std::size_t> OperatorModel::freeParts(const SeenScene& seen) const {
    std::vector<std::size_t> idles;
    for (std::size_t i = 0; i < charges_.size(); ++i)
        if (!charges_[i].plan.part.ids.empty() && (idle(charges_[i], seen) || spent(charges_[i], seen)))
            idles.push_back(i);
    return idles;
}

bool OperatorModel::active(std::size_t i, std::span<const std::size_t> idles) const {
    return !charges_[i].plan.part.ids.empty() && std::find(idles.begin(), idles.end(), i) == idles.end();
}

// Open items that nobody is about to collect.
std::vector<std::int32_t> OperatorModel::unclaimed(std::span<const std::size_t> idles,
                                                   const SeenScene& seen) const {
    std::vector<std::int32_t> left;
    for (const std::int32_t item : openItems(seen)) {
        bool meant = false;
        for (std::size_t i = 0; i < charges_.size(); ++i)
            meant = meant || (active(i, idles) &&
                              std::count(charges_[i].meant.begin(), charges_[i].meant.end(), item) > 0);
        if (!meant) left.push_back(item);
    }
    return left;
}

// The far half of the items of the busiest part.
std::vector<std::int32_t> OperatorModel::takenOver(std::span<const std::size_t> idles,
                                                   const SeenScene& seen) {
    std::vector<std::int32_t> left;
    std::size_t most = kNone;
    std::size_t count = 2;
    for (std::size_t i = 0; i < charges_.size(); ++i) {
        std::vector<std::int32_t>& meant = charges_[i].meant;
        std::erase_if(meant, [&](std::int32_t item) { return seen.collected[item] != 0; });
        // A front that goes on comes over its own items anyway.
        if (!active(i, idles) || charges_[i].plan.width > 0.0 || meant.size() < count) continue;
        count = meant.size() + 1;
        most = i;
    }
    if (most == kNone) return left;
    std::vector<std::int32_t>& meant = charges_[most].meant;
    const auto half = static_cast<std::ptrdiff_t>((meant.size() + 1) / 2);
    left.assign(meant.begin() + half, meant.end());
    meant.erase(meant.begin() + half, meant.end());
    return left;
}

// A part gets a new way; or a few of it do, where that is quicker.
void OperatorModel::renewPart(std::size_t index, std::span<const std::int32_t> items, double now) {
    const SeenPart part = seen(charges_[index], now);
    const auto missed = std::count_if(items.begin(), items.end(), [&](std::int32_t item) {
        const std::vector<std::int32_t>& meant = charges_[index].meant;
        return std::count(meant.begin(), meant.end(), item) > 0;
    });
    if (!charges_[index].plan.stages) misses_ += static_cast<std::int32_t>(missed);
    // No part sweeps twice for items that a sweep has missed.
    const bool sweeps = missed == 0 || charges_[index].plan.width == 0.0;
    PlannedPart whole = planner_->renewed(part, items, sweeps, chance_);
    const auto few = items.size() <= kMostLeftOvers ? planner_->fetched(part, items, chance_) : std::nullopt;
    if (few && planner_->partSeconds(*few) + planner_->takeOutSeconds(*few) < planner_->partSeconds(whole)) {
        Charge charge{.plan = *few};
        charge.meant = sweptBy(charge.plan, items);
        charges_[index].meant.clear();
        std::erase_if(charges_[index].plan.part.ids, [&](std::uint32_t id) {
            return std::binary_search(few->part.ids.begin(), few->part.ids.end(), id);
        });
        charges_.push_back(std::move(charge));
        tasks_.push_back({Act::Send, charges_.size() - 1});
        if (repertoire_.draws) tasks_.push_back({Act::TakeOut, charges_.size() - 1});
        return;
    }
    Charge& charge = charges_[index];
    charge.plan = std::move(whole);
    charge.meant = sweptBy(charge.plan, items);
    charge.point = 0;
    tasks_.push_back({Act::Send, index});
}

// Drops items that a front has passed, since it does not come back for them.
void OperatorModel::dropPassed(const SeenScene& seen) {
    for (Charge& charge : charges_) {
        if (charge.plan.width == 0.0 || charge.sentAt < 0.0 || seen.time < charge.sentAt + kOrderGraceTime)
            continue;
        const SeenPart part = this->seen(charge, seen.time + delay());
        std::erase_if(charge.meant, [&](std::int32_t item) { return !comesOver(charge, part, item); });
    }
}

// Whether calling the nearest character to each of these items is quicker than sending the idle parts.
bool OperatorModel::callsFor(std::span<const std::size_t> idles, std::span<const std::int32_t> left,
                             double now) {
    if (!repertoire_.calls) return false;
    if (idles.empty()) return true;
    const SeenScene& scene = memory_.at(now - delay());
    double calls = 0.0;
    double last = 0.0;
    for (const std::int32_t item : left) {
        calls += planner_->callSeconds();
        double least = std::numeric_limits<double>::infinity();
        for (const Vec2 p : scene.positions)
            least = std::min(least, ground_.distance(p, tours_.items()[item]));
        last = std::max(last, calls + least / kKnownSpeed);
    }
    double parts = std::numeric_limits<double>::infinity();
    for (const std::size_t i : idles) {
        const PlannedPart way = planner_->renewed(seen(charges_[i], now), left, true, chance_);
        parts = std::min(parts, planner_->partSeconds(way));
    }
    // A part that has passed by an item may do so again.
    const auto again = std::count_if(left.begin(), left.end(), [&](std::int32_t item) {
        return std::any_of(idles.begin(), idles.end(), [&](std::size_t i) {
            const std::vector<std::int32_t>& meant = charges_[i].meant;
            return !charges_[i].plan.stages && std::count(meant.begin(), meant.end(), item) > 0;
        });
    });
    parts += kMissedSeconds * static_cast<double>(again);
    return last < parts;
}

// Plans new ways for parts that have nothing more to do although items are left.
void OperatorModel::renew(double now, const SeenScene& seen) {
    const std::vector<std::size_t> idles = freeParts(seen);
    if (idles.empty() && !repertoire_.calls) return;
    if (repertoire_.calls) dropPassed(seen);
    std::vector<std::int32_t> left = unclaimed(idles, seen);
    if (!left.empty() && callsFor(idles, left, now)) {
        for (const std::int32_t item : left) tasks_.push_back({Act::Call, static_cast<std::size_t>(item)});
        busyUntil_ = now + noisy(motor_.factor() * parameters_.decide);
        nextPlan_ = busyUntil_ + parameters_.replan;
        note("plan", now, busyUntil_, std::to_string(left.size()) + " items for whoever is nearest");
        return;
    }
    if (idles.empty()) return;
    if (left.empty()) left = takenOver(idles, seen);
    std::vector<std::vector<std::int32_t>> shares(charges_.size());
    for (const std::int32_t item : left) {
        std::size_t nearest = idles[0];
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t i : idles) {
            // The nearest character counts, not the middle of a wide front.
            const SeenPart part = this->seen(charges_[i], now);
            for (const Vec2 p : part.positions) {
                const double away = ground_.distance(p, tours_.items()[item]);
                if (away >= least) continue;
                least = away;
                nearest = i;
            }
        }
        shares[nearest].push_back(item);
    }
    for (const std::size_t i : idles)
        if (!shares[i].empty()) renewPart(i, shares[i], now);
    if (tasks_.empty()) return;
    busyUntil_ = now + noisy(motor_.factor() * parameters_.decide);
    nextPlan_ = busyUntil_ + parameters_.replan;
    note("plan", now, busyUntil_,
         std::to_string(left.size()) + " items for " + std::to_string(idles.size()) + " idle parts");
}

}  // namespace muster
