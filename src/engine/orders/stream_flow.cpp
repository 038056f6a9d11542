#include "engine/orders/stream_flow.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kLeastPieceWidth = 4.0;  // Least width of the pieces into which runs are cut [m].
constexpr double kMostPieces = 6.0;  // Greatest number of pieces of a row that is as wide as the formation.
// Conductance from dead ends to nowhere, so that all potentials exist.
constexpr double kLeakConductance = 1e-9;
constexpr double kBeyondAll = 1e9;   // An ordinate beyond all others [m].
constexpr double kLeastFlux = 1e-6;  // Flux below which a row carries nothing.

}  // namespace

void StreamFlow::start(const StreamRuns& runs, double step, std::int32_t from, std::int32_t to, double low,
                       double high, double spacing) {
    stage_ = Stage::Pieces;
    from_ = next_ = from;
    to_ = to;
    step_ = step;
    low_ = low;
    high_ = high;
    spacing_ = spacing;
    cut_ = std::max(kLeastPieceWidth, (high - low + spacing) / kMostPieces);
    width_ = 1;
    pieces_.clear();
    firstPiece_.assign(1, 0);
    shares_.resize(runs.count());
    // Where no row has an island there is nothing to solve.
    bool parts = false;
    for (std::int32_t k = from; k <= to; ++k) parts = parts || runs.row(k).size() > 1;
    if (!parts) {
        stage_ = Stage::Shares;
        next_ = 0;
    }
}

std::int32_t StreamFlow::advance(const StreamRuns& runs) {
    const std::int32_t pieces = static_cast<std::int32_t>(pieces_.size());
    std::int32_t work = 1;
    if (stage_ == Stage::Pieces) {
        cut(runs, next_++);
        if (next_ > to_) {
            stage_ = Stage::Joints;
            next_ = from_;
            band_.assign(pieces_.size() * (width_ + 1), 0.0);
            level_.assign(pieces_.size(), 0.0);
        }
    } else if (stage_ == Stage::Joints) {
        work = joinRow(runs, next_++);
        if (next_ > to_) {
            stage_ = Stage::Factor;
            next_ = 0;
        }
    } else if (stage_ == Stage::Factor) {
        work = factor(next_++);
        if (next_ >= pieces) {
            stage_ = Stage::Back;
            next_ = pieces - 1;
        }
    } else if (stage_ == Stage::Back) {
        work = substitute(next_--);
        if (next_ < 0) {
            stage_ = Stage::Shares;
            next_ = 0;
        }
    } else if (stage_ == Stage::Shares) {
        work = share(runs, next_++);
        if (next_ >= runs.rows()) stage_ = Stage::Done;
    }
    return work;
}

void StreamFlow::cut(const StreamRuns& runs, std::int32_t k) {
    const std::int32_t first = runs.first(k);
    std::int32_t number = first;
    for (const StreamRun& run : runs.row(k)) {
        // Cuts lie at multiples of the width, so that the pieces of rows face each other.
        double low = run.low;
        while (low < run.high || low == run.low) {
            double high = std::min(run.high, (std::floor(low / cut_ + 1e-9) + 1.0) * cut_);
            if (run.high - high < 0.25 * cut_) high = run.high;
            pieces_.push_back({low, high, number});
            if (high >= run.high) break;
            low = high;
        }
        ++number;
    }
    const auto row = static_cast<std::size_t>(k - from_);
    firstPiece_.push_back(static_cast<std::int32_t>(pieces_.size()));
    const std::int32_t before = row > 0 ? firstPiece_[row - 1] : 0;
    width_ = std::max(width_, static_cast<std::int32_t>(pieces_.size()) - before);
}

// Conductance between pieces of adjacent rows; 0 where they do not meet.
double StreamFlow::conductance(std::int32_t a, std::int32_t b) const {
    const Piece &p = pieces_[a], &q = pieces_[b];
    const double overlap = std::min(p.high, q.high) - std::max(p.low, q.low);
    return overlap > 0.0 ? (overlap + 0.1 * spacing_) / step_ : 0.0;
}

bool StreamFlow::joined(const StreamRuns& runs, std::int32_t k, std::int32_t a, std::int32_t b) const {
    return StreamRuns::join(runs.row(k)[pieces_[a].run - runs.first(k)],
                            runs.row(k + 1)[pieces_[b].run - runs.first(k + 1)]);
}

void StreamFlow::add(std::int32_t a, std::int32_t b, double conductance) {
    entry(a, a) += conductance;
    entry(b, b) += conductance;
    entry(std::max(a, b), std::min(a, b)) -= conductance;
}

