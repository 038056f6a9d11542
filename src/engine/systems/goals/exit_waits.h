// Waits of people at doors and before exits: people come to each in the order of the times of their walks,
// are served one after the other (Lindley 1952), and walk on to the next (docs/method/goals.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace muster {

/// Queues at exits and at ways through doors; all people are counted once in a step. The nodes are all exits,
/// then all ways.
class ExitWaits {
public:
    /// The node to which a person goes after a way.
    struct Hop {
        std::size_t node = 0;
        double walk = 0.0;  ///< Time of the walk to it [s].
    };
    /// Begins without people, for a number of exits and ways.
    void clear(std::size_t exits, std::size_t ways);
    /// The node of a way.
    std::size_t nodeOf(std::int32_t way) const { return exits_ + static_cast<std::size_t>(way); }
    /// Counts a person who leaves by an exit and goes to a node first, `walk` [s] away.
    void add(std::size_t node, std::size_t exit, double walk) {
        const std::size_t bin = binOf(walk);
        while (bin >= people_.bins) people_.addBin(nodes(), ways_ * exits_);
        people_.count[bin * nodes() + node] += 1.0f;
        if (node >= exits_) people_.byExit[splitAt(bin, node, exit)] += 1.0f;
    }
    /// Counts a person in the line before an exit, or where it lets people out: whoever comes is served
    /// later.
    void addToLine(std::size_t exit) { inLine_[exit] += 1.0; }
    /// True where people queue before an exit that lets `flow` people a second through: some are there, and
    /// more come within a while than it lets through by then. Call after serveWays().
    bool isQueued(std::size_t exit, double flow) const;
    /// Finds the times at which people will have left the ways, and sends them to the next nodes. `flow(way)`
    /// is the number of people a second that get through, `hop(way, exit, time)` the next node of people who
    /// leave by an exit.
    template <class Flow, class NextHop>
    void serveWays(const Flow& flow, const NextHop& hop);
    /// Finds the times at which people will have left by an exit, after serveWays(). The first one is let out
    /// after `begins` [s], the rest of a service that has begun. `capacity(walk)` is the number of people a
    /// second that get through on a route of `walk` [s].
    template <class Capacity>
    void serve(std::size_t exit, double begins, const Capacity& capacity) {
        begins_[exit] = begins;
        perNode_[exit] = 1.0 / capacity(0.0);
        double left = begins + inLine_[exit] * perNode_[exit];
        for (std::size_t k = 0; k < all_.bins; ++k) {
            const std::size_t at = k * nodes() + exit;
            before_[at] = static_cast<float>(left);
            if (!(all_.count[at] > 0.0f)) continue;
            const double walk = static_cast<double>(k) * kBinTime;
            perPerson_[at] = static_cast<float>(1.0 / capacity(walk));
            left = timeAfter(left, walk, all_.count[at], perPerson_[at]);
        }
        left_[exit] = left;
    }
    /// Time at which a person whose walk to a node takes `walk` [s] will have passed it [s]; a person who has
    /// been counted there does not wait for itself.
    double leaves(std::size_t node, double walk, bool isCounted) const;
    /// Time at which a person in the line before an exit will have left, behind `ahead` others [s].
    double leavesLine(std::size_t exit, std::int32_t ahead, double walk) const;
    /// Time that one person takes at a node [s].
    double perPerson(std::size_t node) const { return perNode_[node]; }
    /// Time at which a person who comes to a way at a time will have passed it, as far as is known while the
    /// people of `now` are served [s]; for serveWays().
    double passes(std::int32_t way, double now, double at) const;

private:
    // Time of a walk below which a person is before the exit [s].
    static constexpr double kBeforeExitTime = 3.0;
    // Share of the flow in kBeforeExitTime above which people count as a queue.
    static constexpr double kQueueShare = 0.5;
    static constexpr double kSoonTime = 15.0;     // Time of a walk below which a person comes soon [s].
    static constexpr double kBinTime = 0.5;       // Length of a bin [s].
    static constexpr std::size_t kBins = 1024;    // Number of bins; longer walks count in the last one.
    static constexpr double kLeastPeople = 1e-3;  // Number of people below which a bin counts as empty.

