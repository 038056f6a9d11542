#include "engine/world/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/ground/environment/environment.h"
#include "engine/steering/stairs.h"
#include "engine/world/inspect.h"
#include "muster/views.h"

namespace muster {
namespace {

constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
// Speed below which places between a wall and each other only tremble [m/s].
constexpr double kTrembleSpeed = 0.03;

/// The smallest value that `share` of all do not exceed; -1 for none.
double quantile(std::vector<double> values, double share) {
    if (values.empty()) return -1.0;
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

bool anythingMoves(const Environment& environment) {
    for (ObstacleId id : environment.obstacleIds()) {
        if (!environment.obstacle(id)->path.still()) return true;
    }
    for (PatchId id : environment.patchIds()) {
        if (!environment.patch(id)->path.still()) return true;
    }
    return false;
}

}  // namespace

RunMetrics::RunMetrics(const World& world) {
    samplePeriod_ = static_cast<std::uint32_t>(
        std::max(1.0, std::floor(1.0 / world.parameters().stepTime + 0.5)));
    follow(world.characters());
    departures_.observe(world);
    still_ = world.stepCount() == 0 && !anythingMoves(inspect::environment(world));
}

/// Keeps one entry per character: characters that left drop out, characters that joined begin here.
void RunMetrics::follow(const CharactersView& characters) {
    if (std::equal(ids_.begin(), ids_.end(), characters.id.begin(), characters.id.end())) return;
    const RunMetrics old = *this;
    const std::size_t count = characters.size();
    ids_.assign(characters.id.begin(), characters.id.end());
    reachedAt_.assign(count, kNever);
    last_.assign(characters.position.begin(), characters.position.end());
    start_ = last_;
    walked_.assign(count, 0.0);
    trail_.resize(count);
    std::size_t from = 0;  // Both lists ascend.
    for (std::size_t i = 0; i < count; ++i) {
        trail_[i].fill(characters.position[i]);
        while (from < old.ids_.size() && old.ids_[from] < ids_[i]) ++from;
        if (from == old.ids_.size() || old.ids_[from] != ids_[i]) continue;
        reachedAt_[i] = old.reachedAt_[from];
        start_[i] = old.start_[from];
        last_[i] = old.last_[from];
        walked_[i] = old.walked_[from];
        trail_[i] = old.trail_[from];
    }
}

void RunMetrics::watchArrivals(const World& world) {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        // A character that leaves by an exit has arrived when it has left, not before the exit.
        if (inspect::distanceLeft(world, i) > kArrivedReach || inspect::leaves(world, i)) {
            reachedAt_[i] = kNever;
        } else if (reachedAt_[i] == kNever) {
            reachedAt_[i] = world.stepCount();
        }
    }
}

void RunMetrics::watchSpeeds(const World& world) {
    const CharactersView characters = world.characters();
    const Environment& environment = inspect::environment(world);
    const Ring ring = environment.def().joined();
    const bool patches = !environment.patchIds().empty();
    const Parameters& parameters = world.parameters();
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        if (characters.driver[i] != Driver::Muster) continue;
        const double own = characters.body[i].maxSpeed;
        const double top = own > 0.0 ? own : parameters.character.maxSpeed;
        const Vec2 moved = ring.between(last_[i], characters.position[i]);
        const double ratio = length(moved) / (top * parameters.stepTime);
        if (ratio <= topSpeedRatio_) continue;
        const GroundSample ground = patches ? environment.ground(last_[i]) : GroundSample{};
        const double travel = travelSpeedOf(ground, characters.body[i], normalized(moved));
        topSpeedRatio_ = std::max(topSpeedRatio_, ratio / travel);
    }
}

void RunMetrics::watchEvents(const World& world) {
    for (const Event& event : world.events()) {
        ++events_[static_cast<std::size_t>(event.kind)];
        if (!isAboutMany(event.kind)) continue;
        std::uint32_t& most = persons_[{event.kind, event.subject}];
        most = std::max(most, event.value);
    }
    departures_.observe(world);
}

void RunMetrics::observe(const World& world) {
    const CharactersView characters = world.characters();
    const Ring ring = inspect::environment(world).def().joined();
    follow(characters);
    watchSpeeds(world);
    const bool sample = world.stepCount() % samplePeriod_ == 0;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        walked_[i] += length(ring.between(last_[i], characters.position[i]));
        last_[i] = characters.position[i];
        if (!sample) continue;
        std::move_backward(trail_[i].begin(), trail_[i].end() - 1, trail_[i].end());
        trail_[i][0] = characters.position[i];
    }
    if (sample) ++trailSamples_;
    watchArrivals(world);
    watchEvents(world);
    characterSeconds_ += static_cast<double>(ids_.size()) * world.parameters().stepTime;
    overlapPairsMax_ = std::max(overlapPairsMax_, world.contacts().overlapPairs);
    worstPenetration_ = std::max(worstPenetration_, world.contacts().worstPenetration);
    still_ = still_ && world.lastCommandStep() == 0;
    stepTimes_.push_back(static_cast<float>(world.stageTimes().total));
    for (std::size_t s = 0; s < stageSum_.size(); ++s) stageSum_[s] += world.stageTimes().milliseconds[s];
}

