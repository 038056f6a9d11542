// Scenes for marches that flow: rectangles in a box, formations, who goes where, and what a march comes to.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/maths.h"
#include "base/random.h"
#include "engine/orders/pairing.h"
#include "engine/orders/stream.h"
#include "engine/orders/way_search.h"

namespace muster::stream_scenes {

inline constexpr double kRadius = 0.3;     ///< Of bodies [m].
inline constexpr double kSpeed = 2.0;      ///< Top speed [m/s].
inline constexpr double kSceneStep = 0.1;  ///< Of time [s].

using Points = std::vector<Vec2>;

/// Rectangles in a box.
struct Ground {
    Box box;
    std::vector<Box> rects;

    /// Exact distance to a rectangle or the edge of the box, negative inside [m].
    double room(Vec2 p) const {
        double least = std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y});
        for (const Box& r : rects) {
            const double dx = std::max(r.min.x - p.x, p.x - r.max.x),
                         dy = std::max(r.min.y - p.y, p.y - r.max.y);
            const double out = dx < 0.0 && dy < 0.0 ? std::max(dx, dy)
                                                    : length({std::max(dx, 0.0), std::max(dy, 0.0)});
            least = std::min(least, out);
        }
        return least;
    }
    /// As the library's own environment.
    Environment environment() const {
        Environment environment = Environment::create({.box = box}).value();
        for (const Box& r : rects) {
            ObstacleDef obstacle{.polygon = {r.min, {r.max.x, r.min.y}, r.max, {r.min.x, r.max.y}}};
            (void)environment.addObstacle(obstacle);
        }
        environment.setTime(0.0);
        return environment;
    }
};

struct Scene {
    std::string name;
    Ground ground;
    Points shape;  ///< x forward, y left, middle of its box at the origin.
    Points start;  ///< In any order.
    Vec2 target;
    double bound = 0.0;  ///< No march arrives before [s].
};

inline Points moved(const Points& points, Vec2 by, double angle = 0.0) {
    const Pose pose{by, {cosine(angle), sine(angle)}};
    Points out;
    for (const Vec2 p : points) out.push_back(pose.apply(p));
    return out;
}
inline Points centred(Points points) {
    Vec2 least = points[0], most = points[0];
    for (const Vec2 p : points) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
    return moved(points, (least + most) * -0.5);
}
/// A block of `deep` ranks of `wide`.
inline Points block(int deep, int wide) {
    Points out;
    for (int i = 0; i < deep; ++i)
        for (int j = 0; j < wide; ++j) out.push_back({static_cast<double>(i), static_cast<double>(j)});
    return centred(out);
}
inline Points wedge(int rows) {
    Points out;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j <= i; ++j) out.push_back({-i * 1.0, (j - i / 2.0) * 2.0});
    return centred(out);
}
inline Points ring(int n) {
    Points out;
    const double r = 0.5 / sine(kPi / n);
    for (int i = 0; i < n; ++i) out.push_back(Vec2{cosine(2 * kPi * i / n), sine(2 * kPi * i / n)} * r);
    return centred(out);
}

/// For each of `a` one of `b`, by least squares.
inline std::vector<std::int32_t> pair(const Points& a, const Points& b) {
    Pairing pairing;
    const auto to = pairing.pair(a, b);
    return {to.begin(), to.end()};
}

/// The nearest middle at which the formation stands free; the target where there is none.
inline Vec2 fit(const Ground& ground, const Points& shape, Vec2 target, double facing, bool& fits) {
    fits = true;
    for (int rad = 0; rad < 50; ++rad)
        for (int t = 0; t < std::max(1, 4 * rad); ++t) {
            const double angle = 2 * kPi * t / std::max(1, 4 * rad);
            const Vec2 c = target + Vec2{cosine(angle), sine(angle)} * (0.5 * rad);
            const Points at = moved(shape, c, facing);
            if (std::all_of(at.begin(), at.end(), [&](Vec2 p) { return ground.room(p) >= kRadius; }))
                return c;
        }
    fits = false;
    return target;
}

