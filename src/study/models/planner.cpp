#include "study/models/planner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kTargetMetres = 1.0;   // What is aimed at is as large as an item's reach [m].
constexpr double kSwathShare = 0.8;     // Of the width of a part, which one counts on.
constexpr double kPackedRadius = 0.28;  // Of those who gather, times the root of their number [m].
constexpr double kCutBeyond = 1.2;      // A cut begins and ends so far beyond the crowd [m].
constexpr double kNarrow = 0.3;         // A front folds where it finds less of its width.
constexpr double kFrontShare = 0.75;    // Of a walker's speed, which a wide front makes.
constexpr double kLaterShare = 1.4;     // What is decided later takes so many times as long as it would now.
constexpr double kThinShare = 0.6;      // The same for one of a single rank: it bends more, and misses more.
constexpr double kRanks = 1.3;          // A front is thin that has fewer.
constexpr double kLoosest = 1.25;       // A front collects all before it up to this spacing, in spacings.
constexpr double kLaneMargin = 1.0;     // A lane goes on so far behind its last item [m].
// Shapes of divisions: columns and rows.
constexpr std::array<std::array<std::int32_t, 2>, 9> kDivisions{
    {{1, 1}, {2, 1}, {1, 2}, {3, 1}, {1, 3}, {2, 2}, {4, 1}, {1, 4}, {3, 2}}};
constexpr std::array<double, 4> kWidths{8.0, 12.0, 16.0, 20.0};
constexpr double kWide = 1.4;            // A formation is wide that is so many times as wide as a square.
constexpr std::size_t kLeftOver = 3;     // So few items may be left for later.
constexpr std::size_t kFew = 4;          // So many are sent to fetch what is left.
constexpr double kTapSeconds = 0.05;     // A finger is down for a tap [s].
constexpr double kBetweenTaps = 0.15;    // Between two taps on one spot [s].
constexpr double kTakenMargin = 0.55;    // They are encircled so far off [m].
constexpr double kMostPushed = 1.0;      // So far a formation may be pushed together at the border [m].
constexpr double kPushedSeconds = 15.0;  // What more of that is expected to cost [s].

double median(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    const std::size_t i = std::clamp<std::size_t>(at, 1, values.size() - 1);
    return 0.5 * (values[i - 1] + values[i]);
}

double wayLength(Vec2 from, std::span<const Vec2> way) {
    double sum = 0.0;
    for (const Vec2 p : way) {
        sum += distance(from, p);
        from = p;
    }
    return sum;
}

}  // namespace

SeenPart seenPart(std::vector<std::uint32_t> ids, std::vector<Vec2> positions) {
    SeenPart part{std::move(ids), std::move(positions), {}, {}};
    if (part.positions.empty()) return part;
    part.bounds = {part.positions[0], part.positions[0]};
    for (const Vec2 p : part.positions) {
        part.centre += p / static_cast<double>(part.positions.size());
        part.bounds.min = {std::min(part.bounds.min.x, p.x), std::min(part.bounds.min.y, p.y)};
        part.bounds.max = {std::max(part.bounds.max.x, p.x), std::max(part.bounds.max.y, p.y)};
    }
    return part;
}

double toleranceOf(const SeenPart& part) {
    return std::max(kTargetMetres, kSwathShare * std::min(part.bounds.width(), part.bounds.height()));
}

Planner::Planner(const PlannerDef& def, const TourFinder& tours, const Motor& motor)
    : def_(def), tours_(&tours), motor_(&motor) {}

Sweep Planner::sweepOf(const SeenPart& part) const {
    Sweep sweep;
    sweep.reach = def_.itemRadius;
    const std::size_t n = part.positions.size();
    if (def_.repertoire.keepsShape) {
        for (const Vec2 p : part.positions) sweep.offsets.push_back(p - part.centre);
    } else {
        // A packed disc, by the sunflower's angle.
        for (std::size_t i = 0; i < n; ++i) {
            const double r = kPackedRadius * std::sqrt(static_cast<double>(i) + 0.5);
            const double angle = 2.399963229728653 * static_cast<double>(i);
            sweep.offsets.push_back({r * cosine(angle), r * sine(angle)});
        }
    }
    for (const Vec2 offset : sweep.offsets)
        if (lengthSquared(offset) < lengthSquared(sweep.aim) || sweep.aim == Vec2{}) sweep.aim = offset;
    return sweep;
}

