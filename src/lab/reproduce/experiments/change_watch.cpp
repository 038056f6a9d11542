#include "lab/reproduce/experiments/change_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/world/metrics.h"

namespace muster {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Distance to the place within which a character counts as standing on it [m].
constexpr double kStoodReach = 0.1;

/// The time at which `share` of all had arrived; NaN where they have not.
double quantile(std::vector<double> moments, double share) {
    std::sort(moments.begin(), moments.end());
    const double rank = std::ceil(share * static_cast<double>(moments.size()) - 1e-9);
    const double moment = moments[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
    return std::isfinite(moment) ? moment : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ChangeWatch::ChangeWatch(const World& world, std::size_t group)
    : group_(group),
      version_(world.group(group).formationVersion),
      lastTime_(world.time()),
      last_(positions(world)) {}

std::vector<Vec2> ChangeWatch::positions(const World& world) const {
    const CharactersView c = world.characters();
    std::vector<Vec2> found;
    for (std::size_t i = 0; i < c.size(); ++i)
        if (c.group[i] == group_) found.push_back(c.position[i]);
    return found;
}

void ChangeWatch::begin(const World& world) {
    const GroupView group = world.group(group_);
    running_ = {};
    running_.kind = group.formation;
    running_.time = lastTime_;
    running_.bottleneck = bottleneckWalk(last_, group.placeTargets);
    reachedAt_.assign(last_.size(), kInfinity);
    stoodAt_ = reachedAt_;
    movedAt_.assign(last_.size(), lastTime_);
    spot_ = last_;
    watching_ = true;
}

void ChangeWatch::observe(const World& world) {
    const GroupView group = world.group(group_);
    if (group.formationVersion != version_) {
        if (watching_) done_.push_back(judged());
        version_ = group.formationVersion;
        begin(world);
    }
    const std::vector<Vec2> now = positions(world);
    const CharactersView c = world.characters();
    for (std::size_t i = 0, k = 0; watching_ && i < c.size(); ++i) {
        if (c.group[i] != group_) continue;
        const auto place = static_cast<std::size_t>(c.place[i]);
        const double away = c.place[i] < 0 ? kInfinity : distance(c.position[i], group.placePositions[place]);
        reachedAt_[k] = away > kArrivedReach ? kInfinity : std::min(reachedAt_[k], world.time());
        stoodAt_[k] = away > kStoodReach ? kInfinity : std::min(stoodAt_[k], world.time());
        if (distance(c.position[i], spot_[k]) >= kStuckDistance) {
            spot_[k] = c.position[i];
            movedAt_[k] = world.time();
        }
        ++k;
    }
    last_ = now;
    lastTime_ = world.time();
}

FormationChangeRecord ChangeWatch::judged() const {
    FormationChangeRecord record = running_;
    const auto moments = [&](const std::vector<double>& since) {
        std::vector<double> found;
        for (const double at : since)
            found.push_back(lastTime_ - at >= kArrivedTime - 1e-9 ? at - record.time : kInfinity);
        return found;
    };
    const std::vector<double> arrived = moments(reachedAt_);
    for (std::size_t k = 0; k < arrived.size(); ++k)
        if (arrived[k] == kInfinity && lastTime_ - movedAt_[k] >= kStuckTime) ++record.stuck;
    record.arrived95 = quantile(arrived, 0.95);
    record.arrived100 = quantile(arrived, 1.0);
    record.stood95 = quantile(moments(stoodAt_), 0.95);
    return record;
}

std::vector<FormationChangeRecord> ChangeWatch::changes() const {
    std::vector<FormationChangeRecord> all = done_;
    if (watching_) all.push_back(judged());
    return all;
}

}  // namespace muster