bool RunMetrics::hasArrived(const World& world, std::size_t character) const {
    const std::uint32_t at = reachedAt_[character];
    return at != kNever && (world.stepCount() - at) * world.parameters().stepTime >= kArrivedTime - 1e-9;
}

std::int32_t RunMetrics::notArrived(const World& world) const {
    std::int32_t count = 0;
    for (std::size_t i = 0; i < ids_.size(); ++i) count += hasArrived(world, i) ? 0 : 1;
    return count;
}

void RunMetrics::arrivals(const World& world, RunFigures& figures) const {
    const double stepTime = world.parameters().stepTime;
    const std::uint32_t clock = world.lastCommandStep();
    const Ring ring = inspect::environment(world).def().joined();
    const auto since = [&](std::uint32_t step) { return step > clock ? (step - clock) * stepTime : 0.0; };
    std::vector<double> moments;
    for (const std::uint32_t step : departures_.leftAt()) moments.push_back(since(step));
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const std::uint32_t at = reachedAt_[i];
        const bool arrived = hasArrived(world, i);
        moments.push_back(arrived ? since(at) : std::numeric_limits<double>::infinity());
        if (arrived || trailSamples_ < trail_[i].size()) continue;
        double moved = 0.0;
        for (Vec2 p : trail_[i]) moved = std::max(moved, length(ring.between(p, last_[i])));
        if (moved < kStuckDistance) ++figures.stuck;
    }
    if (DepartureWatch::moreMayCome(world)) return;
    const auto finite = [](double moment) { return std::isfinite(moment) ? moment : -1.0; };
    figures.arrived95 = finite(quantile(moments, 0.95));
    figures.arrived100 = finite(quantile(moments, 1.0));
}

double RunMetrics::pathRatio(const World& world) const {
    double least = 0.0;
    double walked = 0.0;
    for (double w : walked_) walked += w;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        std::vector<Vec2> starts;
        for (std::size_t i = 0; i < ids_.size(); ++i) {
            if (world.characters().group[i] == g) starts.push_back(start_[i]);
        }
        const double sum = leastWalk(inspect::environment(world), world.parameters().character.radius, starts,
                                     world.group(g).placePositions);
        if (sum < 0.0) return -1.0;
        least += sum;
    }
    return least > 0.0 ? walked / least : -1.0;
}

RunFigures RunMetrics::figures(const World& world, bool withPathRatio) const {
    RunFigures figures;
    figures.characters = static_cast<std::int32_t>(ids_.size());
    figures.steps = world.stepCount();
    figures.hash = world.hash();
    arrivals(world, figures);
    figures.overlapPairsMax = overlapPairsMax_;
    figures.worstPenetration = worstPenetration_;
    figures.topSpeedRatio = topSpeedRatio_;
    figures.events = events_;
    for (const auto& [of, most] : persons_) figures.eventPersons[static_cast<std::size_t>(of.first)] += most;
    figures.departures = departures_.figures(world);
    const auto swaps = static_cast<double>(events_[static_cast<std::size_t>(EventKind::Swap)]);
    if (characterSeconds_ > 0.0) figures.swapsPerCharacterPerSecond = swaps / characterSeconds_;
    for (std::size_t g = 0; g < world.groupCount(); ++g) figures.planned.add(world.group(g).walk);
    for (const double walk : walked_) figures.walked.add(walk);
    const CharactersView characters = world.characters();
    std::vector<double> lags;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
        const std::int32_t place = characters.place[i];
        const double left = inspect::distanceLeft(world, i);
        const std::span<const Vec2> places = world.group(characters.group[i]).placePositions;
        if (place >= 0 && std::cmp_less(place, places.size()))
            lags.push_back(distance(characters.position[i], places[place]));
        else if (std::isfinite(left))
            lags.push_back(left);
    }
    figures.unmatched = figures.characters - static_cast<std::int32_t>(lags.size());
    figures.lagP95 = std::max(0.0, quantile(lags, 0.95));
    for (std::uint8_t collected : world.collected()) figures.collected += collected != 0 ? 1 : 0;
    const std::vector<double> times(stepTimes_.begin(), stepTimes_.end());
    figures.stepP50 = std::max(0.0, quantile(times, 0.5));
    figures.stepP95 = std::max(0.0, quantile(times, 0.95));
    figures.stepMax = std::max(0.0, quantile(times, 1.0));
    for (std::size_t s = 0; s < stageSum_.size(); ++s) {
        figures.stageMean[s] = times.empty() ? 0.0 : stageSum_[s] / static_cast<double>(times.size());
    }
    if (withPathRatio && still_ && figures.arrived100 >= 0.0) figures.pathRatio = pathRatio(world);
    return figures;
}

bool RunMetrics::settled(const World& world) const {
    if (DepartureWatch::moreMayCome(world)) return false;
    if (ids_.empty()) return true;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        if (!world.group(g).held && world.group(g).orders.size() > 1) return false;
        for (const Control& control : world.group(g).controls) {
            for (const ControlPoint& point : control.points) {
                if (!point.trajectory.empty() || (!point.down && !control.pinned)) return false;
            }
        }
        for (Vec2 v : world.group(g).placeVelocities) {
            if (length(v) > kTrembleSpeed) return false;
        }
    }
    RunFigures figures;
    arrivals(world, figures);
    return figures.arrived100 >= 0.0;
}

}  // namespace muster