// Where the middle of a part goes so that one of its characters stands on an item: where it ends, those whose
// mesh is drawn bring whoever is nearest.
Vec2 Planner::aimedAt(Vec2 from, Vec2 item, const Sweep& sweep) const {
    Vec2 best = def_.border.clamp(item - sweep.aim);
    double least = distance(from, best);
    for (const Vec2 offset : sweep.offsets) {
        const Vec2 to = def_.border.clamp(item - offset);
        if (distance(from, to) >= least || distance(to + offset, item) > 0.5 * sweep.reach) continue;
        least = distance(from, to);
        best = to;
    }
    return best;
}

// The way over these stops.
std::vector<Vec2> Planner::wayOver(Vec2 from, std::span<const std::int32_t> stops, const Sweep& sweep) const {
    std::vector<Vec2> way;
    for (const std::int32_t stop : stops) {
        const Vec2 item = tours_->items()[stop];
        const bool ends = def_.repertoire.draws && &stop == &stops.back();
        const Vec2 to = ends ? aimedAt(from, item, sweep) : def_.border.clamp(item - sweep.aim);
        if (def_.repertoire.draws)
            tours_->ground().appendWay(from, to, way);
        else
            way.push_back(to);
        from = to;
    }
    return way;
}

// Leads a part over items in this order, but for those that it sweeps up beside its way.
void Planner::lead(PlannedPart& planned, std::span<const std::int32_t> order) const {
    const Sweep sweep = sweepOf(planned.part);
    const Vec2 centre = planned.part.centre;
    planned.stops = tours_->thinned(centre, order, sweep);
    planned.way = wayOver(centre, planned.stops, sweep);
    if (!def_.repertoire.draws) return;
    // The way is another one than that of the middle: what it misses is led to as well, and what lies beside
    // it is not.
    const auto missed = [&](std::int32_t item) { return !collectedOn(planned, sweep, item); };
    planned.stops.assign(order.begin(), order.end());
    planned.way = wayOver(centre, planned.stops, sweep);
    for (std::size_t i = 0; i < planned.stops.size();) {
        const std::vector<std::int32_t> kept = planned.stops;
        planned.stops.erase(planned.stops.begin() + static_cast<std::ptrdiff_t>(i));
        planned.way = wayOver(centre, planned.stops, sweep);
        if (std::none_of(order.begin(), order.end(), missed)) continue;
        planned.stops = kept;
        planned.way = wayOver(centre, planned.stops, sweep);
        ++i;
    }
}

bool Planner::collectedOn(const PlannedPart& planned, const Sweep& sweep, std::int32_t item) const {
    Vec2 at = planned.part.centre;
    for (const Vec2 to : planned.way) {
        if (sweep.collects(at, to, tours_->items()[item])) return true;
        at = to;
    }
    return false;
}

double Planner::cutSeconds() const {
    const double mm = def_.mmPerMetre;
    return motor_->point(6.0 * mm, kTargetMetres * mm) + motor_->drag(8.0 * mm, kTargetMetres * mm) +
           motor_->device().handOff + motor_->factor() * def_.parameters.decideNext + 2.0 * motor_->press();
}

double Planner::selectSeconds(const PlannedPart& planned) const {
    const double mm = def_.mmPerMetre;
    const double size = distance(planned.part.bounds.min, planned.part.bounds.max);
    double seconds = motor_->point(8.0 * mm, kTargetMetres * mm) +
                     motor_->drag(size * mm, kTargetMetres * mm);
    seconds += 2.0 * motor_->press();
    return seconds + motor_->factor() * def_.parameters.attention;
}

double Planner::clickSeconds(const PlannedPart& planned, double metres) const {
    const double mm = def_.mmPerMetre;
    return motor_->point(metres * mm, toleranceOf(planned.part) * mm) + 2.0 * motor_->press() +
           motor_->factor() * def_.parameters.decideNext;
}

double Planner::sendSeconds(const PlannedPart& planned) const {
    const double mm = def_.mmPerMetre;
    const double next = motor_->factor() * def_.parameters.decideNext;
    if (!def_.repertoire.draws) {
        double seconds = selectSeconds(planned);
        Vec2 at = planned.part.centre;
        for (const Vec2 p : planned.way) {
            seconds += clickSeconds(planned, distance(at, p));
            at = p;
        }
        return seconds;
    }
    const double across = std::min(planned.part.bounds.width(), planned.part.bounds.height()) + 1.0;
    const double wide = std::max(across, kTargetMetres) * mm;
    double seconds = motor_->point(8.0 * mm, wide) + motor_->factor() * def_.parameters.attention;
    const double stops = std::max<double>(1.0, static_cast<double>(planned.stops.size()));
    seconds += motor_->draw(wayLength(planned.part.centre, planned.way) * mm,
                            toleranceOf(planned.part) * mm) +
               next * stops;
    if (planned.width > 0.0)
        seconds += motor_->factor() * def_.parameters.secondHand +
                   motor_->drag(0.5 * planned.width * mm, kTargetMetres * mm);
    return seconds + 2.0 * motor_->press();
}

