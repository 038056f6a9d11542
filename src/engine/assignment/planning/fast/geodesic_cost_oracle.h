// The cost oracle of the fast plan: pair costs by geodesics or by straight lines.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "engine/assignment/planning/planned_ways.h"
#include "engine/assignment/transport/dynamic/cost_oracle.h"
#include "engine/fields/geodesics/geodesics.h"

namespace muster {

/// Costs of the characters to their incumbent places are given, since their guidance has evaluated them
/// already.
class GeodesicCostOracle final : public CostOracle {
public:
    /// Takes the state of this step; all must outlive the last query. `incumbentCost` is the cost of each
    /// character to its place in `incumbent` (-1 for none) [m]. `geodesic` is false for straight-line costs.
    /// `slowness` is as in PlanInput; `incumbentCost` counts it. Places other than its own cost a character
    /// more by the share `reluctance`, 0 or more.
    void set(const Geodesics& geodesics, const PlannedWays& ways, bool geodesic,
             std::span<const Vec2> characters, std::span<const Vec2> places,
             std::span<const std::int32_t> incumbent, std::span<const float> incumbentCost,
             std::span<const float> slowness, std::span<const float> reluctance) {
        geodesics_ = &geodesics;
        ways_ = ways;
        geodesic_ = geodesic;
        characters_ = characters;
        places_ = places;
        incumbent_ = incumbent;
        incumbentCost_ = incumbentCost;
        slowness_ = slowness;
        reluctance_ = reluctance;
        leastSlowness_ = 1.0f;
        for (const float factor : slowness) leastSlowness_ = std::min(leastSlowness_, factor);
    }
    /// The cost of a path for a character, where it costs others `walk` [m]. A slow character can still reach
    /// all places that others reach.
    static float slowed(float walk, float slowness) {
        constexpr float kMost = 0.999f * kUnreachable;
        return walk < kMost ? std::min(walk * slowness, kMost) : walk;
    }
    float cost(std::int32_t character, std::int32_t place) override { return pairCost(character, place); }
    double leastUnitCost() const override {
        return leastSlowness_ * (geodesic_ ? geodesics_->leastUnitCost() : 1.0);
    }
    double lowerBound(std::int32_t character, std::int32_t place) const override {
        if (!geodesic_) return 0.0;
        const double walk = geodesics_->lowerBound(characters_[character], place);
        return slowness_.empty() ? walk : slowed(static_cast<float>(walk), slowness_[character]);
    }
    bool unsteady(std::int32_t character, std::int32_t place) const override {
        return geodesic_ && (geodesics_->hasMovingCost(characters_[character]) ||
                             geodesics_->hasMovingCost(places_[place]));
    }
    void evaluate(std::span<const AssignmentPair> pairs, std::span<float> cost, ThreadPool& pool) override {
        constexpr std::size_t kChunk = 256;
        forChunks(&pool, pairs.size(), kChunk,
                  [&](std::size_t k) { cost[k] = pairCost(pairs[k].character, pairs[k].place); });
    }

private:
    float pairCost(std::int32_t character, std::int32_t place) const {
        if (incumbent_[character] == place) return incumbentCost_[character];
        const float factor = 1.0f + reluctance_[character];
        return slowed(rawCost(character, place), slowness_.empty() ? factor : factor * slowness_[character]);
    }
    float rawCost(std::int32_t character, std::int32_t place) const {
        if (!geodesic_) return static_cast<float>(distance(characters_[character], places_[place]));
        const double byWay = ways_.cost(character, place, places_.size());
        return byWay < kInfiniteCost ? static_cast<float>(byWay)
                                     : geodesics_->cost(characters_[character], place);
    }

    const Geodesics* geodesics_ = nullptr;
    PlannedWays ways_;
    bool geodesic_ = true;
    std::span<const Vec2> characters_;         // Positions of the characters [m].
    std::span<const Vec2> places_;             // Positions of the places [m].
    std::span<const std::int32_t> incumbent_;  // Incumbent per character, -1 for none.
    std::span<const float> incumbentCost_;     // Cost per character [m].
    std::span<const float> slowness_;          // Slowness per character; empty for all 1.
    std::span<const float> reluctance_;        // Reluctance per character.
    float leastSlowness_ = 1.0f;
};

}  // namespace muster
