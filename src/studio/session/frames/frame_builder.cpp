#include "studio/session/frames/frame_builder.h"

#include <algorithm>
#include <cmath>

#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/standings.h"
#include "muster/order.h"
#include "muster/views.h"

namespace muster {
namespace {

constexpr std::size_t kSwapWindow = 120;  // Number of steps that the swap rate averages over.

float narrow(double value) {
    return static_cast<float>(value);
}

void appendPoint(std::vector<float>& list, Vec2 p) {
    list.push_back(narrow(p.x));
    list.push_back(narrow(p.y));
}

void fillPoints(std::vector<float>& list, std::span<const Vec2> points) {
    list.clear();
    list.reserve(2 * points.size());
    for (const Vec2 p : points) appendPoint(list, p);
}

protocol::ControlFrame controlFrame(const Control& control, const FormationMesh& mesh) {
    protocol::ControlFrame frame;
    frame.id = control.id.value;
    frame.kind = control.kind;
    frame.client = control.client;
    frame.pinned = control.pinned;
    frame.open = control.open;
    for (const ControlPoint& point : control.points) {
        protocol::ControlPointFrame& out = frame.points.emplace_back();
        out.touch = point.touch;
        out.down = point.down;
        out.x = narrow(point.position.x);
        out.y = narrow(point.position.y);
        for (const Checkpoint& checkpoint : point.trajectory) appendPoint(out.path, checkpoint.position);
    }
    for (const MeshPoint& point : control.supplementary)
        appendPoint(frame.supplementary, point.position(mesh.formation().mesh.triangles, mesh.finalMesh()));
    return frame;
}

/// The queue and the conduct of a group.
void fillOrders(const GroupView& view, protocol::GroupFrame& frame) {
    frame.x = narrow(view.pose.position.x);
    frame.y = narrow(view.pose.position.y);
    frame.facing = narrow(std::atan2(view.pose.rotation.s, view.pose.rotation.c));
    frame.orders.assign(view.orders.begin(), view.orders.end());
    fillPoints(frame.way, view.way);
    frame.held = view.held;
    frame.patrols = view.patrols;
    frame.stance = view.conduct.stance;
    frame.cohesion = narrow(view.conduct.cohesion);
    frame.squeeze = narrow(view.conduct.squeeze);
    frame.avoids = view.conduct.avoids;
}

void fillGroup(const World& world, std::size_t group, protocol::GroupFrame& frame) {
    const GroupView view = world.group(group);
    frame.id = view.id.value;
    frame.meshVersion = view.formationVersion;
    frame.lag = narrow(view.meanLag);
    frame.walkSum = narrow(view.walk.sum);
    frame.walkSquares = narrow(view.walk.squares);
    frame.walkLongest = narrow(view.walk.longest);
    fillPoints(frame.vertices, view.finalMesh);
    fillOrders(view, frame);
    frame.controls.clear();
    for (const Control& control : world.group(group).controls)
        frame.controls.push_back(controlFrame(control, inspect::mesh(world, group)));
}

protocol::MovingFrame movingFrame(protocol::MovingKind kind, std::uint32_t id, const Waypoint& at) {
    return {kind, id, narrow(at.position.x), narrow(at.position.y), narrow(at.angle)};
}

void fillMoving(const Environment& environment, std::vector<protocol::MovingFrame>& moving) {
    moving.clear();
    const double time = environment.time();
    for (const ObstacleId id : environment.obstacleIds()) {
        const TimedPath& path = environment.obstacle(id)->path;
        if (!path.still())
            moving.push_back(movingFrame(protocol::MovingKind::Obstacle, id.value, path.at(time)));
    }
    for (const PatchId id : environment.patchIds()) {
        const TimedPath& path = environment.patch(id)->path;
        if (!path.still())
            moving.push_back(movingFrame(protocol::MovingKind::Patch, id.value, path.at(time)));
    }
}

void fillAreas(const World& world, std::vector<protocol::AreaFrame>& areas) {
    areas.clear();
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        const AreaView area = world.area(a);
        areas.push_back({area.id.value, area.count.passed, area.count.waiting});
    }
}

/// Classes and radii; empty where nobody has another than the usual one.
void fillBodies(const World& world, protocol::Frame& frame) {
    const std::span<const Body> bodies = world.characters().body;
    const auto usual = [](const Body& body) { return body.radius == 0.0; };
    const auto ofNone = [](const Body& body) { return body.unitClass == 0; };
    frame.unitClass.clear();
    frame.radius.clear();
    if (!std::all_of(bodies.begin(), bodies.end(), ofNone))
        for (const Body& body : bodies) frame.unitClass.push_back(body.unitClass);
    if (std::all_of(bodies.begin(), bodies.end(), usual)) return;
    const double radius = world.parameters().character.radius;
    for (const Body& body : bodies) {
        const double own = body.radius > 0.0 ? body.radius : radius;
        frame.radius.push_back(static_cast<std::uint8_t>(std::clamp(std::round(100.0 * own), 1.0, 255.0)));
    }
}

}  // namespace

void FrameBuilder::restart() {
    swaps_.assign(kSwapWindow, 0);
    swapSum_ = 0;
    observed_ = 0;
    slowestStep_ = 0.0;
}