double Planner::walkSeconds(const PlannedPart& planned) const {
    if (planned.width > 0.0) return sweepSeconds(planned);
    Vec2 at = planned.part.centre;
    double metres = 0.0;
    for (const Vec2 p : planned.way) {
        metres += def_.repertoire.draws ? distance(at, p) : tours_->ground().distance(at, p);
        at = p;
    }
    return metres / def_.speed;
}

// A wide front is as slow as those of it who have to go round most.
double Planner::sweepSeconds(const PlannedPart& planned) const {
    const Vec2 across = perpendicular(planned.along);
    double most = 0.0;
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const Vec2 side = across * (0.5 * share * planned.width);
        Vec2 at = def_.border.clamp(planned.part.centre + side);
        double metres = 0.0;
        for (const Vec2 p : planned.way) {
            const Vec2 to = def_.border.clamp(p + side);
            metres += tours_->ground().distance(at, to);
            at = to;
        }
        most = std::max(most, metres);
    }
    const bool thin = kRanks * planned.width > def_.spacing * static_cast<double>(planned.part.ids.size());
    return most / ((thin ? kThinShare : kFrontShare) * def_.speed) + foldSeconds(planned);
}

// A front folds where it finds little of its width, and unfolds behind.
double Planner::foldSeconds(const PlannedPart& planned) const {
    double most = 0.0;
    Vec2 at = planned.part.centre;
    for (const Vec2 to : planned.way) {
        const double left = tours_->ground().narrowest(at, to, planned.width).least;
        if (left < kNarrow * planned.width) most = std::max(most, planned.width - left);
        at = to;
    }
    return most / def_.speed;
}

// Parts that go on by themselves once they are sent.
double Planner::estimateQueued(const OperatorPlan& plan) const {
    double now = cutSeconds() * static_cast<double>(plan.cuts.size());
    if (!def_.repertoire.draws) now = 0.0;
    double last = 0.0;
    for (const PlannedPart& planned : plan.parts) {
        if (planned.way.empty()) continue;
        const double send = sendSeconds(planned);
        const double first = def_.repertoire.draws ? 0.3 * send
                                                   : selectSeconds(planned) + clickSeconds(planned, 5.0);
        last = std::max(
            {last, now + first + planned.reforms + walkSeconds(planned) + planned.later, now + send});
        now += send;
    }
    return last;
}

// Parts that wait for their next point until the operator comes back to them.
double Planner::estimateAttended(const OperatorPlan& plan) const {
    const std::size_t n = plan.parts.size();
    std::vector<double> due(n, 0.0);
    std::vector<std::size_t> next(n, 0);
    double now = 0.0;
    double last = 0.0;
    std::size_t before = n;
    for (;;) {
        std::size_t chosen = n;
        for (std::size_t i = 0; i < n; ++i)
            if (next[i] < plan.parts[i].way.size() && (chosen == n || due[i] < due[chosen])) chosen = i;
        if (chosen == n) return last;
        const PlannedPart& planned = plan.parts[chosen];
        const Vec2 from = next[chosen] == 0 ? planned.part.centre : planned.way[next[chosen] - 1];
        const Vec2 to = planned.way[next[chosen]];
        now = std::max(now, due[chosen] + (next[chosen] > 0 ? def_.parameters.reaction : 0.0));
        if (chosen != before) now += selectSeconds(planned);
        now += clickSeconds(planned, distance(from, to));
        due[chosen] = now + tours_->ground().distance(from, to) / def_.speed;
        last = std::max(last, due[chosen]);
        ++next[chosen];
        before = chosen;
    }
}

double Planner::estimate(const OperatorPlan& plan) const {
    return def_.repertoire.draws || def_.repertoire.queues ? estimateQueued(plan) : estimateAttended(plan);
}

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

