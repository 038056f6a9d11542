// The sparse graph of exchanges: from each seat sixteen arcs to seats its holder might rather have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/assignment_nodes.h"
#include "assignment/dynamic/nearest_points.h"

namespace muster {

/// Arcs between seats with their weights. The weight of the arc from a to b is what the objective changes
/// when the holder of a moves to b, in the frame of the prices: C(a's holder, b) - C(a's holder, a) - slope .
/// (b - a). It keeps the value it had when the row was last refreshed. Arcs are numbered seat by seat.
class ExchangeArcs {
public:
    static constexpr std::int32_t kLanes = 16;       ///< Arcs from each seat.
    static constexpr std::int32_t kPricedLane = 14;  ///< Of these one is kept for what pricing finds.
    /// Weight of an arc that is not there; such an arc leads to its own seat.
    static constexpr float kNever = 1e35f;

    /// Removes all arcs.
    void reset(std::int32_t seats);
    /// Sorts characters and places, notes seats that are far dearer than the mean; before chooseTargets().
    void look(const AssignmentStep& context, const AssignmentNodes& seats, std::span<const double> price,
              std::span<const float> own);
    /// Chooses anew where the arcs of a seat lead.
    void chooseTargets(const AssignmentStep& context, const AssignmentNodes& seats, std::int32_t seat);
    /// Arcs that are worth a look: those whose reduced cost is below a margin per seat. All where there are
    /// no prices.
    struct Tight {
        std::span<const double> price;
        std::span<const double> margin;
    };
    /// Asks for the weights of these seats' arcs; `ownPower` is the cost of each seat's holder to the power.
    void refresh(const AssignmentStep& context, const AssignmentNodes& seats,
                 std::span<const double> ownPower, std::span<const std::int32_t> rows, const Tight& tight);
    /// Asks for the weights of these arcs.
    void refreshArcs(const AssignmentStep& context, const AssignmentNodes& seats,
                     std::span<const double> ownPower, std::span<const std::int32_t> arcs);
    /// Sorts the arcs by the seats they lead to.
    void sortByTarget();
    /// Makes room for what was read, and sorts it.
    void afterReading();

    std::int32_t target(std::int32_t arc) const { return target_[arc]; }       ///< Seat.
    float weight(std::int32_t arc) const { return weight_[arc]; }              ///< See above.
    void setWeight(std::int32_t arc, float weight) { weight_[arc] = weight; }  ///< By hand.
    /// The arc in a seat's priced lane; it leads to the seat itself where there is none.
    std::int32_t priced(std::int32_t seat) const { return seat * kLanes + kPricedLane; }
    /// Lets that arc lead to a seat.
    void putPriced(std::int32_t seat, std::int32_t to, float weight) {
        target_[priced(seat)] = to;
        weight_[priced(seat)] = weight;
    }
    /// Seats far dearer than the mean at the last look(), ascending.
    const std::vector<std::int32_t>& hot() const { return hot_; }
    /// The weight an arc between two seats has where the holder of the first pays `there` at its end.
    float weightFor(const AssignmentStep& context, const AssignmentNodes& seats,
                    std::span<const double> ownPower, std::int32_t from, std::int32_t to, double there) const;
    /// The weight an arc has where its holder pays `there` at its end [in the units of the power].
    float weightBy(const AssignmentStep& context, const AssignmentNodes& seats,
                   std::span<const double> ownPower, std::int32_t arc, double there) const;
    /// The arc from one seat to another, -1 for none.
    std::int32_t find(std::int32_t from, std::int32_t to) const;
    /// Arcs that led to the seat at the last sortByTarget(), ascending.
    std::span<const std::int32_t> into(std::int32_t seat) const {
        const auto begin = static_cast<std::size_t>(start_[seat]);
        return {into_.data() + begin,
                static_cast<std::size_t>(start_[static_cast<std::size_t>(seat) + 1]) - begin};
    }
    const std::vector<std::int32_t>& targets() const { return target_; }  ///< Per arc.
    const std::vector<float>& weights() const { return weight_; }         ///< Per arc.

    /// Lets an archive read or write the arcs.
    template <class Archive>
    void visit(Archive& archive) {
        archive(target_, weight_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    bool consistent() const;
    void makeRoom();
    void add(std::int32_t seat, std::int32_t& lane, std::int32_t end, std::int32_t to);
    void leadHome(std::int32_t seat, std::int32_t& lane, std::int32_t end);
    void addHot(const AssignmentStep& context, const AssignmentNodes& seats, std::int32_t seat,
                std::int32_t& lane);
    bool pays(const AssignmentNodes& seats, std::int32_t arc) const;
    void clearQuestions();
    void note(const AssignmentNodes& seats, std::int32_t arc);
    void ask(const AssignmentNodes& seats, std::int32_t seat, const Tight& tight);
    void askFor(const AssignmentStep& context, const AssignmentNodes& seats,
                std::span<const double> ownPower);
    void answer(const AssignmentStep& context, const AssignmentNodes& seats,
                std::span<const double> ownPower);

    std::vector<std::int32_t> target_;
    std::vector<float> weight_;
    // Rebuilt in each step.
    std::vector<std::int32_t> start_;
    std::vector<std::int32_t> into_;
    std::vector<std::int32_t> asked_;    // Arcs whose weights are to be made anew...
    std::vector<AssignmentPair> pairs_;  // ... the pairs whose costs these take, in their order...
    std::vector<float> answers_;         // ... and these.
    CellList nearPlaces_;
    CellList nearCharacters_;
    std::vector<std::int32_t> hot_;  // Seats far dearer than the mean.
    float hotCost_ = 0.0f;           // [m]
    std::span<const float> own_;     // [m], per seat, as told to look().
    // The matched seat, and the seat to wait in with somebody on it, of the highest price.
    std::int32_t highest_ = -1;
    std::int32_t highestWaiting_ = -1;
};

}  // namespace muster
