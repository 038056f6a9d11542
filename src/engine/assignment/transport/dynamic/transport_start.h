// The first basis of a transportation problem whose characters and places lie in the plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/classed_assignment.h"
#include "engine/assignment/transport/dynamic/transport_tree.h"

namespace muster {

/// Orders characters and places alike, by halving both along the longer side of the places again and again,
/// and fills places in that order (the rule of the northwest corner, Dantzig 1951); each class for itself.
/// Owns its working memory.
class TransportStart {
public:
    /// Plants the tree. Amounts are in units, 0 for characters and places that take no part.
    void run(const AssignmentInput& input, const AssignmentClasses& classes,
             std::span<const std::int64_t> supply, std::span<const std::int64_t> demand, TransportTree& tree);
    /// Plants the tree of a plan that goes on: each character hangs together with its place in `incumbent`
    /// (-1 for none), as far as that is still open.
    void keep(std::span<const std::int32_t> incumbent, std::span<const std::int64_t> supply,
              std::span<const std::int64_t> demand, TransportTree& tree);

private:
    void order(const AssignmentInput& input, std::span<std::int32_t> characters,
               std::span<std::int32_t> places);
    void fill(std::span<const std::int32_t> characters, std::span<const std::int32_t> places,
              const TransportTree& tree);

    std::span<const std::int64_t> supply_, demand_;      // Amounts per character and per place [units].
    std::vector<std::int32_t> characters_, places_;      // Characters and places of one class, in order.
    std::vector<std::int32_t> fromCharacter_, toPlace_;  // Pairs.
    std::vector<std::int32_t> hook_;                     // Hooks as of TransportTree::plant.
    std::vector<std::int64_t> open_;                     // Remaining demand per place [units].
    std::vector<std::int32_t> last_;  // Per place: the last character that hangs on it, -1 for none.
};

}  // namespace muster