/// Free points of a lattice, nearest to the target first.
inline Points spread(const Ground& ground, std::size_t n, Vec2 target) {
    Points out;
    for (double x = ground.box.min.x + kRadius; x <= ground.box.max.x - kRadius; x += 1.0)
        for (double y = ground.box.min.y + kRadius; y <= ground.box.max.y - kRadius; y += 1.0)
            if (ground.room({x, y}) >= kRadius) out.push_back({x, y});
    std::sort(out.begin(), out.end(), [&](Vec2 a, Vec2 b) {
        const double da = lengthSquared(a - target), db = lengthSquared(b - target);
        return da != db ? da < db : (a.x != b.x ? a.x < b.x : a.y < b.y);
    });
    out.resize(std::min(n, out.size()));
    return out;
}

/// A march as it is planned.
struct Task {
    Points offsets, starts, ends, way;
    StreamDef def() const { return {offsets, starts, ends, way, 1.0, kRadius}; }
};

inline Vec2 middleOf(const Points& points) {
    Vec2 sum;
    for (const Vec2 p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

inline double widthOf(const Points& shape) {
    double least = 1e9, most = -1e9;
    for (const Vec2 p : shape) {
        least = std::min(least, p.y);
        most = std::max(most, p.y);
    }
    return most - least + 1.0;
}

inline Points searchWay(const Ground& ground, Vec2 from, Vec2 to, double width) {
    const Environment environment = ground.environment();
    WayGround map;
    map.update(environment);
    WayQuery query{from, to, {}};
    query.needs.half = 0.5 * width;
    query.needs.margin = 1.0;
    query.needs.radius = kRadius;
    WaySearch search;
    search.start(map, query);
    while (search.advance(map, 1 << 20) == WayStatus::Searching) {
    }
    return search.path();
}

/// Who goes where: by least squares at both ends, or at once where the way is straight.
inline Task taskOf(const Scene& scene, bool straight) {
    Task task;
    const Vec2 from = middleOf(scene.start), ahead = scene.target - from;
    const double facing = arcTangent2(ahead.y, ahead.x);
    bool fits = true;
    const Vec2 to = fit(scene.ground, scene.shape, scene.target, facing, fits);
    Points ends = fits ? moved(scene.shape, to, facing) : spread(scene.ground, scene.shape.size(), to);
    const Vec2 goal = fits ? to : middleOf(ends);
    const bool plain = straight && fits;
    task.way = straight ? Points{from, goal} : searchWay(scene.ground, from, goal, widthOf(scene.shape));
    if (task.way.size() < 2) return task;
    task.way.front() = from;
    task.way.back() = goal;
    const Vec2 first = task.way[1] - task.way[0], last = task.way.back() - task.way[task.way.size() - 2];
    const auto at = [&](Vec2 middle, Vec2 along) {
        return moved(scene.shape, middle, arcTangent2(along.y, along.x) + 1e-6);
    };
    const Vec2 faced{cosine(facing), sine(facing)};
    const auto own = pair(at(from, plain ? faced : first), scene.start);
    const auto to2 = pair(at(goal, plain ? faced : last), ends);
    task.offsets = scene.shape;
    for (std::size_t i = 0; i < scene.shape.size(); ++i) {
        task.starts.push_back(scene.start[own[i]]);
        task.ends.push_back(ends[to2[i]]);
    }
    return task;
}

inline double leastDistance(const Points& places) {
    double least = 1e18;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, lengthSquared(places[i] - places[j]));
    return std::sqrt(least);
}

/// What a march came to.
struct Played {
    StreamStatus status = StreamStatus::Blocked;
    double seconds = 0.0;  ///< Until all are there.
    double bound = 0.0;    ///< Nine in ten do not arrive before: the straight ways of these [s].
    double nearest = 1e9;  ///< Two places at any time [m].
    double fastest = 0.0;  ///< Of nine in ten places [m/s].
    double room = 1e9;     ///< Least distance to a wall, relative to that of starts, ends and the radius [m].
    double extent = 0.0;   ///< Largest distance of two places [m].
    std::int64_t operations = 0;
    bool finite = true;
};

/// The largest distance between points of the same number, but for the tenth that is farthest [m].
inline double ofNineInTen(const Points& a, const Points& b) {
    std::vector<double> ways;
    for (std::size_t i = 0; i < a.size(); ++i) ways.push_back(distance(a[i], b[i]));
    std::sort(ways.begin(), ways.end());
    return ways[ways.size() - 1 - ways.size() / 10];
}

/// Plans a march whole.
template <class Plan>
StreamStatus plan(Plan& plan, const StreamDef& def, StreamGround ground) {
    plan.start(def);
    return plan.advance(ground, std::numeric_limits<std::int64_t>::max() / 2);
}

/// Plays a planned march.
inline Played play(const Ground& ground, const Task& task, Stream& stream, double limit = 600.0) {
    Played out{.status = stream.status(), .operations = stream.operations()};
    if (out.status == StreamStatus::Blocked) return out;
    out.bound = ofNineInTen(task.starts, task.ends) / kSpeed;
    Points places(task.starts.size());
    const std::vector<double> speeds(places.size(), kSpeed);
    double q = 0.0, endRoom = kRadius;
    stream.at(0.0, places);
    for (const Points* list : {&task.starts, &task.ends})
        for (const Vec2 p : *list) endRoom = std::min(endRoom, ground.room(p));
    while (true) {
        for (const Vec2 p : places) out.finite = out.finite && isFinite(p);
        out.nearest = std::min(out.nearest, leastDistance(places));
        for (const Vec2 p : places) out.room = std::min(out.room, ground.room(p) - endRoom);
        if (q >= 1.0 || out.seconds >= limit) break;
        const Points before = places;
        double rate = 0.0;
        q = stream.next(q, kSceneStep, speeds, places, rate);
        out.fastest = std::max(out.fastest, ofNineInTen(before, places) / kSceneStep);
        out.seconds += kSceneStep;
    }
    return out;
}

/// The least jump-free measure: how far a place moves while q moves on by so little, at most [m].
inline double largestMove(const Stream& stream, double q, double by) {
    Points a(stream.places()), b(stream.places());
    stream.at(q, a);
    stream.at(std::min(1.0, q + by), b);
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
    return most;
}

/// Plans and plays the straight way and the searched one; the first to arrive.
inline Played best(const Scene& scene, Stream& stream, bool searched = true) {
    Played first;
    for (const bool straight : {true, false}) {
        if (!straight && (!searched || first.status == StreamStatus::Straight)) break;
        const Task task = taskOf(scene, straight);
        if (task.starts.empty()) continue;
        const auto ground = [&](Vec2 p) { return scene.ground.room(p); };
        if (plan(stream, task.def(), ground) == StreamStatus::Blocked) continue;
        const Played played = play(scene.ground, task, stream);
        if (first.status == StreamStatus::Blocked || played.seconds < first.seconds) first = played;
    }
    return first;
}

inline Box rect(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y1}};
}
/// People in three rings round a house.
inline Scene roundHouse() {
    Points people;
    for (const double rad : {3.4, 4.4, 5.4})
        for (int i = 0; i < 12; ++i)
            people.push_back(Vec2{cosine(2 * kPi * (i + rad) / 12), sine(2 * kPi * (i + rad) / 12)} * rad);
    return {"house36",   {rect(0, 0, 60, 40), {rect(13, 18, 17, 22)}},
            block(6, 6), moved(people, {15, 20}),
            {40, 20},    13.8};
}
/// A line of 60 before a wall with a door.
inline Scene door(double width) {
    const Points line = block(1, 60);
    const Ground ground{rect(0, 0, 100, 80),
                        {rect(49.8, 0, 50.2, 40 - width / 2), rect(49.8, 40 + width / 2, 50.2, 80)}};
    return {"door", ground, line, moved(line, {5, 40}), {95, 40}, 53.8};
}
/// A line of 60, and a street of 10 m with two corners between two squares.
inline Scene street() {
    const Points line = block(1, 60);
    const Ground ground{
        rect(0, 0, 230, 110),
        {rect(70, 0, 160, 20), rect(70, 30, 110, 110), rect(120, 20, 160, 50), rect(110, 60, 160, 110)}};
    return {"street60", ground, line, moved(line, {20, 40}), {200, 55}, 110};
}
inline Scene beside(double y0, double y1) {
    return {"beside48",  {rect(0, 0, 80, 40), {rect(36, y0, 44, y1)}},
            block(8, 6), moved(block(8, 6), {12, 20}),
            {62, 20},    25};
}
/// Through a gap of 5 m.
inline Scene gap(const Points& shape) {
    return {"gap",    {rect(0, 0, 80, 40), {rect(39.5, 0, 40.5, 17.5), rect(39.5, 22.5, 40.5, 40)}},
            shape,    moved(shape, {14, 20}),
            {64, 20}, 26};
}
inline Scene narrow() {
    return {"narrow",      {rect(0, 0, 80, 20), {rect(30, 0, 45, 6), rect(30, 14, 45, 20)}},
            block(10, 10), moved(block(10, 10), {14, 10}),
            {66, 10},      26};
}
inline Scene pillar() {
    return {"pillar",      {rect(0, 0, 80, 20), {rect(38.5, 8.5, 41.5, 11.5)}},
            block(10, 10), moved(block(10, 10), {14, 10}),
            {66, 10},      26};
}
/// 200 before a wall with gates; the target lies `aside` of straight on.
inline Scene gates(int n, double width, double apart, double aside) {
    Ground ground{rect(-50, -30, 50, 30), {}};
    double wall = -30;
    for (int k = 0; k < n; ++k) {
        const double y = (k - (n - 1) / 2.0) * apart;
        ground.rects.push_back(rect(-0.25, wall, 0.25, y - width / 2));
        wall = y + width / 2;
    }
    ground.rects.push_back(rect(-0.25, wall, 0.25, 30));
    return {"gates", ground, block(10, 20), moved(block(10, 20), {-18, 0}), {18, aside}, 20};
}
/// A row of posts of 1 m with gaps across the way.
inline Scene posts(int n, double gap, const Points& shape) {
    Scene scene{"posts", {rect(-40, -20, 40, 20), {}}, shape, moved(shape, {-18, 0}), {18, 0}, 18};
    for (int k = 0; k < n; ++k) {
        const double y = (k - (n - 1) / 2.0) * (gap + 1.0);
        scene.ground.rects.push_back(rect(-0.5, y - 0.5, 0.5, y + 0.5));
    }
    return scene;
}
/// A block into a corner, from `from`.
inline Scene corner(double from) {
    return {"corner", {rect(0, 0, 40, 40), {}}, block(10, 10), moved(block(10, 10), {from, from}), {39, 39},
            1.6};
}
/// A target near or beyond the edge of the world.
inline Scene edge() {
    return {"edge", {rect(0, 0, 60, 60), {}}, block(10, 10), moved(block(10, 10), {15, 30}), {59.5, 30},
            20.0};
}
/// Random rectangles, people and target.
inline Scene random(std::uint64_t seed) {
    Random dice(seed);
    Scene scene{"random", {rect(0, 0, 50, 50), {}}, {}, {}, {}, 0.0};
    scene.shape = dice.below(2) == 0 ? block(1 + dice.below(5), 1 + dice.below(12))
                                     : ring(5 + dice.below(20));
    const auto houses = dice.below(13);
    for (std::uint32_t k = 0; k < houses; ++k) {
        const double x = dice.uniform(1, 45), y = dice.uniform(1, 45);
        scene.ground.rects.push_back(rect(x, y, x + dice.uniform(0.2, 8), y + dice.uniform(0.2, 8)));
    }
    bool fits = false;
    const Vec2 from = fit(scene.ground, scene.shape, {dice.uniform(5, 45), dice.uniform(5, 45)}, 0.0, fits);
    scene.start = fits ? moved(scene.shape, from) : spread(scene.ground, scene.shape.size(), from);
    scene.target = {dice.uniform(5, 45), dice.uniform(5, 45)};
    return scene;
}

}  // namespace muster::stream_scenes
