// Plans that divide the crowd, or sweep by wide fronts.
#include "lab/study/models/planner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace muster {
namespace {

constexpr double kCutBeyond = 1.2;    // Length of a cut beyond the crowd at both ends [m].
constexpr double kLaterFactor = 1.4;  // Factor of a later sweep's time, since it is decided later.
// Greatest spacing at which a front collects all items before it, in spacings.
constexpr double kLoosestSpacing = 1.25;
constexpr double kLaneMargin = 1.0;           // Length by which a lane goes on behind its last item [m].
constexpr std::size_t kMostLeftForLater = 3;  // Number of items that may be left for later.

double median(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    const std::size_t i = std::clamp<std::size_t>(at, 1, values.size() - 1);
    return 0.5 * (values[i - 1] + values[i]);
}

}  // namespace

// Divides the crowd by lines into cells of about as many people; no parts where a cell is empty.
OperatorPlan Planner::cells(const SeenPart& crowd, std::int32_t columns, std::int32_t rows) const {
    OperatorPlan plan;
    std::vector<double> xs, ys;
    for (const Vec2 p : crowd.positions) {
        xs.push_back(p.x);
        ys.push_back(p.y);
    }
    std::vector<double> xCuts, yCuts;
    const Box around = crowd.bounds.grown(kCutBeyond);
    for (std::int32_t i = 1; i < columns; ++i) {
        xCuts.push_back(median(xs, static_cast<double>(i) / columns));
        plan.cuts.push_back({Vec2{xCuts.back(), around.min.y}, Vec2{xCuts.back(), around.max.y}});
    }
    for (std::int32_t i = 1; i < rows; ++i) {
        yCuts.push_back(median(ys, static_cast<double>(i) / rows));
        plan.cuts.push_back({Vec2{around.min.x, yCuts.back()}, Vec2{around.max.x, yCuts.back()}});
    }
    const std::int32_t count = columns * rows;
    std::vector<std::vector<std::uint32_t>> ids(count);
    std::vector<std::vector<Vec2>> positions(count);
    for (std::size_t i = 0; i < crowd.ids.size(); ++i) {
        const Vec2 p = crowd.positions[i];
        const auto column = std::count_if(xCuts.begin(), xCuts.end(), [&](double x) { return p.x > x; });
        const auto row = std::count_if(yCuts.begin(), yCuts.end(), [&](double y) { return p.y > y; });
        ids[row * columns + column].push_back(crowd.ids[i]);
        positions[row * columns + column].push_back(p);
    }
    for (std::int32_t i = 0; i < count; ++i) {
        if (ids[i].empty()) return {{}, {}, kInfinite, {}};
        plan.parts.push_back({seenPart(ids[i], positions[i]), {}, {}, 0.0, false, {}, 0.0, false, 0.0});
    }
    return plan;
}

// Cuts a tour into at most so many stretches. A stretch ends where the walked length exceeds the part's
// share, counted with the way there.
std::vector<std::vector<std::int32_t>> Planner::stretchesOf(Vec2 from, std::span<const std::int32_t> tour,
                                                            std::int32_t count) const {
    std::vector<std::vector<std::int32_t>> stretches;
    double low = 0.0;
    double high = tours_->length(from, tour) + 1.0;
    for (std::int32_t round = 0; round < 24; ++round) {
        const double most = 0.5 * (low + high);
        std::vector<std::vector<std::int32_t>> found(1);
        double walked = 0.0;
        for (const std::int32_t item : tour) {
            const double there = tours_->ground().distance(from, tours_->items()[item]);
            const double more = found.back().empty() ? there : tours_->between(found.back().back(), item);
            if (!found.back().empty() && walked + more > most) {
                found.emplace_back();
                walked = there;
            } else {
                walked += more;
            }
            found.back().push_back(item);
        }
        if (std::ssize(found) <= count) {
            high = most;
            stretches = std::move(found);
        } else {
            low = most;
        }
    }
    return stretches;
}

