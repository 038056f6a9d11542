#include "engine/assignment/transport/dynamic/transport_tree.h"

#include <algorithm>
#include <limits>

namespace muster {

void TransportTree::reset(std::int32_t characters, std::int32_t places) {
    characters_ = characters;
    places_ = places;
    parent_.assign(root(), root());
    flow_.assign(root(), 0);
    arcCost_.assign(root(), {});
    link();
}

// Plants each part from its hook.
void TransportTree::plant(std::span<const std::int32_t> character, std::span<const std::int32_t> place,
                          std::span<const std::int32_t> hook) {
    edgeBegin_.assign(root() + 2, 0);
    for (std::size_t k = 0; k < character.size(); ++k) {
        ++edgeBegin_[character[k] + 1];
        ++edgeBegin_[nodeOfPlace(place[k]) + 1];
    }
    for (std::size_t k = 1; k < edgeBegin_.size(); ++k) edgeBegin_[k] += edgeBegin_[k - 1];
    edges_.assign(2 * character.size(), 0);
    depth_.assign(root() + 1, 0);  // Edges of each node that are filled in.
    for (std::size_t k = 0; k < character.size(); ++k) {
        const std::int32_t i = character[k], j = nodeOfPlace(place[k]);
        edges_[edgeBegin_[i] + depth_[i]++] = j;
        edges_[edgeBegin_[j] + depth_[j]++] = i;
    }
    parent_.assign(root(), -1);
    for (const std::int32_t start : hook) {
        if (parent_[start] >= 0) continue;
        parent_[start] = root();
        stack_.assign(1, start);
        while (!stack_.empty()) {
            const std::int32_t node = stack_.back();
            stack_.pop_back();
            for (std::int32_t k = edgeBegin_[node]; k < edgeBegin_[node + 1]; ++k) {
                if (parent_[edges_[k]] >= 0) continue;
                parent_[edges_[k]] = node;
                stack_.push_back(edges_[k]);
            }
        }
    }
    std::replace(parent_.begin(), parent_.end(), -1, root());
    link();
}

bool TransportTree::consistent() {
    if (characters_ < 0 || places_ < 0 || std::ssize(parent_) != std::int64_t{characters_} + places_)
        return false;
    for (std::int32_t v = 0; v < root(); ++v) {
        const std::int32_t p = parent_[v];
        if (p < 0 || p > root() || (p < root() && isCharacter(p) == isCharacter(v))) return false;
    }
    flow_.assign(root(), 0);
    arcCost_.assign(root(), {});
    link();
    return findOrder();
}

// Lists children in ascending order, so that all that follows depends on the tree alone.
void TransportTree::link() {
    firstChild_.assign(root() + 1, -1);
    nextSibling_.assign(root() + 1, -1);
    previousSibling_.assign(root() + 1, -1);
    for (std::int32_t v = root() - 1; v >= 0; --v) {
        const std::int32_t head = firstChild_[parent_[v]];
        nextSibling_[v] = head;
        if (head >= 0) previousSibling_[head] = v;
        firstChild_[parent_[v]] = v;
    }
}

// False where some nodes do not lead to the root.
bool TransportTree::findOrder() {
    depth_.assign(root() + 1, 0);
    order_.assign(1, root());
    for (std::size_t k = 0; k < order_.size(); ++k)
        for (std::int32_t c = firstChild_[order_[k]]; c >= 0; c = nextSibling_[c]) {
            depth_[c] = depth_[order_[k]] + 1;
            order_.push_back(c);
        }
    return std::ssize(order_) == root() + 1;
}

void TransportTree::unlink(std::int32_t node) {
    const std::int32_t before = previousSibling_[node], after = nextSibling_[node];
    if (before >= 0)
        nextSibling_[before] = after;
    else
        firstChild_[parent_[node]] = after;
    if (after >= 0) previousSibling_[after] = before;
}

void TransportTree::adopt(std::int32_t node, std::int32_t parent) {
    parent_[node] = parent;
    previousSibling_[node] = -1;
    nextSibling_[node] = firstChild_[parent];
    if (nextSibling_[node] >= 0) previousSibling_[nextSibling_[node]] = node;
    firstChild_[parent] = node;
}

void TransportTree::hangOnRoot(std::int32_t node) {
    unlink(node);
    adopt(node, root());
}

// Finds flows from the leaves up. A place always gets something from its parent, else the tree is not
// strongly feasible.
bool TransportTree::findFlows(std::span<const std::int64_t> supply, std::span<const std::int64_t> demand) {
    bool changed = false;
    for (std::size_t k = order_.size(); k-- > 1;) {
        const std::int32_t v = order_[k];
        const std::int64_t least = isCharacter(v) ? 0 : 1;
        std::int64_t left = isCharacter(v) ? supply[v] : demand[v - characters_];
        const bool idle = left == 0;
        for (std::int32_t c = firstChild_[v]; c >= 0; c = nextSibling_[c]) left -= flow_[c];
        for (std::int32_t c = firstChild_[v]; c >= 0 && (idle || left < least);) {
            const std::int32_t next = nextSibling_[c];
            if (idle || flow_[c] > 0) {
                left += flow_[c];
                hangOnRoot(c);
                changed = true;
            }
            c = next;
        }
        flow_[v] = left;
        if (!idle || parent_[v] == root()) continue;
        hangOnRoot(v);
        changed = true;
    }
    return changed;
}

void TransportTree::balance(std::span<const std::int64_t> supply, std::span<const std::int64_t> demand) {
    link();
    findOrder();
    if (!findFlows(supply, demand)) return;
    link();
    findOrder();
}

bool TransportTree::pairOf(std::int32_t node, std::int32_t& character, std::int32_t& place) const {
    const std::int32_t p = parent_[node];
    if (p == root()) return false;
    character = isCharacter(node) ? node : p;
    place = (isCharacter(node) ? p : node) - characters_;
    return true;
}

std::int32_t TransportTree::mainPlace(std::int32_t character) const {
    std::int32_t best = -1;
    std::int64_t most = 0;
    const auto consider = [&](std::int32_t place, std::int64_t amount) {
        if (amount < most || (amount == most && (amount == 0 || place > best))) return;
        most = amount;
        best = place;
    };
    if (parent_[character] != root()) consider(parent_[character] - characters_, flow_[character]);
    for (std::int32_t c = firstChild_[character]; c >= 0; c = nextSibling_[c])
        consider(c - characters_, flow_[c]);
    return best;
}

void TransportTree::findDuals() {
    dual_.assign(root() + 1, {});
    for (std::size_t k = 1; k < order_.size(); ++k) {
        const std::int32_t v = order_[k];
        if (parent_[v] == root()) arcCost_[v] = {kUnsentLevel, 0.0};
        dual_[v] = arcCost_[v] - dual_[parent_[v]];
    }
}

// Sends as much as the cycle of an arc can carry; returns the node below the leaving arc: of the arcs that
// carry nothing any more the last one along the cycle from its highest node (Cunningham 1976).
std::int32_t TransportTree::push(std::int32_t tail, std::int32_t head, std::int64_t& most,
                                 std::int64_t& work) {
    most = std::numeric_limits<std::int64_t>::max();
    std::int32_t leaving = -1;
    std::int32_t i = tail, j = head;
    while (i != j) {
        ++work;
        if (depth_[i] >= depth_[j]) {
            if (isCharacter(i) && flow_[i] < most) {
                most = flow_[i];
                leaving = i;
            }
            i = parent_[i];
        } else {
            if (!isCharacter(j) && flow_[j] <= most) {
                most = flow_[j];
                leaving = j;
            }
            j = parent_[j];
        }
    }
    for (std::int32_t v = tail; v != i; v = parent_[v]) flow_[v] += isCharacter(v) ? -most : most;
    for (std::int32_t v = head; v != i; v = parent_[v]) flow_[v] += isCharacter(v) ? most : -most;
    return leaving;
}

// Reverses the path from `node` up to `top`, and hangs it on `parent`.
void TransportTree::reroot(std::int32_t node, std::int32_t top, std::int32_t parent, LevelCost cost,
                           std::int64_t flow, std::int64_t& work) {
    std::int32_t next = node;
    for (std::int32_t above = parent;;) {
        const std::int32_t v = next;
        next = parent_[v];
        const LevelCost oldCost = arcCost_[v];
        const std::int64_t oldFlow = flow_[v];
        unlink(v);
        adopt(v, above);
        arcCost_[v] = cost;
        flow_[v] = flow;
        cost = oldCost;
        flow = oldFlow;
        above = v;
        ++work;
        if (v == top) return;
    }
}

// Changes the duals below and with `top` so that they suit its arc: by `change` for nodes of its kind, by the
// opposite for others; and finds depths.
std::int64_t TransportTree::shift(std::int32_t top, LevelCost change) {
    const bool kind = isCharacter(top);
    const LevelCost opposite{-change.level, -change.value};
    std::int64_t work = 0;
    stack_.assign(1, top);
    while (!stack_.empty()) {
        const std::int32_t v = stack_.back();
        stack_.pop_back();
        ++work;
        depth_[v] = depth_[parent_[v]] + 1;
        dual_[v] = dual_[v] + (isCharacter(v) == kind ? change : opposite);
        for (std::int32_t c = firstChild_[v]; c >= 0; c = nextSibling_[c]) stack_.push_back(c);
    }
    return work;
}

std::int64_t TransportTree::pivot(std::int32_t tail, std::int32_t head, LevelCost cost) {
    std::int64_t work = 0;
    const LevelCost change = reducedCost(tail, head, cost);
    std::int64_t amount = 0;
    const std::int32_t leaving = push(tail, head, amount, work);
    // The path to a character's arc begins at the tail, the path to a place's at the head.
    if (isCharacter(leaving)) {
        reroot(tail, leaving, head, cost, amount, work);
        return work + shift(tail, change);
    }
    reroot(head, leaving, tail, cost, amount, work);
    return work + shift(head, change);
}

}  // namespace muster
