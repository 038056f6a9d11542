// Rings, corridors, corners and junctions: speed against density.
#include <algorithm>
#include <cmath>

#include "lab/measures/series.h"
#include "lab/measures/voronoi.h"
#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

constexpr double kRingLength = 20.0, kRingWidth = 4.0, kWarmUp = 10.0, kMeasured = 60.0;

/// Density and speed by Voronoi cells, once in a second from `from` to `to`.
std::vector<Vec2> voronoiPoints(const Trajectories& all, const Region& ground, const Box& box, double from,
                                double to, double period = 0.0) {
    const Region area = Region::create(cornersOf(box)).value();
    const auto speeds = personalSpeeds(all, {.frameStep = 10, .period = period});
    std::vector<Vec2> points;
    for (std::int32_t f = 0; f < all.frameCount(); f += 20) {
        const double time = all.timeOf(all.firstFrame() + f);
        if (time < from || time > to) continue;
        const auto persons = all.frame(f);
        const auto cells = voronoiCells(persons, ground, {1.5, 3});
        double density = 0.0, speed = 0.0, covered = 0.0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const double within = cells[i].pieces.empty() ? 0.0 : areaWithin(cells[i], area);
            const double own = speeds[&persons[i] - all.all().data()];
            if (within <= 0.0 || !std::isfinite(own)) continue;
            density += within / cells[i].area;
            speed += own * within;
            covered += within;
        }
        // A point needs people on most of the area, so that empty ground does not count as speed 0.
        if (covered > 0.8 * area.area()) points.push_back({density / area.area(), speed / covered});
    }
    return points;
}

/// Mean speed along +x between two times: the way of all persons, over persons and time [m/s].
class WayAlong {
public:
    explicit WayAlong(double period) : period_(period) {}
    void observe(const World& world) {
        const auto now = world.characters().position;
        for (std::size_t i = 0; i < now.size() && before_.size() == now.size(); ++i) {
            double moved = now[i].x - before_[i].x;
            moved -= period_ * std::floor(moved / period_ + 0.5);
            sum_ += moved;
            absolute_ += std::abs(moved);
        }
        if (before_.size() == now.size())
            seconds_ += world.parameters().stepTime * static_cast<double>(now.size());
        before_.assign(now.begin(), now.end());
    }
    double mean() const { return sum_ / seconds_; }
    double meanAbsolute() const { return absolute_ / seconds_; }

private:
    double period_, sum_ = 0.0, absolute_ = 0.0, seconds_ = 0.0;
    std::vector<Vec2> before_;
};

std::vector<Vec2> ringPlaces(double width, std::int32_t count, std::uint64_t seed) {
    auto places = scattered(boxOf(-0.2, 0, kRingLength - 0.2, width), count, seed, 0.26);
    for (Vec2& p : places) p.x = std::clamp(p.x, 0.01, kRingLength - 0.01);
    return places;
}

/// Variant "density who": people per square metre on a ring of 20 x 4 m; "adults", or "equal" with nearly the
/// same free speed.
Result<VerifySample> runRing(const SceneRun& run) {
    const double density = numberIn(run.variant);
    const auto count = static_cast<std::int32_t>(std::lround(density * kRingLength * kRingWidth));
    Hall hall({boxOf(0, 0, kRingLength, kRingWidth)}, true);
    const bool equal = wordIn(run.variant, 1) == "equal";
    hall.crowd({.starts = ringPlaces(kRingWidth, count, run.seed),
                .people = {equal ? personsOf(Distribution::uniform(1.2, 1.4)) : adults()},
                .order = Order::walk(0.0)});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    WayAlong progress(kRingLength);
    walk->runFor(kWarmUp);
    walk->runFor(kWarmUp + kMeasured, [&] { progress.observe(walk->world()); });
    VerifySample sample;
    sample.figures["speed"] = progress.mean();
    const Trajectories all = withImages(walk->trajectories(), 0.0, kRingLength, 3.0).value();
    const Region ground = Region::create(cornersOf(boxOf(-3, 0, kRingLength + 3, kRingWidth))).value();
    sample.curves["points"] = voronoiPoints(all, ground, boxOf(9, 1, 11, 3), kWarmUp, kWarmUp + kMeasured,
                                            kRingLength);
    walk->report(sample, run);
    return sample;
}