// Divides the crowd into cells, and the tour into as many stretches.
OperatorPlan Planner::divided(const SeenPart& crowd, std::span<const std::int32_t> tour, std::int32_t columns,
                              std::int32_t rows, Chance& chance) const {
    OperatorPlan plan = cells(crowd, columns, rows);
    if (plan.parts.empty()) return plan;
    const std::int32_t count = columns * rows;
    char text[64];
    std::snprintf(text, sizeof(text), "%d x %d parts", columns, rows);
    plan.text = text;
    std::vector<std::vector<std::int32_t>> stretches = stretchesOf(crowd.centre, tour, count);
    stretches.resize(count);
    // Each stretch goes to the part that is nearest to one of its ends; long ones choose first.
    std::vector<std::uint8_t> taken(count, 0);
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return stretches[a].size() > stretches[b].size();
    });
    for (const std::int32_t s : order) {
        std::vector<std::int32_t>& stretch = stretches[s];
        std::int32_t best = -1;
        double least = kInfinite;
        for (std::int32_t p = 0; p < count; ++p) {
            if (taken[p] != 0) continue;
            const Vec2 centre = plan.parts[p].part.centre;
            const auto near = [&](std::int32_t item) { return distance(centre, tours_->items()[item]); };
            const double away = stretch.empty() ? 0.0 : std::min(near(stretch.front()), near(stretch.back()));
            if (away >= least) continue;
            least = away;
            best = p;
        }
        taken[best] = 1;
        if (stretch.empty()) continue;
        lead(plan.parts[best], tours_->tour(plan.parts[best].part.centre, stretch, 0.0, chance));
    }
    // Parts that have farthest to go are sent first.
    std::stable_sort(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& a, const PlannedPart& b) {
        return walkSeconds(a) > walkSeconds(b);
    });
    plan.seconds = estimate(plan);
    return plan;
}

// A plan of lanes side by side, as wide as the front, from the end that is nearer.
OperatorPlan Planner::swept(const SeenPart& crowd, std::span<const std::int32_t> open, Vec2 along,
                            double width) const {
    OperatorPlan plan;
    char text[64];
    std::snprintf(text, sizeof(text), "sweep %.0f m wide", width);
    plan.text = text;
    const Vec2 across = perpendicular(along);
    double low = kInfinite;
    double high = -kInfinite;
    for (const std::int32_t i : open) {
        low = std::min(low, dot(tours_->items()[i], across));
        high = std::max(high, dot(tours_->items()[i], across));
    }
    const double reach = width + 2.0 * 0.8 * def_.itemRadius;
    const auto lanes = static_cast<std::int32_t>(std::max(1.0, std::ceil((high - low) / reach)));
    PlannedPart planned{crowd, {}, {}, width, false, along, 0.0, false, 0.0};
    const double start = dot(crowd.centre, across);
    const bool upwards = std::abs(start - low) <= std::abs(start - high);
    const double lane = (high - low) / lanes;
    bool forward = true;
    Vec2 at = crowd.centre;
    for (std::int32_t k = 0; k < lanes; ++k) {
        const std::int32_t number = upwards ? k : lanes - 1 - k;
        const double middle = low + (number + 0.5) * lane;
        double first = kInfinite;
        double last = -kInfinite;
        for (const std::int32_t i : open) {
            const Vec2 p = tours_->items()[i];
            if (std::abs(dot(p, across) - middle) > 0.5 * lane + 1e-9) continue;
            first = std::min(first, dot(p, along));
            last = std::max(last, dot(p, along));
        }
        if (first > last) continue;
        if (k == 0) forward = true;
        const double from = forward ? first - kLaneMargin : last + kLaneMargin;
        const double to = forward ? last + kLaneMargin : first - kLaneMargin;
        const double begin = k == 0 && forward ? std::min(from, dot(crowd.centre, along)) : from;
        for (const double s : {begin, to}) {
            const Vec2 p = def_.border.clamp(along * s + across * middle);
            if (distance(at, p) < 0.5) continue;
            planned.way.push_back(p);
            at = p;
        }
        forward = !forward;
    }
    plan.parts.push_back(std::move(planned));
    // Half of the front lies aside of where the part stands before the sweep can begin.
    const double own = crowd.bounds.width() * std::abs(across.x) + crowd.bounds.height() * std::abs(across.y);
    plan.parts[0].reforms = 0.5 * std::abs(width - own) / def_.speed;
    plan.seconds = estimate(plan);
    return plan;
}