std::int32_t StreamFlow::joinRow(const StreamRuns& runs, std::int32_t k) {
    const std::int32_t row = k - from_, first = firstPiece_[row], last = firstPiece_[row + 1];
    std::int32_t work = 1;
    for (std::int32_t a = first; a < last; ++a, ++work) {
        entry(a, a) += kLeakConductance;
        if (a + 1 < last && pieces_[a].run == pieces_[a + 1].run)
            add(a, a + 1, 2.0 * step_ / (pieces_[a + 1].high - pieces_[a].low + 0.1));
        const double inside = std::min(pieces_[a].high, high_) - std::max(pieces_[a].low, low_) + spacing_;
        if ((k == from_ || k == to_) && inside > 0.0) {
            entry(a, a) += 4.0 * inside;
            if (k == from_) level_[a] = 4.0 * inside;
        }
        if (k == to_) continue;
        const std::int32_t end = firstPiece_[row + 2];
        for (std::int32_t b = last; b < end; ++b, ++work) {
            const double g = joined(runs, k, a, b) ? conductance(a, b) : 0.0;
            if (g > 0.0) add(a, b, g);
        }
    }
    return work;
}

// Factors one row of a square-root-free Cholesky decomposition in a band, with the forward substitution.
std::int32_t StreamFlow::factor(std::int32_t i) {
    const std::int32_t begin = std::max(0, i - width_);
    double diagonal = entry(i, i), right = level_[i];
    std::int32_t work = 1;
    for (std::int32_t j = begin; j < i; ++j) {
        double value = entry(i, j);
        const std::int32_t from = std::max(begin, j - width_);
        const double *mine = &entry(i, from), *theirs = &entry(j, from);
        for (std::int32_t m = 0; m < j - from; ++m) value -= mine[m] * theirs[m];
        entry(i, j) = value;
        work += (j - from) / 8 + 1;
    }
    for (std::int32_t j = begin; j < i; ++j) {
        const double scaled = entry(i, j) / entry(j, j);
        diagonal -= scaled * entry(i, j);
        right -= scaled * level_[j];
        entry(i, j) = scaled;
    }
    entry(i, i) = diagonal;
    level_[i] = right;
    return work;
}

std::int32_t StreamFlow::substitute(std::int32_t i) {
    const auto pieces = static_cast<std::int32_t>(pieces_.size());
    double value = level_[i] / entry(i, i);
    for (std::int32_t j = i + 1; j < pieces && j <= i + width_; ++j) value -= entry(j, i) * level_[j];
    level_[i] = value;
    return 1 + width_ / 8;
}

// Gives a run without flow the ordinates that lie nearest to it.
void StreamFlow::shareByPlace(const StreamRuns& runs, std::int32_t k) {
    const std::span<const StreamRun> row = runs.row(k);
    for (std::size_t r = 0; r < row.size(); ++r) {
        StreamShare& share = shares_[runs.first(k) + r];
        share.flows = false;
        share.low = r == 0 ? -kBeyondAll : 0.5 * (row[r - 1].high + row[r].low);
        share.high = r + 1 == row.size() ? kBeyondAll : 0.5 * (row[r].high + row[r + 1].low);
    }
}

std::int32_t StreamFlow::share(const StreamRuns& runs, std::int32_t k) {
    const std::span<const StreamRun> row = runs.row(k);
    if (k < from_ || k >= to_ || row.size() < 2) {
        shareByPlace(runs, k);
        return 1;
    }
    const std::int32_t first = firstPiece_[k - from_], last = firstPiece_[k - from_ + 1],
                       end = firstPiece_[k - from_ + 2];
    flux_.assign(row.size(), 0.0);
    for (std::int32_t a = first; a < last; ++a)
        for (std::int32_t b = last; b < end; ++b)
            if (joined(runs, k, a, b))
                flux_[pieces_[a].run - runs.first(k)] += conductance(a, b) * (level_[a] - level_[b]);
    double whole = 0.0, sum = 0.0;
    for (double& flux : flux_) whole += flux = std::max(0.0, flux);
    if (whole < kLeastFlux) whole = 1.0;
    const double width = high_ - low_ + spacing_;
    for (std::size_t r = 0; r < row.size(); ++r) {
        StreamShare& share = shares_[runs.first(k) + r];
        share.flows = true;
        share.low = r == 0 ? -kBeyondAll : low_ - 0.5 * spacing_ + sum / whole * width;
        sum += flux_[r];
        share.high = r + 1 == row.size() ? kBeyondAll : low_ - 0.5 * spacing_ + sum / whole * width;
    }
    return 1 + (last - first) * (end - last);
}

}  // namespace muster