/// Variant: people on a ring of 26 m that is so narrow that nobody overtakes.
Result<VerifySample> runFile(const SceneRun& run) {
    constexpr double kLength = 26.0, kWidth = 0.7, kFileWarmUp = 40.0, kFileMeasured = 60.0;
    const auto count = static_cast<std::int32_t>(numberIn(run.variant));
    Hall hall({boxOf(0, 0, kLength, kWidth)}, true);
    CrowdDef crowd{.people = {personsOf(Distribution::normal(1.24, 0.15, 0.8, 1.7))},
                   .order = Order::walk(0.0)};
    for (std::int32_t i = 0; i < count; ++i)
        crowd.starts.push_back({(i + 0.5) * kLength / count, 0.5 * kWidth});
    hall.crowd(crowd);
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    WayAlong progress(kLength);
    walk->runFor(kFileWarmUp);
    walk->runFor(kFileWarmUp + kFileMeasured, [&] { progress.observe(walk->world()); });
    VerifySample sample;
    sample.figures["speed"] = progress.mean();
    sample.figures["density"] = count / kLength;
    // Each person gives a point by itself: one over the distance to the next one ahead, and its speed, once
    // in a second.
    const Trajectories all = walk->trajectories();
    const auto speeds = personalSpeeds(all, {.frameStep = 10, .direction = Vec2{1, 0}, .period = kLength});
    for (const FileHeadway& h : headways(all, kLength)) {
        const Sighting& s = all.all()[h.sighting];
        if (s.frame % 20 != 0 || all.timeOf(s.frame) < kFileWarmUp || !std::isfinite(speeds[h.sighting]))
            continue;
        sample.curves["points"].push_back({1.0 / std::max(h.distance, 0.01), speeds[h.sighting]});
    }
    walk->report(sample, run);
    return sample;
}

