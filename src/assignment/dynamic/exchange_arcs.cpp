#include "assignment/dynamic/exchange_arcs.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::int32_t kNearPlaces = 8;
constexpr std::int32_t kNearCharacters = 6;
constexpr std::int32_t kHotNearPlaces = 6;  // Seats that are hot spare some lanes for arcs to each other.
constexpr std::int32_t kHotNearCharacters = 4;
constexpr std::int32_t kLastLane = ExchangeArcs::kLanes - 1;  // Kept for waiting characters and free places.
constexpr float kHotTimesMean = 3.0f;
constexpr std::size_t kHotLookedAt = 200;
constexpr std::size_t kRowsAtOnce = 256;

double edgeFor(std::span<const Vec2> points) {
    if (points.empty()) return 1.0;
    Box box{points[0], points[0]};
    for (const Vec2 p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    const double area = std::max(box.width(), 0.1) * std::max(box.height(), 0.1);
    return std::max(0.1, std::sqrt(1.5 * area / static_cast<double>(points.size())));
}

}  // namespace

void ExchangeArcs::reset(std::int32_t seats) {
    const auto arcs = static_cast<std::size_t>(seats) * kLanes;
    target_.resize(arcs);
    weight_.assign(arcs, kNever);
    for (std::size_t k = 0; k < arcs; ++k) target_[k] = static_cast<std::int32_t>(k / kLanes);
    makeRoom();
}

void ExchangeArcs::makeRoom() {
    const std::size_t seats = target_.size() / kLanes;
    start_.assign(seats + 1, 0);
    into_.assign(target_.size(), 0);
    asked_.reserve(kRowsAtOnce * kLanes);
    pairs_.reserve(kRowsAtOnce * kLanes);
    answers_.reserve(kRowsAtOnce * kLanes);
    hot_.reserve(seats);
}

void ExchangeArcs::afterReading() {
    makeRoom();
    sortByTarget();
}

void ExchangeArcs::look(const AssignmentStep& context, const AssignmentNodes& seats,
                        std::span<const double> price, std::span<const float> own) {
    nearPlaces_.sort(context.input.places, edgeFor(context.input.places));
    nearCharacters_.sort(context.input.characters, edgeFor(context.input.characters));
    own_ = own;
    double sum = 0.0;
    std::int32_t matched = 0;
    highest_ = highestWaiting_ = -1;
    const auto higher = [&](std::int32_t a, std::int32_t b) { return b < 0 || price[a] > price[b]; };
    for (std::int32_t s = 0; s < seats.count(); ++s) {
        if (seats.holder(s) < 0) continue;
        if (!seats.live(s)) {
            if (higher(s, highestWaiting_)) highestWaiting_ = s;
            continue;
        }
        sum += own[s];
        ++matched;
        if (higher(s, highest_)) highest_ = s;
    }
    hotCost_ = kHotTimesMean * static_cast<float>(sum / std::max(matched, 1));
    hot_.clear();
    for (std::int32_t s = 0; s < seats.count(); ++s)
        if (seats.matched(s) && own[s] > hotCost_) hot_.push_back(s);
}

void ExchangeArcs::add(std::int32_t seat, std::int32_t& lane, std::int32_t end, std::int32_t to) {
    if (to < 0 || to == seat || lane >= end) return;
    const auto row = target_.begin() + static_cast<std::ptrdiff_t>(seat) * kLanes;
    if (std::find(row, row + lane, to) != row + lane) return;
    row[lane++] = to;
}

// Lanes without an arc.
void ExchangeArcs::leadHome(std::int32_t seat, std::int32_t& lane, std::int32_t end) {
    for (; lane < end; ++lane)
        target_[static_cast<std::size_t>(seat) * kLanes + static_cast<std::size_t>(lane)] = seat;
}

