#include "lab/measures/speeds.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

/// Sightings of one person, by frame.
using Rows = std::span<const std::int32_t>;

/// The index of a frame among the sightings of a person; their number where it is missing.
std::size_t indexOf(std::span<const Sighting> all, Rows rows, std::int32_t frame) {
    const auto at = std::lower_bound(rows.begin(), rows.end(), frame,
                                     [&](std::int32_t row, std::int32_t f) { return all[row].frame < f; });
    return at != rows.end() && all[*at].frame == frame ? at - rows.begin() : rows.size();
}

/// The sightings between which the speed at `at` is measured; equal where there is none.
std::pair<std::size_t, std::size_t> spanOf(std::span<const Sighting> all, Rows rows, std::size_t at,
                                           const SpeedDef& def) {
    const auto step = static_cast<std::size_t>(def.frameStep);
    const bool early = at < step, late = rows.size() - 1 - at < step;
    switch (def.border) {
        case SpeedBorder::Adaptive: {
            const std::int32_t frame = all[rows[at]].frame;
            const std::int32_t both = std::min(
                {def.frameStep, frame - all[rows.front()].frame, all[rows.back()].frame - frame});
            const std::size_t from = indexOf(all, rows, frame - both), to = indexOf(all, rows, frame + both);
            const bool missing = from == rows.size() || to == rows.size();
            return missing ? std::pair{at, at} : std::pair{from, to};
        }
        case SpeedBorder::SingleSided:
            return {early ? at : at - step, late ? at : at + step};
        case SpeedBorder::Exclude:
            break;
    }
    return early || late ? std::pair{at, at} : std::pair{at - step, at + step};
}

double speedOf(Vec2 moved, double seconds, const SpeedDef& def) {
    if (def.period > 0.0) moved.x -= def.period * std::floor(moved.x / def.period + 0.5);
    return (def.direction ? dot(moved, normalized(*def.direction)) : length(moved)) / seconds;
}

}  // namespace

std::vector<double> personalSpeeds(const Trajectories& trajectories, const SpeedDef& def) {
    const auto all = trajectories.all();
    std::vector<double> speeds(all.size(), kUnmeasured);
    for (std::size_t who = 0; who < trajectories.persons().size(); ++who) {
        const auto rows = trajectories.ofPerson(who);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const auto [from, to] = spanOf(all, rows, k, def);
            const Sighting &a = all[rows[from]], &b = all[rows[to]];
            if (b.frame > a.frame)
                speeds[rows[k]] = speedOf(b.position - a.position,
                                          (b.frame - a.frame) / trajectories.frameRate(), def);
        }
    }
    return speeds;
}

std::vector<double> classicDensity(const Trajectories& trajectories, const Region& area) {
    std::vector<double> density;
    for (std::int32_t f = 0; f < trajectories.frameCount(); ++f) {
        const auto persons = trajectories.frame(f);
        const auto inside = std::count_if(persons.begin(), persons.end(),
                                          [&](const Sighting& s) { return area.contains(s.position); });
        density.push_back(static_cast<double>(inside) / area.area());
    }
    return density;
}

std::vector<double> meanSpeed(const Trajectories& trajectories, const Region& area,
                              const std::vector<double>& speeds) {
    std::vector<double> mean;
    for (std::int32_t f = 0; f < trajectories.frameCount(); ++f) {
        double sum = 0.0;
        std::size_t counted = 0;
        for (const Sighting& s : trajectories.frame(f)) {
            const double speed = speeds[&s - trajectories.all().data()];
            if (!std::isfinite(speed) || !area.contains(s.position)) continue;
            sum += speed;
            ++counted;
        }
        mean.push_back(counted > 0 ? sum / static_cast<double>(counted) : 0.0);
    }
    return mean;
}

}  // namespace muster
