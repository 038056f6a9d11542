// Going round agents that hold their ground (SPEC B15).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/state/world_state.h"
#include "engine/steering/crowd_bodies.h"

namespace muster {

/// Turns the direction of a character that leads into a cluster of agents that hold their ground to the end
/// of the cluster by which the route to its place is shorter.
class GoRound {
public:
    /// Changes directions. `targets` holds the point for which each character heads in the end [m].
    void run(WorldState& state, const CrowdBodies& bodies, std::span<const Vec2> targets);
    /// After run(), by character: 1 where a cluster closes its route between walls. Empty where nobody holds.
    std::span<const std::uint8_t> barred() const { return barred_; }

private:
    enum class Side : std::uint8_t { Left, Right, None };

    // Holders that leave no gap for others.
    struct Cluster {
        std::size_t first, end;  // Range of its members in members_.
        Box box;                 // Bounds of their centres.
        double largest;          // Largest radius [m].
    };

    void findHolders(const WorldState& state);
    void findClusters(const CrowdBodies& bodies);
    std::int32_t rootOf(std::int32_t k);
    bool hasOwn(const Characters& c, const Cluster& cluster, std::uint32_t group) const;
    bool isClosedByOthers(const CrowdBodies& bodies, const Cluster& cluster, Vec2 end,
                          std::int32_t character) const;
    Side sideOf(const WorldState& state, const CrowdBodies& bodies, const Cluster& cluster, Vec2 target,
                std::int32_t character) const;
    void turn(WorldState& state, const CrowdBodies& bodies, const Cluster& cluster, Vec2 target,
              std::int32_t character);

    std::vector<std::int32_t> holders_;  // Indices of characters that hold their ground.
    std::vector<Vec2> positions_;        // Positions of the holders [m].
    NeighbourList pairs_;
    std::vector<std::int32_t> root_;     // Union-find over holders.
    std::vector<std::int32_t> members_;  // Characters of the clusters, cluster by cluster.
    std::vector<Vec2> memberPositions_;  // Positions of the members [m].
    std::vector<std::int32_t> order_;    // Indices of holders, sorted by root.
    std::vector<Cluster> clusters_;
    std::vector<std::uint8_t> barred_;  // By character.
};

}  // namespace muster
