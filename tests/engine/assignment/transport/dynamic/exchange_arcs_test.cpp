#include "engine/assignment/transport/dynamic/exchange_arcs.h"

#include <doctest.h>

#include "base/random.h"

using namespace muster;

TEST_CASE("incoming arcs are those of the heads, whether heads were changed or written again") {
    constexpr std::int32_t kNodes = 20;
    Random random(5);
    ExchangeArcs arcs;
    arcs.reset(kNodes);
    for (int round = 0; round < 300; ++round) {
        const auto node = static_cast<std::int32_t>(random.below(kNodes));
        const std::int32_t generated = arcs.head(ExchangeArcs::generatedArc(node));
        const bool again = round % 3 == 0;
        const std::vector<std::int32_t> heads(arcs.heads().begin() + node * ExchangeArcs::kArcsPerNode,
                                              arcs.heads().begin() + (node + 1) * ExchangeArcs::kArcsPerNode);
        std::int32_t slot = 0;
        for (std::int32_t k = 0; k < 6; ++k)
            arcs.add(node, slot, 6, again ? heads[k] : static_cast<std::int32_t>(random.below(kNodes)));
        arcs.padWithSelfLoops(node, slot, 6);
        arcs.setGeneratedArc(node, again ? generated : static_cast<std::int32_t>(random.below(kNodes)), 1.0f);
        arcs.indexIncoming();
        std::size_t count = 0;
        for (std::int32_t head = 0; head < kNodes; ++head) {
            std::int32_t last = -1;
            for (const std::int32_t arc : arcs.incoming(head)) {
                CHECK(arcs.head(arc) == head);
                CHECK(arc > last);
                last = arc;
                ++count;
            }
        }
        CHECK(count == arcs.heads().size());
    }
}
