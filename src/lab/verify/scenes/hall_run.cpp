#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/geometry/polygon.h"
#include "lab/verify/scenes/hall.h"

namespace muster {
namespace {

constexpr double kPictureWide = 920.0;  // Width of a picture [px].
constexpr std::size_t kMostPaths = 30;  // Greatest number of paths in a picture.

/// Distance of a point from the ground [m]; 0 on it.
double distanceFrom(const Region& ground, Vec2 p) {
    if (ground.contains(p)) return 0.0;
    double least = 1e9;
    for (const Polygon& ring : ground.rings()) least = std::min(least, closestOnBoundary(ring, p).distance);
    return least;
}

/// Writes shapes of the ground plane into a picture.
class Pencil {
public:
    explicit Pencil(const Box& box) : box_(box), scale_(kPictureWide / box.width()) {}

    std::string points(const std::vector<Vec2>& corners) const {
        std::string text;
        char number[48];
        for (const Vec2 p : corners) {
            std::snprintf(number, sizeof(number), "%.0f,%.0f ", (p.x - box_.min.x) * scale_,
                          (box_.max.y - p.y) * scale_);
            text += number;
        }
        return text;
    }
    std::string document(const std::string& body) const {
        const std::string wide = std::to_string(kPictureWide),
                          high = std::to_string(std::max(box_.height() * scale_, 8.0));
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + wide + "\" height=\"" + high +
               "\" viewBox=\"0 0 " + wide + " " + high + "\">" + body + "</svg>\n";
    }

private:
    Box box_;
    double scale_;
};

}  // namespace

Result<HallRun> HallRun::start(const Hall& hall, std::uint64_t seed) {
    WorldDef def = hall.def;
    def.seed = seed;
    auto world = World::create(def);
    if (!world.ok()) return world.status();
    HallRun run;
    run.world_ = std::move(world).value();
    run.ground_ = hall.ground();
    run.look();
    return run;
}

void HallRun::look() {
    const CharactersView all = world_->characters();
    const auto frame = static_cast<std::int32_t>(std::lround(world_->time() * kSightingRate));
    const Box box = ground_->box();
    for (std::size_t i = 0; i < all.size(); ++i) {
        sightings_.push_back({frame, all.id[i], all.position[i]});
        if (!world_->ring() || box.contains(all.position[i]))
            outside_ = std::max(outside_, distanceFrom(*ground_, all.position[i]));
    }
}

void HallRun::step(const std::function<void()>& watch) {
    world_->step();
    for (const Event& event : world_->events())
        if (event.kind == EventKind::Exited) leavings_.push_back({event.subject, {event.value}, time()});
    const double every = 1.0 / (kSightingRate * world_->parameters().stepTime);
    if (world_->stepCount() % static_cast<std::uint32_t>(std::lround(every)) == 0) look();
    if (watch) watch();
}

void HallRun::runUntil(double seconds, const std::function<void()>& watch) {
    while (present() > 0 && time() < seconds) step(watch);
}

void HallRun::runFor(double seconds, const std::function<void()>& watch) {
    while (time() < seconds) step(watch);
}

double HallRun::lastLeaving() const {
    return world_->characters().size() > 0 || leavings_.empty() ? kUnmeasured : leavings_.back().time;
}

Trajectories HallRun::trajectories() const {
    return Trajectories::create(kSightingRate, sightings_).value();
}

std::vector<Vec2> HallRun::evacuation() const {
    std::vector<Vec2> curve{{0.0, 0.0}};
    for (const Leaving& leaving : leavings_)
        curve.push_back({leaving.time, static_cast<double>(curve.size())});
    return curve;
}

void HallRun::report(VerifySample& sample, const SceneRun& run) const {
    sample.hash = world_->hash();
    sample.seconds = time();
    if (run.picture) sample.picture = draw();
}

std::string HallRun::draw() const {
    const Pencil pencil(ground_->box());
    std::string rings;
    for (const Polygon& ring : ground_->rings()) {
        Polygon closed = ring;
        rings += "M" + pencil.points(closed) + "Z";
    }
    std::string body =
        "<rect width=\"100%\" height=\"100%\" fill=\"#B8B2A6\"/><path fill=\"#FFFFFF\" "
        "fill-rule=\"evenodd\" d=\"" +
        rings + "\"/>";
    for (std::size_t k = 0; k < world_->areaCount(); ++k)
        body += "<polygon fill=\"#90FBC9\" points=\"" + pencil.points(world_->area(k).def.polygon) + "\"/>";
    for (const PatchId id : world_->patchIds())
        body += "<polygon fill=\"#E8DFA8\" points=\"" + pencil.points(world_->patch(id).outline) + "\"/>";
    const Trajectories all = trajectories();
    const std::size_t stride = std::max<std::size_t>(all.persons().size() / kMostPaths, 1);
    for (std::size_t who = 0; who < all.persons().size(); who += stride) {
        std::vector<Vec2> path;
        std::string paths;
        const auto rows = all.ofPerson(who);
        for (std::size_t k = 0; k < rows.size(); k += 10) {
            const Vec2 p = all.all()[rows[k]].position;
            // A person that comes in at the other side of a ring begins a new path.
            if (!path.empty() && distance(path.back(), p) > 3.0) {
                paths += "<polyline points=\"" + pencil.points(path) + "\"/>";
                path.clear();
            }
            if (path.empty() || distance(path.back(), p) > 0.1) path.push_back(p);
        }
        paths += "<polyline points=\"" + pencil.points(path) + "\"/>";
        static const char* const colours[] = {"#1D5FD1", "#C3123A", "#016553", "#8A5A00", "#6B3FA0"};
        body += "<g fill=\"none\" stroke-width=\"1.6\" stroke-opacity=\"0.7\" stroke=\"" +
                std::string(colours[(who / stride) % 5]) + "\">" + paths + "</g>";
    }
    return pencil.document(body);
}

}  // namespace muster
