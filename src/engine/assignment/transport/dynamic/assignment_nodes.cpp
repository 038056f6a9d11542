#include "engine/assignment/transport/dynamic/assignment_nodes.h"

#include <algorithm>
#include <utility>

namespace muster {

void AssignmentNodes::reset(std::int32_t characters, std::int32_t places) {
    const std::int32_t nodes = std::max(characters, places);
    places_ = places;
    assignee_.assign(nodes, -1);
    nodeOf_.assign(characters, -1);
    isPlace_.assign(nodes, 0);
    unmatched_.reserve(nodes);
    freePlaces_.reserve(nodes);
}

void AssignmentNodes::assignPlaces(std::span<const std::int32_t> placeOf) {
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t place = placeOf[i];
        if (place >= 0 && place < places_ && assignee(place) < 0) assign(place, i);
    }
}

void AssignmentNodes::update(const AssignmentInput& input, std::vector<std::int32_t>& changed) {
    unmatched_.clear();
    freePlaces_.clear();
    for (std::int32_t node = 0; node < count(); ++node) {
        const std::uint8_t place = node < places_ && input.isUsable(node) ? 1 : 0;
        if (place != isPlace_[node]) changed.push_back(node);
        isPlace_[node] = place;
    }
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t node = nodeOf(i);
        if (!input.isPresent(i)) {
            if (node >= 0) {
                assign(node, -1);
                changed.push_back(node);
            }
            nodeOf_[i] = -1;
        } else if (node < 0 || !isPlace(node)) {
            unmatched_.push_back(i);
        }
    }
    for (std::int32_t node = 0; node < count(); ++node)
        if (isPlace(node) && assignee(node) < 0) freePlaces_.push_back(node);
}

void AssignmentNodes::match(std::int32_t character, std::int32_t node) {
    const std::int32_t before = nodeOf(character);
    if (before >= 0) assign(before, -1);
    assign(node, character);
}

void AssignmentNodes::assignDummyNodes() {
    std::int32_t node = 0;
    for (const std::int32_t i : unmatched_) {
        if (nodeOf(i) >= 0) continue;
        while (isPlace(node) || assignee(node) >= 0) ++node;
        assign(node, i);
    }
}

bool AssignmentNodes::consistent() const {
    const std::int32_t nodes = std::max(characters(), places_);
    if (places_ < 0 || count() != nodes || std::cmp_not_equal(isPlace_.size(), nodes)) return false;
    for (std::int32_t node = 0; node < nodes; ++node) {
        const std::int32_t i = assignee(node);
        if (i < -1 || i >= characters() || (i >= 0 && nodeOf(i) != node)) return false;
    }
    for (std::int32_t i = 0; i < characters(); ++i) {
        const std::int32_t node = nodeOf(i);
        if (node < -1 || node >= nodes || (node >= 0 && assignee(node) != i)) return false;
    }
    return true;
}

}  // namespace muster