// The sweep of a part that takes least time, with at most so many spacings between two; one without a way
// where there is none.
PlannedPart Planner::bestSweep(const SeenPart& part, std::span<const std::int32_t> open,
                               double loosest) const {
    PlannedPart best{part, {}, {}, 0.0, false, {}, 0.0, false, 0.0};
    double least = kInfinite;
    for (const double width : kWidths) {
        if (width > loosest * def_.spacing * static_cast<double>(part.ids.size())) continue;
        for (const Vec2 along : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
            OperatorPlan plan = swept(part, open, along, width);
            if (plan.seconds >= least || plan.parts[0].way.empty()) continue;
            least = plan.seconds;
            best = std::move(plan.parts[0]);
        }
    }
    return best;
}

// The sweep for a part that goes through the narrows on its way as it is; none where there are none.
std::optional<PlannedPart> Planner::staged(const PlannedPart& sweep,
                                           std::span<const std::int32_t> open) const {
    const Vec2 to = sweep.way.back();
    const Vec2 from = to + sweep.along * dot(sweep.part.centre - to, sweep.along);
    const double end = tours_->ground().narrowest(from, to, sweep.width).end;
    if (end <= 0.0 || dot(to - from, sweep.along) <= end) return std::nullopt;
    PlannedPart planned{sweep.part, {}, {}, 0.0, false, {}, 0.0, true, 0.0};
    const Vec2 stage = from + sweep.along * end;
    tours_->ground().appendWay(sweep.part.centre, stage, planned.way);
    std::vector<std::int32_t> beyond;
    for (const std::int32_t i : open)
        if (dot(tours_->items()[i] - stage, sweep.along) > -kLaneMargin) beyond.push_back(i);
    if (beyond.size() + kMostLeftForLater < open.size()) return std::nullopt;
    std::vector<Vec2> there = sweep.part.positions;
    for (Vec2& p : there) p += stage - sweep.part.centre;
    const PlannedPart rest = bestSweep(seenPart(sweep.part.ids, there), beyond, kLoosestSpacing);
    if (rest.way.empty()) return std::nullopt;
    planned.later = motor_->factor() * def_.parameters.decide + kLaterFactor * partSeconds(rest) +
                    callSeconds() * static_cast<double>(open.size() - beyond.size());
    return planned;
}

// Two parts, each of which sweeps up what lies on its side of a line.
OperatorPlan Planner::parted(const SeenPart& crowd, std::span<const std::int32_t> open, std::int32_t columns,
                             double share) const {
    OperatorPlan plan = cells(crowd, columns, 3 - columns);
    if (plan.parts.size() != 2) return plan;
    const Vec2 apart = columns == 2 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0};
    std::vector<double> along;
    for (const std::int32_t i : open) along.push_back(dot(tours_->items()[i], apart));
    const double line = median(along, share);
    for (std::size_t side = 0; side < 2; ++side) {
        std::vector<std::int32_t> own;
        for (const std::int32_t i : open)
            if ((dot(tours_->items()[i], apart) > line) == (side == 1)) own.push_back(i);
        if (own.empty()) return {{}, {}, kInfinite, {}};
        PlannedPart best = bestSweep(plan.parts[side].part, own, kLoosestSpacing);
        if (best.way.empty()) return {{}, {}, kInfinite, {}};
        if (const auto other = staged(best, own); other && partSeconds(*other) < partSeconds(best))
            best = *other;
        best.stops = own;
        plan.parts[side] = std::move(best);
    }
    // Parts that have farthest to go are sent first.
    std::stable_sort(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& a, const PlannedPart& b) {
        return partSeconds(a) > partSeconds(b);
    });
    char text[64];
    std::snprintf(text, sizeof(text), "2 halves sweep %.0f and %.0f m wide", plan.parts[0].width,
                  plan.parts[1].width);
    plan.text = text;
    plan.seconds = estimate(plan);
    return plan;
}

}  // namespace muster