// Divides the crowd into cells, and the tour into as many stretches.
OperatorPlan Planner::divided(const SeenPart& crowd, std::span<const std::int32_t> tour, std::int32_t columns,
                              std::int32_t rows, Chance& chance) const {
    OperatorPlan plan = cells(crowd, columns, rows);
    if (plan.parts.empty()) return plan;
    const std::int32_t count = columns * rows;
    char text[64];
    std::snprintf(text, sizeof(text), "%d x %d parts", columns, rows);
    plan.text = text;
    // Stretches of the tour end where what has been walked exceeds the part's share, counted with the way
    // there.
    std::vector<std::vector<std::int32_t>> stretches;
    double low = 0.0;
    double high = tours_->length(crowd.centre, tour) + 1.0;
    for (std::int32_t round = 0; round < 24; ++round) {
        const double most = 0.5 * (low + high);
        std::vector<std::vector<std::int32_t>> found(1);
        double walked = 0.0;
        for (const std::int32_t item : tour) {
            const double there = tours_->ground().distance(crowd.centre, tours_->items()[item]);
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
    // Those who have farthest to go are sent first.
    std::stable_sort(plan.parts.begin(), plan.parts.end(), [&](const PlannedPart& a, const PlannedPart& b) {
        return walkSeconds(a) > walkSeconds(b);
    });
    plan.seconds = estimate(plan);
    return plan;
}

// Lanes side by side, as wide as the front, from the end that is nearer.
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
    // Half of it lies aside of where it stands before it can begin.
    const double own = crowd.bounds.width() * std::abs(across.x) + crowd.bounds.height() * std::abs(across.y);
    plan.parts[0].reforms = 0.5 * std::abs(width - own) / def_.speed;
    plan.seconds = estimate(plan);
    return plan;
}

// The sweep of a part that takes least; one without a way where none does.
PlannedPart Planner::bestSweep(const SeenPart& part, std::span<const std::int32_t> open) const {
    PlannedPart best{part, {}, {}, 0.0, false, {}, 0.0, false, 0.0};
    double least = kInfinite;
    for (const double width : kWidths) {
        if (width > kLoosest * def_.spacing * static_cast<double>(part.ids.size())) continue;
        for (const Vec2 along : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
            OperatorPlan plan = swept(part, open, along, width);
            if (plan.seconds >= least || plan.parts[0].way.empty()) continue;
            least = plan.seconds;
            best = std::move(plan.parts[0]);
        }
    }
    return best;
}

// The same sweep, but that the part goes through the narrows on its way as it is; none where there are none.
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
    if (beyond.size() + kLeftOver < open.size()) return std::nullopt;
    std::vector<Vec2> there = sweep.part.positions;
    for (Vec2& p : there) p += stage - sweep.part.centre;
    const PlannedPart rest = bestSweep(seenPart(sweep.part.ids, there), beyond);
    if (rest.way.empty()) return std::nullopt;
    planned.later = motor_->factor() * def_.parameters.decide + kLaterShare * partSeconds(rest) +
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
        PlannedPart best = bestSweep(plan.parts[side].part, own);
        if (best.way.empty()) return {{}, {}, kInfinite, {}};
        if (const auto other = staged(best, own); other && partSeconds(*other) < partSeconds(best))
            best = *other;
        best.stops = own;
        plan.parts[side] = std::move(best);
    }
    // Those who have farthest to go are sent first.
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

