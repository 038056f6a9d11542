// Division of a stream round islands: a potential flow over the runs of its rows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_runs.h"

namespace muster {

/// The ordinates of the formation that pass through a run.
struct StreamShare {
    double low = 0.0;   ///< Least ordinate [m].
    double high = 0.0;  ///< Greatest ordinate [m].
    bool
        /// True if they follow from the flow, as ordinates of the formation; else they are the nearest ones.
        flows = false;
    /// The distance of `y` outside the share [m], 0 inside.
    double outside(double y) const { return y < low ? low - y : (y > high ? y - high : 0.0); }
};

/// Solves for the flux through each run. Wide runs are cut into pieces, so that neighbouring parts of the
/// flow do not mix at once. Owns its memory and reuses it.
class StreamFlow {
public:
    /// Begins: the flow comes in at row `from` between `low` and `high` [m] and goes out at row `to`. Both
    /// are also the ordinates of the formation.
    void start(const StreamRuns& runs, double step, std::int32_t from, std::int32_t to, double low,
               double high, double spacing);
    /// Goes on by some operations; returns their number.
    std::int32_t advance(const StreamRuns& runs);
    /// True once the shares are known.
    bool done() const { return stage_ == Stage::Done; }
    /// The share of each run, by its number.
    std::span<const StreamShare> shares() const { return shares_; }

private:
    enum class Stage : std::uint8_t { Pieces, Joints, Factor, Back, Shares, Done };
    struct Piece {
        double low, high;
        std::int32_t run;
    };

    void cut(const StreamRuns& runs, std::int32_t k);
    std::int32_t joinRow(const StreamRuns& runs, std::int32_t k);
    bool joined(const StreamRuns& runs, std::int32_t k, std::int32_t a, std::int32_t b) const;
    double conductance(std::int32_t a, std::int32_t b) const;
    void add(std::int32_t a, std::int32_t b, double conductance);
    std::int32_t factor(std::int32_t i);
    std::int32_t substitute(std::int32_t i);
    std::int32_t share(const StreamRuns& runs, std::int32_t k);
    void shareByPlace(const StreamRuns& runs, std::int32_t k);
    double& entry(std::int32_t i, std::int32_t j) {
        return band_[static_cast<std::size_t>(i) * (width_ + 1) + (j - i + width_)];
    }

    Stage stage_ = Stage::Done;
    std::int32_t from_ = 0, to_ = 0, next_ = 0, width_ = 0;
    double step_ = 0.5, low_ = 0.0, high_ = 0.0, spacing_ = 1.0, cut_ = 1.0;
    std::vector<Piece> pieces_;
    std::vector<std::int32_t> firstPiece_;  // First pieces of the rows from `from_` to `to_`.
    std::vector<double> band_, level_;      // Lower half of the matrix; right side, then potential.
    std::vector<double> flux_;              // Flux through the runs of a row.
    std::vector<StreamShare> shares_;
};

}  // namespace muster
