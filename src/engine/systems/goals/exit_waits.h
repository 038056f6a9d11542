// How long people will wait before exits: those who have chosen each exit, by the time of their way, served
// one after the other (Lindley 1952; docs/method/goals.md).
#pragma once

#include <cstdint>
#include <vector>

namespace muster {

/// Queues before exits, of which all people are counted once in a step.
class ExitWaits {
public:
    /// Nobody is counted, for so many exits.
    void clear(std::size_t exits);
    /// Somebody goes to an exit, `walk` [s] away.
    void add(std::size_t exit, double walk) { count_[exit * kBins + binOf(walk)] += 1.0f; }
    /// True where people queue before an exit that lets so many a second through: some are there, and more
    /// come within a while than it lets through by then.
    bool isQueued(std::size_t exit, double flow) const;
    /// Finds when each will have left. `capacity(walk)` tells how many a second get through on the way of so
    /// many [s].
    template <class Capacity>
    void serve(std::size_t exit, const Capacity& capacity) {
        double left = 0.0;
        for (std::size_t k = 0; k < kBins; ++k) {
            const std::size_t at = exit * kBins + k;
            before_[at] = static_cast<float>(left);
            perPerson_[at] = static_cast<float>(1.0 / capacity(static_cast<double>(k) * kBin));
            left = count_[at] > 0.0f
                       ? timeAfter(left, static_cast<double>(k) * kBin, count_[at], perPerson_[at])
                       : left;
        }
    }
    /// When somebody whose way to an exit takes `walk` [s] will have left by it [s].
    double leaves(std::size_t exit, double walk) const;

private:
    static constexpr double kNear = 3.0;        // Whose way takes less than this is before the exit [s].
    static constexpr double kThere = 0.5;       // So much of what passes in that time are some.
    static constexpr double kSoon = 15.0;       // Who comes within this comes soon [s].
    static constexpr double kBin = 0.5;         // [s]
    static constexpr std::size_t kBins = 1024;  // Ways that take longer count as that long.

    static std::size_t binOf(double walk) {
        const double bin = walk / kBin;
        return bin < static_cast<double>(kBins - 1) ? static_cast<std::size_t>(bin > 0.0 ? bin : 0.0)
                                                    : kBins - 1;
    }
    static double timeAfter(double left, double walk, double people, double perPerson) {
        return (left > walk ? left : walk) + people * perPerson;
    }

    std::vector<float> count_;      // People by exit and bin.
    std::vector<float> before_;     // When those of the bins before have left [s].
    std::vector<float> perPerson_;  // Time for each [s].
};

}  // namespace muster