OperatorPlan Planner::plan(const SeenPart& crowd, std::span<const std::int32_t> open, Chance& chance) const {
    const std::vector<std::int32_t> tour = tours_->tour(
        crowd.centre, open, def_.parameters.routeDetour * 2.0 * chance.uniform(), chance);
    OperatorPlan best;
    best.seconds = kInfinite;
    const auto most = static_cast<std::int32_t>(def_.parameters.groupsInMind + 0.5);
    const auto consider = [&](OperatorPlan&& plan) {
        if (plan.seconds < best.seconds) best = std::move(plan);
    };
    for (const auto& [columns, rows] : kDivisions) {
        if (columns * rows > most || (columns * rows > 1 && !def_.repertoire.divides)) continue;
        if (std::ssize(crowd.ids) < 2 * columns * rows) continue;
        consider(divided(crowd, tour, columns, rows, chance));
    }
    if (!def_.repertoire.spreads) return best;
    for (const double width : kWidths) {
        if (width > def_.spacing * static_cast<double>(crowd.ids.size())) continue;
        for (const Vec2 along : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
            consider(swept(crowd, open, along, width));
    }
    if (def_.repertoire.divides && most >= 2 && std::ssize(crowd.ids) >= 4)
        for (const std::int32_t columns : {1, 2})
            for (const double share : {0.35, 0.5, 0.65}) consider(parted(crowd, open, columns, share));
    return best;
}

// How far the formation would have to be pushed together at the border on its way [m].
double Planner::beyondBorder(const PlannedPart& planned) const {
    double most = 0.0;
    for (const Vec2 to : planned.way)
        for (const Vec2 p : planned.part.positions) {
            const Vec2 there = to + p - planned.part.centre;
            most = std::max(most, distance(there, def_.border.clamp(there)));
        }
    return most;
}

double Planner::partSeconds(const PlannedPart& planned) const {
    OperatorPlan plan;
    plan.parts.push_back(planned);
    return estimate(plan);
}

double Planner::takeOutSeconds(const PlannedPart& few) const {
    if (!def_.repertoire.draws) return 0.0;  // They are selected anyway.
    const double mm = def_.mmPerMetre;
    const double round = 2.0 * (few.part.bounds.width() + few.part.bounds.height() + 4.0 * kTakenMargin);
    return motor_->point(6.0 * mm, kTargetMetres * mm) + motor_->draw(round * mm, kTargetMetres * mm) +
           motor_->device().handOff + motor_->factor() * def_.parameters.decideNext + 2.0 * motor_->press();
}

double Planner::callSeconds() const {
    const double mm = def_.mmPerMetre;
    return motor_->point(8.0 * mm, kTargetMetres * mm) + 2.0 * kTapSeconds + kBetweenTaps +
           motor_->factor() * def_.parameters.decideNext;
}

std::optional<PlannedPart> Planner::fetched(const SeenPart& part, std::span<const std::int32_t> open,
                                            Chance& chance) const {
    if (!def_.repertoire.divides || open.empty() || part.ids.size() <= 2 * kFew) return std::nullopt;
    const auto away = [&](std::size_t i, std::int32_t item) {
        return tours_->ground().distance(part.positions[i], tours_->items()[item]);
    };
    std::int32_t nearest = open[0];
    double least = kInfinite;
    for (const std::int32_t item : open)
        for (std::size_t i = 0; i < part.ids.size(); ++i)
            if (away(i, item) < least) {
                least = away(i, item);
                nearest = item;
            }
    std::vector<std::size_t> order(part.ids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return away(a, nearest) < away(b, nearest); });
    order.resize(kFew);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return part.ids[a] < part.ids[b]; });
    std::vector<std::uint32_t> ids;
    std::vector<Vec2> positions;
    for (const std::size_t i : order) {
        ids.push_back(part.ids[i]);
        positions.push_back(part.positions[i]);
    }
    return next(seenPart(std::move(ids), std::move(positions)), open, chance);
}

PlannedPart Planner::renewed(const SeenPart& part, std::span<const std::int32_t> open, bool sweeps,
                             Chance& chance) const {
    PlannedPart best = next(part, open, chance);
    if (!def_.repertoire.spreads) return best;
    // A wide formation that is pushed together leaves items beside its way.
    if (beyondBorder(best) > kMostPushed) best.reforms = kPushedSeconds;
    double least = partSeconds(best);
    const double own = std::max(part.bounds.width(), part.bounds.height());
    const auto side = static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(part.ids.size()))));
    const double square = def_.spacing * (side - 1);
    if (own > kWide * std::max(square, def_.spacing)) {
        SeenPart squared = part;
        for (std::size_t i = 0; i < squared.positions.size(); ++i) {
            const auto n = static_cast<std::int32_t>(i);
            const Vec2 place{static_cast<double>(n % side), static_cast<double>(n / side)};
            squared.positions[i] = part.centre + place * def_.spacing - Vec2{0.5 * square, 0.5 * square};
        }
        PlannedPart led = next(seenPart(squared.ids, squared.positions), open, chance);
        led.square = true;
        led.reforms = 2.0 * motor_->point(0.0, kTargetMetres * def_.mmPerMetre) + (own - square) / def_.speed;
        const double seconds = partSeconds(led);
        if (seconds < least) {
            least = seconds;
            best = std::move(led);
        }
    }
    if (!sweeps) return best;
    for (const double width : kWidths) {
        if (width > def_.spacing * static_cast<double>(part.ids.size())) continue;
        for (const Vec2 along : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
            OperatorPlan plan = swept(part, open, along, width);
            if (plan.seconds >= least || plan.parts[0].way.empty()) continue;
            least = plan.seconds;
            best = std::move(plan.parts[0]);
        }
    }
    return best;
}

PlannedPart Planner::next(const SeenPart& part, std::span<const std::int32_t> open, Chance& chance) const {
    PlannedPart planned{part, {}, {}, 0.0, false, {}, 0.0, false, 0.0};
    lead(planned,
         tours_->tour(part.centre, open, def_.parameters.routeDetour * 2.0 * chance.uniform(), chance));
    return planned;
}

}  // namespace muster
