#include "engine/orders/stream_runs.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kLeastProbe = 0.2;        // Length below which a blocked stretch of a row may be missed [m].
constexpr double kRunEndTolerance = 1e-3;  // Accuracy of the ends of runs [m].
constexpr double kSkin = 0.03;             // Distance that runs keep from walls, where they have room [m].

}  // namespace

void StreamRuns::start(const StreamLine& line, std::span<const double> half, double radius) {
    rowCount_ = line.rows();
    next_ = 0;
    radius_ = radius;
    half_.assign(half.begin(), half.end());
    parts_.clear();
    partOf_.assign(1, 0);
    runs_.clear();
    first_.assign(1, 0);
}

std::int32_t StreamRuns::probe(const StreamLine& line, StreamGround ground) {
    const std::int32_t k = next_ / 2;
    const bool between = next_ % 2 == 1;
    const double half = between ? std::max(half_[k], half_[k + 1]) : half_[k];
    const std::int32_t asked = trace(line.at(0.5 * next_ * line.step()), half, ground);
    partOf_.push_back(static_cast<std::int32_t>(parts_.size()));
    ++next_;
    // A row is known as soon as its neighbours behind and ahead are.
    if (!between && k > 0) joinRow(k - 1);
    if (k == rowCount_ - 1) joinRow(k);
    return asked;
}

double StreamRuns::edge(const StreamRow& row, double free, double blocked, StreamGround ground,
                        std::int32_t& asked) const {
    while (std::fabs(blocked - free) > kRunEndTolerance) {
        const double middle = 0.5 * (free + blocked);
        ++asked;
        (ground(row.centre + row.across * middle) >= radius_ ? free : blocked) = middle;
    }
    return free;
}

void StreamRuns::keep(double low, double high, bool wallLow, bool wallHigh) {
    const double skin = std::min(kSkin, 0.4 * (high - low));
    parts_.push_back({wallLow ? low + skin : low, wallHigh ? high - skin : high});
}

std::int32_t StreamRuns::trace(const StreamRow& row, double half, StreamGround ground) {
    const double fold = (1.0 - kLeastBend) / std::max(std::fabs(row.bend), 1e-9);
    const double first = row.bend < 0.0 ? std::max(-half, -fold) : -half;
    const double last = row.bend > 0.0 ? std::min(half, fold) : half;
    const auto room = [&](double d) { return ground(row.centre + row.across * d) - radius_; };
    std::int32_t asked = 1;
    double d = first, gap = room(d), begin = d;
    bool wall = false;
    while (d < last) {
        const double next = std::min(last, d + std::max(std::fabs(gap), kLeastProbe));
        const double there = room(next);
        ++asked;
        if ((there >= 0.0) != (gap >= 0.0)) {
            if (gap >= 0.0) {
                keep(begin, edge(row, d, next, ground, asked), wall, true);
            } else {
                begin = edge(row, next, d, ground, asked);
                wall = true;
            }
        }
        d = next;
        gap = there;
    }
    if (gap >= 0.0) keep(begin, last, wall, false);
    return asked;
}

// Cuts a run by the ground of a whole row behind (side 0) or ahead (side 4). False where nothing is left.
bool StreamRuns::joinFar(const StreamRun& run, std::int32_t side, std::int32_t half) {
    bool any = false;
    for (std::int32_t a = partOf_[half]; a < partOf_[half + 1]; ++a) {
        StreamRun piece = run;
        piece.low = std::max(run.low, parts_[a].low);
        piece.high = std::min(run.high, parts_[a].high);
        piece.part[side] = a;
        if (piece.low > piece.high) continue;
        split_.push_back(piece);
        any = true;
    }
    return any;
}

// Finds the runs of row k: ground that is free in it and half a row and a row behind and ahead.
void StreamRuns::joinRow(std::int32_t k) {
    const std::int32_t m = 2 * k, last = 2 * (rowCount_ - 1);
    const std::int32_t behind = std::max(m - 1, 0), ahead = std::min(m + 1, last);
    found_.clear();
    for (std::int32_t a = partOf_[behind]; a < partOf_[behind + 1]; ++a)
        for (std::int32_t b = partOf_[m]; b < partOf_[m + 1]; ++b)
            for (std::int32_t c = partOf_[ahead]; c < partOf_[ahead + 1]; ++c) {
                const double low = std::max({parts_[a].low, parts_[b].low, parts_[c].low});
                const double high = std::min({parts_[a].high, parts_[b].high, parts_[c].high});
                if (low <= high) found_.push_back({low, high, {-1, a, b, c, -1}});
            }
    for (const std::int32_t side : {0, 4}) {
        const std::int32_t half = m + side - 2;
        if (half < 0 || half > last) continue;
        split_.clear();
        for (const StreamRun& run : found_)
            if (!joinFar(run, side, half)) split_.push_back(run);
        found_.swap(split_);
    }
    runs_.insert(runs_.end(), found_.begin(), found_.end());
    first_.push_back(static_cast<std::int32_t>(runs_.size()));
}

}  // namespace muster
