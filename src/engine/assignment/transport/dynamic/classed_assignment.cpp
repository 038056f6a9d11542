#include "engine/assignment/transport/dynamic/classed_assignment.h"

#include <algorithm>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr std::size_t kClasses = 256;
// Least number of slots of a class beyond its places, and their fraction of these.
constexpr std::int32_t kSpareSlots = 4;
constexpr std::int32_t kSpareShare = 8;
// Number of characters that are matched outside their classes in one step.
constexpr std::int32_t kLeftOverPerStep = 256;

/// Costs of the characters and slots of one class.
class PartCosts final : public CostOracle {
public:
    PartCosts(CostOracle& all, std::span<const std::int32_t> members, std::span<const std::int32_t> places)
        : all_(all), members_(members), places_(places) {}

    float cost(std::int32_t character, std::int32_t place) override {
        return all_.cost(members_[character], places_[place]);
    }
    double leastUnitCost() const override { return all_.leastUnitCost(); }
    double lowerBound(std::int32_t character, std::int32_t place) const override {
        return all_.lowerBound(members_[character], places_[place]);
    }
    bool unsteady(std::int32_t character, std::int32_t place) const override {
        return all_.unsteady(members_[character], places_[place]);
    }
    void evaluate(std::span<const AssignmentPair> pairs, std::span<float> cost, ThreadPool& pool) override {
        constexpr std::size_t kChunk = 256;
        forChunks(&pool, pairs.size(), kChunk, [&](std::size_t k) {
            cost[k] = all_.cost(members_[pairs[k].character], places_[pairs[k].place]);
        });
    }

private:
    CostOracle& all_;
    std::span<const std::int32_t> members_;
    std::span<const std::int32_t> places_;
};

}  // namespace

bool ClassedAssignment::consistent() const {
    const auto characters = static_cast<std::int32_t>(placeOf_.size());
    if (cost_.size() != placeOf_.size()) return false;
    std::int32_t last = -1;
    for (const Part& part : parts_) {
        if (part.unitClass <= last) return false;
        last = part.unitClass;
        for (std::size_t k = 0; k < part.members.size(); ++k)
            if (part.members[k] < 0 || part.members[k] >= characters ||
                (k > 0 && part.members[k] <= part.members[k - 1]))
                return false;
        // Places are tested once their number is known.
        for (const std::int32_t place : part.places)
            if (place < -1) return false;
        const std::span<const std::int32_t> placeOf = part.assignment.placeOf();
        if (!placeOf.empty() && placeOf.size() != part.members.size()) return false;
        for (const std::int32_t slot : placeOf)
            if (slot < -1 || slot >= std::ssize(part.places)) return false;
    }
    return true;
}

// Sorts members into parts. Parts whose members change start again.
void ClassedAssignment::sortMembers(const AssignmentInput& input, const AssignmentClasses& classes) {
    members_.resize(kClasses);
    for (auto& list : members_) list.clear();
    for (std::int32_t i = 0; std::cmp_less(i, input.characters.size()); ++i)
        members_[classes.character[i]].push_back(i);
    std::erase_if(parts_, [&](const Part& part) { return members_[part.unitClass].empty(); });
    for (std::size_t c = 0, k = 0; c < kClasses; ++c) {
        if (members_[c].empty()) continue;
        if (k == parts_.size() || parts_[k].unitClass != c) {
            const auto at = parts_.begin() + static_cast<std::ptrdiff_t>(k);
            parts_.insert(at, Part{})->unitClass = static_cast<std::uint8_t>(c);
        }
        Part& part = parts_[k++];
        if (part.members == members_[c]) continue;
        part.members = members_[c];
        part.assignment.clear();
    }
}

// A place that leaves the class, or that nobody may take, leaves an empty slot, which another place may get
// from the next step on. Where slots are too few all are dealt out again, and false is returned.
bool ClassedAssignment::sortPlaces(Part& part, const AssignmentInput& input,
                                   const AssignmentClasses& classes) {
    const auto belongs = [&](std::int32_t place) {
        return classes.place[place] == part.unitClass && input.isUsable(place);
    };
    constexpr std::int32_t kLeft = -2;
    const auto places = static_cast<std::int32_t>(input.places.size());
    for (std::int32_t slot = 0; slot < std::ssize(part.places); ++slot) {
        std::int32_t& place = part.places[slot];
        if (place >= places || (place >= 0 && !belongs(place)))
            place = kLeft;
        else if (place >= 0)
            slotOf_[place] = slot;
    }
    std::size_t next = 0;
    std::int32_t count = 0;
    bool fits = true;
    for (std::int32_t place = 0; place < places; ++place) {
        if (!belongs(place)) continue;
        ++count;
        if (slotOf_[place] >= 0 || !fits) continue;
        while (next < part.places.size() && part.places[next] != -1) ++next;
        fits = next < part.places.size();
        if (!fits) continue;
        slotOf_[place] = static_cast<std::int32_t>(next);
        part.places[next] = place;
    }
    std::replace(part.places.begin(), part.places.end(), kLeft, -1);
    if (fits) return true;
    part.places.clear();
    for (std::int32_t place = 0; place < places; ++place) {
        if (!belongs(place)) continue;
        slotOf_[place] = static_cast<std::int32_t>(part.places.size());
        part.places.push_back(place);
    }
    part.places.resize(count + kSpareSlots + count / kSpareShare, -1);
    return false;
}