void FrameBuilder::observe(const World& world) {
    std::uint32_t swaps = 0;
    for (const Event& event : world.events()) swaps += event.kind == EventKind::Swap ? 1u : 0u;
    std::uint32_t& slot = swaps_[observed_++ % kSwapWindow];
    swapSum_ += swaps;
    swapSum_ -= slot;
    slot = swaps;
    const double took = world.stageTimes().total;
    slowestStep_ = stepsReported_ ? took : std::max(slowestStep_, took);
    stepsReported_ = false;
}

void FrameBuilder::buildCharacters(const World& world, protocol::Frame& frame,
                                   std::span<const ShownCharacter> shown) {
    const CharactersView characters = world.characters();
    const std::size_t count = characters.size();
    positions_.assign(characters.position.begin(), characters.position.end());
    std::size_t at = 0;
    for (const ShownCharacter& one : shown) {
        while (at < count && characters.id[at] < one.id) ++at;
        if (at < count && characters.id[at] == one.id && one.moved) positions_[at] = one.position;
    }
    crowd_.place(positions_);
    frame.ids.assign(characters.id.begin(), characters.id.end());
    frame.group.resize(count);
    for (std::size_t i = 0; i < count; ++i) frame.group[i] = static_cast<std::uint16_t>(characters.group[i]);
    fillBodies(world, frame);
    if (frame.ids == ids_ && frame.group == groups_ && frame.unitClass == classes_ && frame.radius == radii_)
        return;
    ids_ = frame.ids;
    groups_ = frame.group;
    classes_ = frame.unitClass;
    radii_ = frame.radius;
    ++idsVersion_;
}

double FrameBuilder::lagP95(const World& world) {
    const CharactersView characters = world.characters();
    lags_.clear();
    for (std::size_t i = 0; i < characters.size(); ++i) {
        if (characters.place[i] < 0) continue;
        const std::span<const Vec2> places = inspect::places(world, characters.group[i]).positions();
        const auto place = static_cast<std::size_t>(characters.place[i]);
        if (place < places.size()) lags_.push_back(narrow(distance(characters.position[i], places[place])));
    }
    if (lags_.empty()) return 0.0;
    const std::size_t rank = (lags_.size() * 95 + 99) / 100 - 1;
    std::nth_element(lags_.begin(), lags_.begin() + static_cast<std::ptrdiff_t>(rank), lags_.end());
    return lags_[rank];
}

void FrameBuilder::build(const World& world, protocol::Frame& frame, std::span<const ShownCharacter> shown) {
    frame.step = world.stepCount();
    frame.time = world.time();
    buildCharacters(world, frame, shown);
    frame.groups.resize(world.groupCount());
    places_.resize(world.groupCount());
    const std::vector<StandingCounts> standings = countStandings(world);
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        fillGroup(world, g, frame.groups[g]);
        places_[g].take(world, g);
        frame.groups[g].standings.assign(standings[g].begin(), standings[g].end());
    }
    fillMoving(inspect::environment(world), frame.moving);
    frame.collected.assign(world.collected().begin(), world.collected().end());
    fillAreas(world, frame.areas);
    frame.stepMs = narrow(slowestStep_);
    stepsReported_ = true;
    frame.lagP95 = narrow(lagP95(world));
    const double seconds = static_cast<double>(std::min(observed_, kSwapWindow)) *
                           world.parameters().stepTime;
    const double shares = seconds * static_cast<double>(world.characters().size());
    frame.swapsPerSecond = shares > 0.0 ? narrow(static_cast<double>(swapSum_) / shares) : 0.0f;
}

protocol::GroupMesh buildGroupMesh(const World& world, std::size_t index) {
    const GroupView group = world.group(index);
    const Formation& formation = inspect::mesh(world, index).formation();
    protocol::GroupMesh message;
    message.group = group.id.value;
    message.version = group.formationVersion;
    message.formation = std::string(formationName(group.formation));
    message.spacing = narrow(inspect::groupDef(world, index).formation.spacing);
    fillPoints(message.rest, group.restMesh);
    const TriangleMesh& mesh = formation.mesh;
    for (const MeshPoint& place : formation.places) {
        message.placeTriangles.push_back(static_cast<std::uint32_t>(place.triangle));
        message.placeWeights.push_back(narrow(place.weight[0]));
        message.placeWeights.push_back(narrow(place.weight[1]));
    }
    for (const Triangle& triangle : mesh.triangles)
        for (const std::int32_t vertex : triangle)
            message.triangles.push_back(static_cast<std::uint32_t>(vertex));
    for (const auto& loop : boundaryLoops(mesh)) {
        message.boundary.push_back(static_cast<std::uint32_t>(loop.size()));
        for (const std::int32_t vertex : loop) message.boundary.push_back(static_cast<std::uint32_t>(vertex));
    }
    return message;
}

void appendEvents(const World& world, std::vector<protocol::EventFrame>& events) {
    for (const Event& event : world.events()) {
        // A large crowd has many swaps; a frame holds their rate instead.
        if (event.kind == EventKind::Swap) continue;
        events.push_back(
            {event.kind, event.subject, event.value, narrow(event.position.x), narrow(event.position.y)});
    }
}

}  // namespace muster