/// Variant: people in a corridor of 60 x 2 m, which they leave at x = 60; measured from x = 20 to 40.
Result<VerifySample> runZones(const SceneRun& run) {
    const auto count = static_cast<std::int32_t>(numberIn(run.variant));
    Hall hall({boxOf(0, 0, 62, 2)});
    hall.exit(boxOf(60, 0, 62, 2));
    hall.crowd({.starts = scattered(boxOf(0, 0, 60, 2), count, run.seed, 0.26),
                .people = {adults()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(25.0);
    const Trajectories all = walk->trajectories();
    const Region zone = Region::create(cornersOf(boxOf(20, 0, 40, 2))).value();
    const auto density = classicDensity(all, zone);
    const auto speed = meanSpeed(all, zone, personalSpeeds(all, {.frameStep = 10, .direction = Vec2{1, 0}}));
    // The time is from 3 s, when all have set out, to 15 s, while the first zone still feeds the second.
    VerifySample sample;
    double densities = 0.0, speeds = 0.0, frames = 0.0;
    for (std::size_t f = 60; f <= 300 && f < density.size(); ++f) {
        densities += density[f], speeds += speed[f], frames += 1.0;
        if (f % 20 == 0) sample.curves["points"].push_back({density[f], speed[f]});
    }
    const auto crossed = firstCrossings(crossings(all, uprightLine(40, 0, 2)), 1);
    const auto passed = std::count_if(crossed.begin(), crossed.end(),
                                      [](const Crossing& c) { return c.time >= 3.0 && c.time <= 15.0; });
    sample.figures["density"] = densities / frames;
    sample.figures["speed"] = speeds / frames;
    sample.figures["flow"] = static_cast<double>(passed) / 12.0;
    walk->report(sample, run);
    return sample;
}

/// Variant: people per square metre in one arm of a corner of 2.4 m width, measured on 2 m before it.
Result<VerifySample> runNarrowCorner(const SceneRun& run) {
    const auto count = static_cast<std::int32_t>(std::lround(numberIn(run.variant) * 20.0 * 2.4));
    Hall hall({boxOf(0, 0, 26.4, 2.4), boxOf(24, 0, 26.4, 20)});
    hall.exit(boxOf(24, 18, 26.4, 20));
    hall.crowd({.starts = scattered(boxOf(0, 0, 20, 2.4), count, run.seed),
                .people = {adults()},
                .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(120.0);
    VerifySample sample;
    sample.figures["time"] = walk->lastLeaving();
    sample.curves["points"] = voronoiPoints(walk->trajectories(), hall.ground(), boxOf(22, 0, 24, 2.4), 5.0,
                                            120.0);
    walk->report(sample, run);
    return sample;
}

/// Variant: people per square metre in both arms of a junction of 2.4 m width, which join.
Result<VerifySample> runJunction(const SceneRun& run) {
    const auto count = static_cast<std::int32_t>(std::lround(numberIn(run.variant) * 12.0 * 2.4));
    Hall hall({boxOf(-20, -2.4, 17.6, 0), boxOf(-2.4, -2.4, 0, 14)});
    hall.exit(boxOf(-2.4, 12, 0, 14));
    for (const double left : {-19.0, 4.6})
        hall.crowd(
            {.name = left < 0.0 ? "Left" : "Right",
             .starts = scattered(boxOf(left, -2.4, left + 12.0, 0), count, run.seed + (left < 0.0 ? 0 : 500)),
             .people = {adults()},
             .order = Order::leave()});
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    walk->runUntil(150.0);
    const Trajectories all = walk->trajectories();
    const Region ground = hall.ground();
    VerifySample sample;
    sample.figures["time"] = walk->lastLeaving();
    for (const Box& box : {boxOf(-4.5, -2.4, -2.5, 0), boxOf(1, -2.4, 3, 0), boxOf(-2.4, 1, 0, 3)}) {
        const auto points = voronoiPoints(all, ground, box, 5.0, 150.0);
        auto& into = sample.curves[box.min.y < 0.0 ? "before" : "after"];
        into.insert(into.end(), points.begin(), points.end());
    }
    walk->report(sample, run);
    return sample;
}

/// Variant: people per square metre on a ring of 20 x 3.6 m, half of them in each direction.
Result<VerifySample> runTwoWays(const SceneRun& run) {
    constexpr double kWidth = 3.6;
    const auto count = static_cast<std::int32_t>(std::lround(numberIn(run.variant) * kRingLength * kWidth));
    Hall hall({boxOf(0, 0, kRingLength, kWidth)}, true);
    const auto places = ringPlaces(kWidth, count, run.seed);
    for (const std::size_t way : {std::size_t{0}, std::size_t{1}}) {
        CrowdDef crowd{.name = way == 0 ? "East" : "West",
                       .people = {adults()},
                       .order = Order::walk(way == 0 ? 0.0 : 3.14159265358979)};
        for (std::size_t i = way; i < places.size(); i += 2) crowd.starts.push_back(places[i]);
        hall.crowd(crowd);
    }
    auto walk = HallRun::start(hall, run.seed);
    if (!walk.ok()) return walk.status();
    WayAlong progress(kRingLength);
    walk->runFor(30.0);
    walk->runFor(70.0, [&] { progress.observe(walk->world()); });
    VerifySample sample;
    sample.figures["speed"] = progress.meanAbsolute();
    walk->report(sample, run);
    return sample;
}

}  // namespace

std::vector<SceneDef> streamScenes() {
    return {{"ring", runRing, 6.0},         {"file", runFile, 2.0},
            {"zones", runZones, 3.0},       {"narrow corner", runNarrowCorner, 3.0},
            {"junction", runJunction, 3.0}, {"two ways", runTwoWays, 5.0}};
}

}  // namespace muster
