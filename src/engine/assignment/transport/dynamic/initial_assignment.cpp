#include "engine/assignment/transport/dynamic/initial_assignment.h"

#include <algorithm>

#include "base/infinite_cost.h"
#include "engine/assignment/transport/dynamic/kd_partition.h"

namespace muster {
namespace {

constexpr std::size_t kGreedyPairs = 4096;  // Number of pairs up to which they are matched greedily.
// Number of pairs up to which this is by cost, else by straight distance.
constexpr std::size_t kEvaluatedPairs = 256;
// Number on one side up to which each takes its nearest counterpart one by one.
constexpr std::size_t kFewOnOneSide = 16;
constexpr std::int32_t kPointsPerLeaf = 48;
constexpr std::int32_t kMostLeaves = 256;
constexpr std::size_t kExactSize = 16;  // Size up to which sets are assigned exactly.

Vec2 meanOf(std::span<const Vec2> points, std::span<const std::int32_t> indices) {
    Vec2 sum;
    for (const std::int32_t k : indices) sum += points[k];
    return indices.empty() ? sum : sum / static_cast<double>(indices.size());
}

// The point nearest to the mean, the first of several.
std::int32_t centralPoint(std::span<const Vec2> points, std::span<const std::int32_t> indices) {
    const Vec2 mean = meanOf(points, indices);
    double least = kInfiniteCost;
    std::int32_t central = -1;
    for (const std::int32_t k : indices) {
        const double d = lengthSquared(points[k] - mean);
        if (!(d < least)) continue;
        least = d;
        central = k;
    }
    return central;
}

std::span<std::int32_t> leaf(std::vector<std::int32_t>& indices, const std::vector<std::int32_t>& ends,
                             std::int32_t k) {
    return {indices.data() + (k > 0 ? ends[k - 1] : 0), indices.data() + ends[k]};
}

}  // namespace

void InitialAssignment::reserve(std::size_t characters, std::size_t places) {
    choices_.reserve(std::min(kGreedyPairs, characters * places));
    const std::size_t evaluated = std::min(kEvaluatedPairs, characters * places);
    pairs_.reserve(evaluated);
    pairCosts_.reserve(evaluated);
}

void InitialAssignment::run(const AssignmentProblem& problem, AssignmentNodes& nodes) {
    if (nodes.unmatched().empty() || nodes.freePlaces().empty()) return;
    characters_.assign(nodes.unmatched().begin(), nodes.unmatched().end());
    places_.assign(nodes.freePlaces().begin(), nodes.freePlaces().end());
    while (!characters_.empty() && !places_.empty()) {
        if (characters_.size() * places_.size() <= kGreedyPairs)
            matchGreedily(problem, nodes);
        else if (std::min(characters_.size(), places_.size()) <= kFewOnOneSide)
            matchEachToNearest(problem, nodes);
        else
            matchLeaves(problem, nodes);
        removeMatched(nodes);
    }
}

void InitialAssignment::removeMatched(const AssignmentNodes& nodes) {
    std::erase_if(characters_,
                  [&](std::int32_t i) { return nodes.nodeOf(i) >= 0 && nodes.isPlace(nodes.nodeOf(i)); });
    std::erase_if(places_, [&](std::int32_t node) { return nodes.assignee(node) >= 0; });
    std::sort(characters_.begin(), characters_.end());
    std::sort(places_.begin(), places_.end());
}

void InitialAssignment::matchGreedily(const AssignmentProblem& problem, AssignmentNodes& nodes) {
    choices_.clear();
    pairs_.clear();
    const bool byCost = characters_.size() * places_.size() <= kEvaluatedPairs;
    for (const std::int32_t i : characters_)
        for (const std::int32_t node : places_) {
            const Vec2 line = problem.input.places[node] - problem.input.characters[i];
            choices_.push_back({lengthSquared(line), i, node});
            if (byCost) pairs_.push_back({i, node});
        }
    pairCosts_.resize(pairs_.size());
    if (byCost) problem.costs.evaluate(pairs_, pairCosts_, problem.pool);
    for (std::size_t k = 0; k < pairCosts_.size(); ++k) choices_[k].cost = pairCosts_[k];
    std::sort(choices_.begin(), choices_.end(), [](const Choice& a, const Choice& b) {
        if (a.cost != b.cost) return a.cost < b.cost;
        return a.character != b.character ? a.character < b.character : a.node < b.node;
    });
    for (const Choice& choice : choices_) {
        const std::int32_t before = nodes.nodeOf(choice.character);
        if ((before < 0 || !nodes.isPlace(before)) && nodes.assignee(choice.node) < 0)
            nodes.match(choice.character, choice.node);
    }
}

// With few on one side and many on the other, each of the few takes the nearest of the many.
void InitialAssignment::matchEachToNearest(const AssignmentProblem& problem, AssignmentNodes& nodes) {
    const AssignmentInput& input = problem.input;
    const bool fewCharacters = characters_.size() <= places_.size();
    auto& many = fewCharacters ? places_ : characters_;
    const auto& manyPositions = fewCharacters ? input.places : input.characters;
    const auto& fewPositions = fewCharacters ? input.characters : input.places;
    for (const std::int32_t one : fewCharacters ? characters_ : places_) {
        double least = kInfiniteCost;
        std::size_t nearest = 0;
        for (std::size_t k = 0; k < many.size(); ++k) {
            if (many[k] < 0) continue;
            const double d = lengthSquared(manyPositions[many[k]] - fewPositions[one]);
            if (!(d < least)) continue;
            least = d;
            nearest = k;
        }
        nodes.match(fewCharacters ? one : many[nearest], fewCharacters ? many[nearest] : one);
        many[nearest] = -1;
    }
    std::erase(many, -1);
}

void InitialAssignment::matchLeaves(const AssignmentProblem& problem, AssignmentNodes& nodes) {
    const auto& characterPositions = problem.input.characters;
    const auto& placePositions = problem.input.places;
    const auto fewer = static_cast<std::int32_t>(std::min(characters_.size(), places_.size()));
    const std::int32_t leaves = std::clamp(fewer / kPointsPerLeaf, 1, kMostLeaves);
    characterLeafEnds_.clear();
    placeLeafEnds_.clear();
    partitionIntoLeaves(characterPositions, characters_, leaves, 0, characterLeafEnds_);
    partitionIntoLeaves(placePositions, places_, leaves, 0, placeLeafEnds_);
    evaluateLeafCosts(problem, leaves);
    leafSolver_.solve(leaves, leaves, matrix_.data());
    for (std::int32_t a = 0; a < leaves; ++a) {
        const auto characters = leaf(characters_, characterLeafEnds_, a);
        const auto places = leaf(places_, placeLeafEnds_, leafSolver_.columnOf()[a]);
        const Vec2 shift = meanOf(placePositions, places) - meanOf(characterPositions, characters);
        matchWithinLeaf(problem, nodes, characters, places, shift);
    }
}

// Fills the matrix with the costs between the central points of leaves.
void InitialAssignment::evaluateLeafCosts(const AssignmentProblem& problem, std::int32_t leaves) {
    const CostPower power(problem.def.exponent);
    matrix_.resize(leaves * leaves);
    centralPlaces_.clear();
    for (std::int32_t b = 0; b < leaves; ++b)
        centralPlaces_.push_back(centralPoint(problem.input.places, leaf(places_, placeLeafEnds_, b)));
    pairCosts_.resize(leaves);
    for (std::int32_t a = 0; a < leaves; ++a) {
        const auto characters = leaf(characters_, characterLeafEnds_, a);
        const std::int32_t central = centralPoint(problem.input.characters, characters);
        pairs_.clear();
        for (const std::int32_t place : centralPlaces_) pairs_.push_back({central, place});
        problem.costs.evaluate(pairs_, pairCosts_, problem.pool);
        for (std::int32_t b = 0; b < leaves; ++b) matrix_[a * leaves + b] = power(pairCosts_[b]);
    }
}

// Halves both sets along the longer side of the places until one of them is small.
void InitialAssignment::matchWithinLeaf(const AssignmentProblem& problem, AssignmentNodes& nodes,
                                        std::span<std::int32_t> characters, std::span<std::int32_t> places,
                                        Vec2 shift) {
    if (characters.empty() || places.empty()) return;
    if (std::max(characters.size(), places.size()) <= kExactSize ||
        std::min(characters.size(), places.size()) < 2) {
        std::sort(characters.begin(), characters.end());
        std::sort(places.begin(), places.end());
        matchExactly(problem, nodes, characters, places, shift);
        return;
    }
    const bool alongX = isWide(problem.input.places, places);
    const std::size_t halfCharacters = characters.size() / 2;
    const std::size_t halfPlaces = places.size() / 2;
    partitionAlong(problem.input.characters, characters, halfCharacters, alongX);
    partitionAlong(problem.input.places, places, halfPlaces, alongX);
    matchWithinLeaf(problem, nodes, characters.first(halfCharacters), places.first(halfPlaces), shift);
    matchWithinLeaf(problem, nodes, characters.subspan(halfCharacters), places.subspan(halfPlaces), shift);
}

// Assigns by squared straight distance after moving the characters by `shift`.
void InitialAssignment::matchExactly(const AssignmentProblem& problem, AssignmentNodes& nodes,
                                     std::span<const std::int32_t> characters,
                                     std::span<const std::int32_t> places, Vec2 shift) {
    const bool transposed = characters.size() > places.size();
    const auto rows = transposed ? places : characters;
    const auto columns = transposed ? characters : places;
    matrix_.resize(std::max(matrix_.size(), rows.size() * columns.size()));
    for (std::size_t a = 0; a < rows.size(); ++a)
        for (std::size_t b = 0; b < columns.size(); ++b) {
            const std::int32_t character = transposed ? columns[b] : rows[a];
            const std::int32_t place = transposed ? rows[a] : columns[b];
            matrix_[a * columns.size() + b] = lengthSquared(problem.input.places[place] -
                                                            problem.input.characters[character] - shift);
        }
    pairSolver_.solve(static_cast<std::int32_t>(rows.size()), static_cast<std::int32_t>(columns.size()),
                      matrix_.data());
    for (std::size_t a = 0; a < rows.size(); ++a) {
        const std::int32_t b = pairSolver_.columnOf()[a];
        if (b >= 0) nodes.match(transposed ? columns[b] : rows[a], transposed ? rows[a] : columns[b]);
    }
}

}  // namespace muster
