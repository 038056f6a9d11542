// Costs of pairs for the fast plan.
#pragma once

#include <span>
#include <vector>

#include "assignment/dynamic/cost_oracle.h"
#include "geodesics/geodesics.h"

namespace muster {

/// By geodesics, or by straight lines where these are asked for; what was worked out for the walkers
/// themselves is not worked out again.
class FastCosts final : public CostOracle {
public:
    /// Takes what holds in this step. `own` is the cost of each character to its place in `ownPlace`, -1 for
    /// none.
    void set(const Geodesics& geodesics, bool geodesic, std::span<const Vec2> characters,
             std::span<const Vec2> places, std::span<const std::int32_t> ownPlace,
             std::span<const float> own) {
        geodesics_ = &geodesics;
        geodesic_ = geodesic;
        characters_ = characters;
        places_ = places;
        ownPlace_ = ownPlace;
        own_ = own;
    }
    float cost(std::int32_t character, std::int32_t place) override { return price(character, place); }
    double leastUnitCost() const override { return geodesic_ ? geodesics_->leastUnitCost() : 1.0; }
    double lowerBound(std::int32_t character, std::int32_t place) const override {
        return geodesic_ ? geodesics_->lowerBound(characters_[character], place) : 0.0;
    }
    bool unsteady(std::int32_t character, std::int32_t place) const override {
        return geodesic_ && (geodesics_->hasMovingCost(characters_[character]) ||
                             geodesics_->hasMovingCost(places_[place]));
    }
    void evaluate(std::span<const AssignmentPair> pairs, std::span<float> cost, ThreadPool& pool) override {
        constexpr std::size_t kChunk = 256;
        forChunks(&pool, pairs.size(), kChunk,
                  [&](std::size_t k) { cost[k] = price(pairs[k].character, pairs[k].place); });
    }

private:
    float price(std::int32_t character, std::int32_t place) const {
        if (ownPlace_[character] == place) return own_[character];
        if (!geodesic_) return static_cast<float>(distance(characters_[character], places_[place]));
        return geodesics_->cost(characters_[character], place);
    }

    const Geodesics* geodesics_ = nullptr;
    bool geodesic_ = true;
    std::span<const Vec2> characters_;
    std::span<const Vec2> places_;
    std::span<const std::int32_t> ownPlace_;
    std::span<const float> own_;
};

}  // namespace muster
