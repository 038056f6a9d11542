#include "planning/exact/commit_rule.h"

#include <algorithm>
#include <cmath>

namespace muster {

std::int32_t CommitRule::find(std::int32_t node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
}

void CommitRule::join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
}

// Calls visit(flow, incumbent amount, best amount) for every pair in either list, in order.
template <class Visit>
void CommitRule::merge(std::span<const Flow> incumbent, std::span<const Flow> best, Visit visit) const {
    const auto before = [](const Flow& a, const Flow& b) {
        return a.character != b.character ? a.character < b.character : a.place < b.place;
    };
    std::size_t a = 0;
    std::size_t b = 0;
    while (a < incumbent.size() || b < best.size()) {
        if (b == best.size() || (a < incumbent.size() && before(incumbent[a], best[b]))) {
            visit(incumbent[a], incumbent[a].amount, 0.0);
            ++a;
        } else if (a == incumbent.size() || before(best[b], incumbent[a])) {
            visit(best[b], 0.0, best[b].amount);
            ++b;
        } else {
            visit(best[b], incumbent[a].amount, best[b].amount);
            ++a;
            ++b;
        }
    }
}

// Where the longest walk counts first, a piece also changes for shortening it, from its own dearest pair to
// the dearest of the best flows.
bool CommitRule::worthwhile(const PlanDef& def, const Piece& piece, double dearest) const {
    const auto least = [&](double cost) {
        return std::max(def.commitThreshold, def.commitThresholdShare * cost);
    };
    if (piece.moreMatched > dust_) return true;
    if (def.bottleneck && piece.incumbentDearest - dearest > least(piece.incumbentDearest)) return true;
    return piece.incumbentCost - piece.bestCost > least(piece.incumbentCost);
}

void CommitRule::choose(const PlanDef& def, std::int32_t characters, std::int32_t places,
                        std::span<const double> cost, std::span<const Flow> incumbent,
                        std::span<const Flow> best, std::vector<Flow>& committed) {
    const auto nodes = static_cast<std::size_t>(characters) + static_cast<std::size_t>(places);
    parent_.resize(nodes);
    for (std::size_t k = 0; k < nodes; ++k) parent_[k] = static_cast<std::int32_t>(k);
    pieces_.assign(nodes, {});
    dust_ = 0.0;
    for (const Flow& flow : best) dust_ = std::max(dust_, 1e-9 * flow.amount);
    const auto differ = [this](double before, double after) { return std::abs(after - before) > dust_; };

    merge(incumbent, best, [&](const Flow& flow, double before, double after) {
        if (differ(before, after)) join(flow.character, characters + flow.place);
    });
    double dearest = 0.0;  // Of the best flows.
    merge(incumbent, best, [&](const Flow& flow, double before, double after) {
        const double c = cost[static_cast<std::size_t>(flow.character) * static_cast<std::size_t>(places) +
                              static_cast<std::size_t>(flow.place)];
        if (after > dust_) dearest = std::max(dearest, c);
        if (!differ(before, after)) return;
        Piece& piece = pieces_[find(flow.character)];
        if (before > dust_) piece.incumbentDearest = std::max(piece.incumbentDearest, c);
        piece.moreMatched += after - before;
        piece.incumbentCost += c * before;
        piece.bestCost += c * after;
    });
    for (Piece& piece : pieces_) piece.take = worthwhile(def, piece, dearest);
    committed.clear();
    merge(incumbent, best, [&](const Flow& flow, double before, double after) {
        const bool take = !differ(before, after) || pieces_[find(flow.character)].take;
        const double amount = take ? after : before;
        if (amount > 0.0) committed.push_back({flow.character, flow.place, amount});
    });
}

}  // namespace muster