// The nearest seats among those that are hot; of very many some are looked at.
void ExchangeArcs::addHot(const AssignmentStep& context, const AssignmentNodes& seats, std::int32_t seat,
                          std::int32_t& lane) {
    constexpr std::int32_t kMost = 4;
    std::array<std::int32_t, kMost> best{};
    std::array<double, kMost> distance{};
    std::int32_t found = 0;
    const std::size_t stride = hot_.size() / kHotLookedAt + 1;
    for (std::size_t k = static_cast<std::size_t>(seat) % stride; k < hot_.size(); k += stride) {
        if (hot_[k] == seat) continue;
        const double d = lengthSquared(seats.at(hot_[k], context) - seats.at(seat, context));
        std::int32_t at = found;
        while (at > 0 && distance[at - 1] > d) --at;
        if (at == kMost) continue;
        found = std::min(found + 1, kMost);
        for (std::int32_t m = found - 1; m > at; --m) {
            best[m] = best[m - 1];
            distance[m] = distance[m - 1];
        }
        best[at] = hot_[k];
        distance[at] = d;
    }
    for (std::int32_t k = 0; k < found; ++k) add(seat, lane, kPricedLane, best[k]);
}

void ExchangeArcs::chooseTargets(const AssignmentStep& context, const AssignmentNodes& seats,
                                 std::int32_t seat) {
    std::int32_t lane = 0;
    const std::int32_t pricedTo = target(priced(seat));
    const std::int32_t holder = seats.holder(seat);
    if (holder >= 0 || seats.live(seat)) {
        const bool hot = seats.matched(seat) && own_[seat] > hotCost_;
        const std::int32_t places = hot ? kHotNearPlaces : kNearPlaces;
        const std::int32_t people = hot ? kHotNearCharacters : kNearCharacters;
        const auto& characters = context.input.characters;
        const Vec2 person = holder >= 0 ? characters[holder] : seats.at(seat, context);
        NearestPoints near;
        near.find(nearPlaces_, context.input.places, seats.live(seat) ? seats.at(seat, context) : person,
                  places, [&](std::int32_t p) { return p != seat && seats.live(p); });
        for (std::int32_t k = 0; k < near.size(); ++k) add(seat, lane, kPricedLane, near[k]);
        near.find(nearCharacters_, characters, person, people,
                  [&](std::int32_t i) { return i != holder && seats.seatOf(i) >= 0; });
        for (std::int32_t k = 0; k < near.size(); ++k) add(seat, lane, kPricedLane, seats.seatOf(near[k]));
        if (hot) addHot(context, seats, seat, lane);
        leadHome(seat, lane, kPricedLane);
        if (seats.live(pricedTo)) add(seat, lane, kLastLane, pricedTo);
        leadHome(seat, lane, kLastLane);
        add(seat, lane, kLanes, holder < 0 ? highest_ : highestWaiting_);
    }
    leadHome(seat, lane, kLanes);
}

// True where somebody would pay for going to a place.
inline bool ExchangeArcs::pays(const AssignmentNodes& seats, std::int32_t arc) const {
    return seats.holder(arc / kLanes) >= 0 && seats.live(target(arc));
}

inline void ExchangeArcs::note(const AssignmentNodes& seats, std::int32_t arc) {
    asked_.push_back(arc);
    if (pays(seats, arc)) pairs_.push_back({seats.holder(arc / kLanes), target(arc)});
}

// Notes which arcs of a row are worth a question, in order. Lanes that lead home have no weight.
void ExchangeArcs::ask(const AssignmentNodes& seats, std::int32_t seat, const Tight& tight) {
    const auto s = static_cast<std::size_t>(seat);
    const bool all = tight.price.empty();
    const double own = all ? 0.0 : tight.price[s];
    const double margin = all ? 0.0 : tight.margin[s];
    for (std::int32_t arc = seat * kLanes; arc < (seat + 1) * kLanes; ++arc) {
        const std::int32_t to = target(arc);
        if (to == seat) {
            setWeight(arc, kNever);
            continue;
        }
        if (!all && !(weight(arc) - tight.price[to] + own < margin)) continue;
        note(seats, arc);
    }
}