    /// People by the time of their way.
    struct Coming {
        std::size_t bins = 0;       // Number of bins in use.
        std::vector<float> count;   // By bin and node.
        std::vector<float> byExit;  // By bin, way and exit.

        void addBin(std::size_t nodes, std::size_t split) {
            ++bins;
            count.resize(bins * nodes, 0.0f);
            byExit.resize(bins * split, 0.0f);
        }
    };

    std::size_t nodes() const { return exits_ + ways_; }
    std::size_t splitAt(std::size_t bin, std::size_t node, std::size_t exit) const {
        return (bin * ways_ + node - exits_) * exits_ + exit;
    }
    static std::size_t binOf(double walk) {
        const double bin = walk / kBinTime;
        return bin < static_cast<double>(kBins - 1) ? static_cast<std::size_t>(bin > 0.0 ? bin : 0.0)
                                                    : kBins - 1;
    }
    static double timeAfter(double left, double walk, double people, double perPerson) {
        return (left > walk ? left : walk) + people * perPerson;
    }
    void beginServing();
    void addBin();
    void come(std::size_t node, std::size_t exit, std::size_t bin, double people) {
        if (bin >= kBins) bin = kBins - 1;
        while (bin >= all_.bins) addBin();
        all_.count[bin * nodes() + node] += static_cast<float>(people);
        if (node >= exits_) all_.byExit[splitAt(bin, node, exit)] += static_cast<float>(people);
    }

    std::size_t exits_ = 0, ways_ = 0;
    Coming people_;                 // People as they were added.
    Coming all_;                    // People with those who come from other doors.
    std::vector<float> before_;     // When the people of the bins before have passed [s], by bin and node.
    std::vector<float> perPerson_;  // Time that one person takes [s], by bin and node.
    std::vector<double> left_;      // When all people have passed [s], by node.
    std::vector<double> begins_;    // When the first in the line is let out [s], by exit.
    std::vector<double> inLine_;    // People in the line, by exit.
    std::vector<double> queue_;     // Queue in the bin at hand, by way and exit.
    std::vector<double> waiting_;   // By way.
    std::vector<double> perNode_;   // Time that one person takes [s], by node.
};

template <class Flow, class NextHop>
void ExitWaits::serveWays(const Flow& flow, const NextHop& hop) {
    beginServing();
    for (std::size_t way = 0; way < ways_; ++way)
        perNode_[exits_ + way] = 1.0 / flow(static_cast<std::int32_t>(way));
    for (std::size_t k = 0; k < kBins && ways_ > 0; ++k) {
        const double now = static_cast<double>(k) * kBinTime;
        bool isOver = k >= all_.bins;
        if (isOver) addBin();
        for (std::size_t way = 0; way < ways_; ++way) {
            const std::size_t node = exits_ + way, at = k * nodes() + node;
            const auto people = static_cast<double>(all_.count[at]);
            before_[at] = static_cast<float>(left_[node]);
            if (!(people + waiting_[way] > kLeastPeople)) continue;
            isOver = false;
            perPerson_[at] = static_cast<float>(perNode_[node]);
            if (people > 0.0) left_[node] = timeAfter(left_[node], now, people, perNode_[node]);
            const double most = kBinTime / perNode_[node], sum = people + waiting_[way];
            const double share = sum > most ? most / sum : 1.0;
            waiting_[way] = 0.0;
            for (std::size_t e = 0; e < exits_; ++e) {
                double& queue = queue_[way * exits_ + e];
                queue += static_cast<double>(all_.byExit[splitAt(k, node, e)]);
                if (!(queue > 0.0)) continue;
                const Hop next = hop(static_cast<std::int32_t>(way), e, now);
                const std::size_t walk = binOf(next.walk);
                come(next.node, e, k + (walk > 0 ? walk : 1), queue * share);
                queue = share < 1.0 ? queue * (1.0 - share) : 0.0;
                waiting_[way] += queue;
            }
        }
        if (isOver) return;
    }
}

}  // namespace muster
