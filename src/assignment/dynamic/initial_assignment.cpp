#include "assignment/dynamic/initial_assignment.h"

#include <algorithm>
#include <limits>

#include "assignment/dynamic/kd_partition.h"

namespace muster {
namespace {

constexpr std::size_t kFewPairs = 4096;  // So many are all compared.
constexpr std::size_t kTruePairs = 256;  // So many by their costs, more by straight distance.
constexpr std::size_t kFewOnOneSide = 16;
constexpr std::int32_t kPerPart = 48;
constexpr std::int32_t kMostParts = 256;
constexpr std::size_t kExact = 16;  // Parts this small are matched exactly.

Vec2 meanOf(std::span<const Vec2> points, std::span<const std::int32_t> some) {
    Vec2 sum;
    for (const std::int32_t k : some) sum += points[k];
    return some.empty() ? sum : sum / static_cast<double>(some.size());
}

// The one nearest to the mean, of equals the first.
std::int32_t middleOf(std::span<const Vec2> points, std::span<const std::int32_t> some) {
    const Vec2 mean = meanOf(points, some);
    double least = std::numeric_limits<double>::infinity();
    std::int32_t middle = -1;
    for (const std::int32_t k : some) {
        const double d = lengthSquared(points[k] - mean);
        if (!(d < least)) continue;
        least = d;
        middle = k;
    }
    return middle;
}

std::span<std::int32_t> part(std::vector<std::int32_t>& all, const std::vector<std::int32_t>& ends,
                             std::size_t k) {
    const auto begin = static_cast<std::size_t>(k > 0 ? ends[k - 1] : 0);
    return {all.data() + begin, static_cast<std::size_t>(ends[k]) - begin};
}

}  // namespace

InitialAssignment::InitialAssignment() {
    choices_.reserve(kFewPairs);
    pairs_.reserve(kTruePairs);
    answers_.reserve(kTruePairs);
}

void InitialAssignment::seat(const AssignmentStep& context, ExchangeGraph& state) {
    AssignmentNodes& seats = state.seats;
    if (seats.waiting().empty() || seats.free().empty()) return;
    people_.assign(seats.waiting().begin(), seats.waiting().end());
    places_.assign(seats.free().begin(), seats.free().end());
    while (!people_.empty() && !places_.empty()) {
        if (people_.size() * places_.size() <= kFewPairs)
            few(context, seats);
        else if (std::min(people_.size(), places_.size()) <= kFewOnOneSide)
            nearestOfMany(context, seats);
        else
            parts(context, seats);
        keepOpen(seats);
    }
}

void InitialAssignment::keepOpen(const AssignmentNodes& seats) {
    std::erase_if(people_,
                  [&](std::int32_t i) { return seats.seatOf(i) >= 0 && seats.live(seats.seatOf(i)); });
    std::erase_if(places_, [&](std::int32_t s) { return seats.holder(s) >= 0; });
    std::sort(people_.begin(), people_.end());
    std::sort(places_.begin(), places_.end());
}

void InitialAssignment::few(const AssignmentStep& context, AssignmentNodes& seats) {
    choices_.clear();
    pairs_.clear();
    const bool byCost = people_.size() * places_.size() <= kTruePairs;
    for (const std::int32_t i : people_)
        for (const std::int32_t s : places_) {
            const Vec2 way = context.input.places[s] - context.input.characters[i];
            choices_.push_back({lengthSquared(way), i, s});
            if (byCost) pairs_.push_back({i, s});
        }
    answers_.resize(pairs_.size());
    if (byCost) context.costs.evaluate(pairs_, answers_, context.pool);
    for (std::size_t k = 0; k < answers_.size(); ++k) choices_[k].cost = answers_[k];
    std::sort(choices_.begin(), choices_.end(), [](const Choice& a, const Choice& b) {
        if (a.cost != b.cost) return a.cost < b.cost;
        return a.character != b.character ? a.character < b.character : a.seat < b.seat;
    });
    for (const Choice& choice : choices_) {
        const std::int32_t at = seats.seatOf(choice.character);
        if ((at < 0 || !seats.live(at)) && seats.holder(choice.seat) < 0)
            seats.take(choice.character, choice.seat);
    }
}

// Few on one side, many on the other: each of the few takes the nearest.
void InitialAssignment::nearestOfMany(const AssignmentStep& context, AssignmentNodes& seats) {
    const bool fewPeople = people_.size() <= places_.size();
    auto& many = fewPeople ? places_ : people_;
    const auto& manyAt = fewPeople ? context.input.places : context.input.characters;
    const auto& fewAt = fewPeople ? context.input.characters : context.input.places;
    for (const std::int32_t one : fewPeople ? people_ : places_) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t best = 0;
        for (std::size_t k = 0; k < many.size(); ++k) {
            if (many[k] < 0) continue;
            const double d = lengthSquared(manyAt[many[k]] - fewAt[one]);
            if (!(d < least)) continue;
            least = d;
            best = k;
        }
        seats.take(fewPeople ? one : many[best], fewPeople ? many[best] : one);
        many[best] = -1;
    }
    std::erase(many, -1);
}

