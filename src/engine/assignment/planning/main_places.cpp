#include "engine/assignment/planning/main_places.h"

namespace muster {
namespace {

constexpr double kKeptShare = 0.8;  // Share of the largest flow down to which a place is kept.

}  // namespace

void findMainPlaces(std::span<const Flow> flows, std::span<const std::int32_t> incumbent,
                    std::vector<std::int32_t>& place) {
    place.assign(incumbent.size(), -1);
    for (std::size_t k = 0; k < flows.size();) {
        const std::int32_t i = flows[k].character;
        double most = 0.0, kept = 0.0;
        for (; k < flows.size() && flows[k].character == i; ++k) {
            const Flow& flow = flows[k];
            if (flow.place == incumbent[i]) kept = flow.amount;
            if (flow.amount <= most) continue;
            most = flow.amount;
            place[i] = flow.place;
        }
        if (kept > 0.0 && kept >= kKeptShare * most) place[i] = incumbent[i];
    }
}

}  // namespace muster