// Empty slots stand where the first place is, so that they widen no box.
void ClassedAssignment::gather(const Part& part, const AssignmentInput& input,
                               std::span<const std::int32_t> incumbent) {
    input_.characters.clear();
    input_.present.clear();
    input_.incumbent.clear();
    for (const std::int32_t i : part.members) {
        input_.characters.push_back(input.characters[i]);
        input_.present.push_back(input.isPresent(i) ? 1 : 0);
        const std::int32_t place = incumbent.empty() ? -1 : incumbent[i];
        const std::int32_t slot = place >= 0 ? slotOf_[place] : -1;
        // The slot may belong to another class.
        const bool own = slot >= 0 && slot < std::ssize(part.places) && part.places[slot] == place;
        input_.incumbent.push_back(own ? slot : -1);
    }
    input_.places.clear();
    input_.usable.clear();
    const auto known = std::find_if(part.places.begin(), part.places.end(),
                                    [](std::int32_t place) { return place >= 0; });
    const Vec2 empty = known != part.places.end() ? input.places[*known] : Vec2{};
    for (const std::int32_t place : part.places) {
        input_.places.push_back(place >= 0 ? input.places[place] : empty);
        input_.usable.push_back(place >= 0 ? 1 : 0);
    }
}

// True where the incumbents stay: a character whose place left the class has none.
bool ClassedAssignment::holdsIncumbents(const Part& part) const {
    const std::span<const std::int32_t> placeOf = part.assignment.placeOf();
    if (placeOf.size() != part.members.size()) return false;
    for (std::size_t k = 0; k < placeOf.size(); ++k) {
        const bool kept = placeOf[k] >= 0 && part.places[placeOf[k]] >= 0;
        if ((kept ? placeOf[k] : -1) != input_.incumbent[k]) return false;
    }
    return true;
}

void ClassedAssignment::publish(const Part& part) {
    for (std::size_t k = 0; k < part.members.size(); ++k) {
        const std::int32_t slot = part.assignment.placeOf()[k];
        const std::int32_t place = slot >= 0 ? part.places[slot] : -1;
        placeOf_[part.members[k]] = place;
        cost_[part.members[k]] = place >= 0 ? part.assignment.cost()[k] : 0.0f;
        if (place >= 0) taken_[place] = 1;
    }
}

// Lets a character keep a place of another class that is still free, and gives the others the nearest ones.
void ClassedAssignment::fillUp(const AssignmentInput& input, std::span<const std::int32_t> incumbent,
                               CostOracle& costs, ThreadPool& pool) {
    unmatched_.clear();
    free_.clear();
    pairs_.clear();
    for (std::int32_t i = 0; std::cmp_less(i, placeOf_.size()); ++i) {
        if (placeOf_[i] >= 0 || !input.isPresent(i)) continue;
        const std::int32_t before = incumbent.empty() ? -1 : incumbent[i];
        if (before >= 0 && taken_[before] == 0 && input.isUsable(before)) {
            taken_[before] = 1;
            pairs_.push_back({i, before});
        } else {
            unmatched_.push_back(i);
        }
    }
    for (std::int32_t j = 0; std::cmp_less(j, taken_.size()); ++j)
        if (taken_[j] == 0 && input.isUsable(j)) free_.push_back(j);
    matchLeftOver(input);
    pairCosts_.resize(pairs_.size());
    costs.evaluate(pairs_, pairCosts_, pool);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        placeOf_[pairs_[k].character] = pairs_[k].place;
        cost_[pairs_[k].character] = pairCosts_[k];
    }
}

void ClassedAssignment::matchLeftOver(const AssignmentInput& input) {
    const std::size_t most = std::min<std::size_t>(unmatched_.size(), kLeftOverPerStep);
    for (std::size_t k = 0; k < most && !free_.empty(); ++k) {
        const Vec2 p = input.characters[unmatched_[k]];
        const auto nearest = std::min_element(
            free_.begin(), free_.end(), [&](std::int32_t a, std::int32_t b) {
                return lengthSquared(input.places[a] - p) < lengthSquared(input.places[b] - p);
            });
        pairs_.push_back({unmatched_[k], *nearest});
        free_.erase(nearest);
    }
}

void ClassedAssignment::coldStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                  const AssignmentClasses& classes, CostOracle& costs, ThreadPool& pool) {
    for (Part& part : parts_) part.assignment.clear();
    update(def, input, classes, {}, costs, pool);
}

void ClassedAssignment::update(const DynamicAssignmentDef& def, const AssignmentInput& input,
                               const AssignmentClasses& classes, std::span<const std::int32_t> incumbent,
                               CostOracle& costs, ThreadPool& pool) {
    sortMembers(input, classes);
    slotOf_.assign(input.places.size(), -1);
    taken_.assign(input.places.size(), 0);
    placeOf_.assign(input.characters.size(), -1);
    cost_.assign(input.characters.size(), 0.0f);
    for (Part& part : parts_) {
        if (!sortPlaces(part, input, classes)) part.assignment.clear();
        gather(part, input, incumbent);
        const AssignmentInput own{input_.characters, input_.places, input_.usable, input_.present};
        PartCosts partCosts(costs, part.members, part.places);
        if (incumbent.empty()) {
            part.assignment.coldStart(def, own, partCosts, pool);
        } else {
            if (!holdsIncumbents(part))
                part.assignment.warmStart(def, own, input_.incumbent, partCosts, pool);
            part.assignment.update(def, own, partCosts, pool);
        }
        publish(part);
    }
    fillUp(input, incumbent, costs, pool);
}

double ClassedAssignment::dualityGap() const {
    double gap = 0.0;
    for (const Part& part : parts_) gap += part.assignment.dualityGap();
    return gap;
}

}  // namespace muster