void InitialAssignment::parts(const AssignmentStep& context, AssignmentNodes& seats) {
    const auto& characters = context.input.characters;
    const auto& placesAt = context.input.places;
    const auto fewer = static_cast<std::int32_t>(std::min(people_.size(), places_.size()));
    const std::int32_t count = std::clamp(fewer / kPerPart, 1, kMostParts);
    peopleEnds_.clear();
    placeEnds_.clear();
    divideIntoLeaves(characters, people_, count, 0, peopleEnds_);
    divideIntoLeaves(placesAt, places_, count, 0, placeEnds_);
    const auto n = static_cast<std::size_t>(count);
    matrix_.resize(n * n);
    placeMiddles_.clear();
    for (std::size_t b = 0; b < n; ++b)
        placeMiddles_.push_back(middleOf(placesAt, part(places_, placeEnds_, b)));
    for (std::size_t a = 0; a < n; ++a) {
        pairs_.clear();
        const std::int32_t person = middleOf(characters, part(people_, peopleEnds_, a));
        for (const std::int32_t place : placeMiddles_) pairs_.push_back({person, place});
        answers_.resize(n);
        context.costs.evaluate(pairs_, answers_, context.pool);
        for (std::size_t b = 0; b < n; ++b) matrix_[a * n + b] = context.power(answers_[b]);
    }
    dense_.solve(count, count, matrix_.data());
    for (std::size_t a = 0; a < n; ++a) {
        const auto people = part(people_, peopleEnds_, a);
        const auto places = part(places_, placeEnds_, static_cast<std::size_t>(dense_.columnOf()[a]));
        within(context, seats, people, places, meanOf(placesAt, places) - meanOf(characters, people));
    }
}

// Halves both along the places' longer side until they are small.
void InitialAssignment::within(const AssignmentStep& context, AssignmentNodes& seats,
                               std::span<std::int32_t> people, std::span<std::int32_t> places, Vec2 shift) {
    if (people.empty() || places.empty()) return;
    if (std::max(people.size(), places.size()) <= kExact || std::min(people.size(), places.size()) < 2) {
        std::sort(people.begin(), people.end());
        std::sort(places.begin(), places.end());
        exactly(context, seats, people, places, shift);
        return;
    }
    const bool alongX = isWide(context.input.places, places);
    divide(context.input.characters, people, people.size() / 2, alongX);
    divide(context.input.places, places, places.size() / 2, alongX);
    within(context, seats, people.first(people.size() / 2), places.first(places.size() / 2), shift);
    within(context, seats, people.subspan(people.size() / 2), places.subspan(places.size() / 2), shift);
}

void InitialAssignment::exactly(const AssignmentStep& context, AssignmentNodes& seats,
                                std::span<const std::int32_t> people, std::span<const std::int32_t> places,
                                Vec2 shift) {
    const bool turned = people.size() > places.size();
    const auto rows = turned ? places : people;
    const auto columns = turned ? people : places;
    matrix_.resize(std::max(matrix_.size(), rows.size() * columns.size()));
    for (std::size_t a = 0; a < rows.size(); ++a)
        for (std::size_t b = 0; b < columns.size(); ++b) {
            const std::int32_t person = turned ? columns[b] : rows[a];
            const std::int32_t place = turned ? rows[a] : columns[b];
            matrix_[a * columns.size() + b] = lengthSquared(context.input.places[place] -
                                                            context.input.characters[person] - shift);
        }
    small_.solve(static_cast<std::int32_t>(rows.size()), static_cast<std::int32_t>(columns.size()),
                 matrix_.data());
    for (std::size_t a = 0; a < rows.size(); ++a) {
        const std::int32_t b = small_.columnOf()[a];
        if (b >= 0) seats.take(turned ? columns[b] : rows[a], turned ? rows[a] : columns[b]);
    }
}

}  // namespace muster