void ExchangeArcs::answer(const AssignmentStep& context, const AssignmentNodes& seats,
                          std::span<const double> ownPower) {
    std::size_t next = 0;
    for (const std::int32_t arc : asked_) {
        const double there = pays(seats, arc) ? context.power(answers_[next++]) : 0.0;
        setWeight(arc, weightBy(context, seats, ownPower, arc, there));
    }
}

float ExchangeArcs::weightBy(const AssignmentStep& context, const AssignmentNodes& seats,
                             std::span<const double> ownPower, std::int32_t arc, double there) const {
    return weightFor(context, seats, ownPower, arc / kLanes, target(arc), there);
}

float ExchangeArcs::weightFor(const AssignmentStep& context, const AssignmentNodes& seats,
                              std::span<const double> ownPower, std::int32_t from, std::int32_t to,
                              double there) const {
    const double frame = dot(context.slope, seats.at(to, context) - seats.at(from, context));
    return static_cast<float>(there - ownPower[from] - frame);
}

void ExchangeArcs::askFor(const AssignmentStep& context, const AssignmentNodes& seats,
                          std::span<const double> ownPower) {
    answers_.resize(pairs_.size());
    context.costs.evaluate(pairs_, answers_, context.pool);
    answer(context, seats, ownPower);
}

void ExchangeArcs::refreshArcs(const AssignmentStep& context, const AssignmentNodes& seats,
                               std::span<const double> ownPower, std::span<const std::int32_t> arcs) {
    while (!arcs.empty()) {
        const auto some = arcs.first(std::min(arcs.size(), kRowsAtOnce * kLanes));
        clearQuestions();
        for (const std::int32_t arc : some)
            if (target(arc) != arc / kLanes) note(seats, arc);
        askFor(context, seats, ownPower);
        arcs = arcs.subspan(some.size());
    }
}

void ExchangeArcs::refresh(const AssignmentStep& context, const AssignmentNodes& seats,
                           std::span<const double> ownPower, std::span<const std::int32_t> rows,
                           const Tight& tight) {
    while (!rows.empty()) {
        const auto some = rows.first(std::min(rows.size(), kRowsAtOnce));
        clearQuestions();
        for (const std::int32_t s : some) ask(seats, s, tight);
        askFor(context, seats, ownPower);
        rows = rows.subspan(some.size());
    }
}

void ExchangeArcs::clearQuestions() {
    asked_.clear();
    pairs_.clear();
}

void ExchangeArcs::sortByTarget() {
    std::fill(start_.begin(), start_.end(), 0);
    // Unsigned, so that numbers of seats need no sign when they become addresses.
    const std::int32_t* targets = target_.data();
    std::int32_t* start = start_.data();
    std::int32_t* into = into_.data();
    for (std::size_t k = 0; k < target_.size(); ++k) ++start[static_cast<std::uint32_t>(targets[k])];
    std::int32_t sum = 0;
    for (std::int32_t& s : start_) s = sum += s;
    for (std::size_t k = target_.size(); k-- > 0;)
        into[static_cast<std::uint32_t>(
            --start[static_cast<std::uint32_t>(targets[k])])] = static_cast<std::int32_t>(k);
}

std::int32_t ExchangeArcs::find(std::int32_t from, std::int32_t to) const {
    const std::int32_t first = from * kLanes;
    const std::int32_t* row = target_.data() + first;
    // Backward and to the end: without a branch the compiler compares several at once.
    std::int32_t lane = kLanes;
    for (std::int32_t k = kLanes; k-- > 0;) lane = row[k] == to ? k : lane;
    return lane < kLanes ? first + lane : -1;
}

bool ExchangeArcs::consistent() const {
    const auto seats = static_cast<std::int32_t>(target_.size() / kLanes);
    if (target_.size() % kLanes != 0 || weight_.size() != target_.size()) return false;
    return std::all_of(target_.begin(), target_.end(), [&](std::int32_t t) { return t >= 0 && t < seats; });
}

}  // namespace muster
