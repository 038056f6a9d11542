// The nodes of the exchange graph and their assignees.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/assignment_step.h"

namespace muster {

/// As many nodes as there are characters or places, whichever is more. Node k stands for place k while that
/// place is usable; every other node is a dummy node, whose assignee is unmatched (Burkard, Dell'Amico,
/// Martello 2009, 4.1). A node without an assignee is free.
class AssignmentNodes {
public:
    /// Sizes the nodes; all become free dummy nodes.
    void reset(std::int32_t characters, std::int32_t places);
    /// Assigns each character to the node of its place, -1 for none. Of several characters that name one
    /// place the first gets it.
    void assignPlaces(std::span<const std::int32_t> placeOf);
    /// Takes over which characters are present and which places are usable. Lists the unmatched characters
    /// and the free places, and adds to `changed` the nodes that became or ceased to be places or lost their
    /// assignee.
    void update(const AssignmentInput& input, std::vector<std::int32_t>& changed);
    /// Assigns dummy nodes to the unmatched characters that have no node yet. After update().
    void assignDummyNodes();
    /// Assigns a character (-1: none) to a node. The node it had before is not cleared.
    void assign(std::int32_t node, std::int32_t character) {
        assignee_[node] = character;
        if (character >= 0) nodeOf_[character] = node;
    }
    /// Moves an unmatched character to the node of a free place.
    void match(std::int32_t character, std::int32_t node);

    std::int32_t count() const { return static_cast<std::int32_t>(assignee_.size()); }  ///< Number of nodes.
    /// Number of characters at reset().
    std::int32_t characters() const { return static_cast<std::int32_t>(nodeOf_.size()); }
    std::int32_t places() const { return places_; }                        ///< Number of places at reset().
    bool isPlace(std::int32_t node) const { return isPlace_[node] != 0; }  ///< False for dummy nodes.
    /// Assignee of a node, -1 for a free node.
    std::int32_t assignee(std::int32_t node) const { return assignee_[node]; }
    /// The node of a character, -1 for none.
    std::int32_t nodeOf(std::int32_t character) const { return nodeOf_[character]; }
    /// True where the node is a place and has an assignee.
    bool isMatched(std::int32_t node) const { return isPlace(node) && assignee(node) >= 0; }
    /// Position of a node's place [m]; AssignmentStep::dummyPosition for a dummy node.
    Vec2 position(std::int32_t node, const AssignmentStep& step) const {
        return isPlace(node) ? step.input.places[node] : step.dummyPosition;
    }
    /// Unmatched characters at the last update(), ascending.
    const std::vector<std::int32_t>& unmatched() const { return unmatched_; }
    /// Nodes of free places at the last update(), ascending.
    const std::vector<std::int32_t>& freePlaces() const { return freePlaces_; }

    /// Lets an archive read or write the nodes.
    template <class Archive>
    void visit(Archive& archive) {
        archive(places_, assignee_, nodeOf_, isPlace_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    bool consistent() const;

    std::int32_t places_ = 0;               // Number of places.
    std::vector<std::int32_t> assignee_;    // Per node: a character, -1 for none.
    std::vector<std::int32_t> nodeOf_;      // Per character: its node, -1 for none.
    std::vector<std::uint8_t> isPlace_;     // Per node: 0 for a dummy node.
    std::vector<std::int32_t> unmatched_;   // Characters, of the last update().
    std::vector<std::int32_t> freePlaces_;  // Nodes, of the last update().
};

}  // namespace muster
