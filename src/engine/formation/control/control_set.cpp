#include "engine/formation/control/control_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/formation/control/control_points.h"

namespace muster {
namespace {

constexpr std::size_t kMaxControls = 64;  // Greatest number of controls on one mesh.
constexpr double kMaxDelay = 0.5;         // Greatest delay of a touch after its stamp [s].
// Greatest number of fingers of a client that are down at once on one mesh.
constexpr std::int32_t kMaxFingersPerClient = 32;
constexpr double kSupplementarySpacing = 1.0;  // Distance between supplementary points [m].

ControlKind kindFor(std::size_t points) {
    return points == 1 ? ControlKind::Point : points == 2 ? ControlKind::Line : ControlKind::Area;
}

bool anyDown(const Control& control) {
    return std::any_of(control.points.begin(), control.points.end(),
                       [](const ControlPoint& p) { return p.down; });
}

std::int32_t nearestVertex(std::span<const Vec2> vertices, Vec2 p) {
    std::size_t best = 0;
    for (std::size_t v = 1; v < vertices.size(); ++v)
        if (lengthSquared(vertices[v] - p) < lengthSquared(vertices[best] - p)) best = v;
    return static_cast<std::int32_t>(best);
}

ControlPoint holdVertex(std::int32_t vertex, std::uint32_t touch, Vec2 finger,
                        std::span<const Vec2> userVertices) {
    ControlPoint point;
    point.vertex = vertex;
    point.touch = touch;
    point.position = userVertices[vertex];
    point.offset = point.position - finger;
    return point;
}

// The point under a finger that is down, or null.
ControlPoint* findFinger(std::vector<Control>& controls, std::uint32_t client, std::uint32_t touch) {
    for (Control& control : controls) {
        if (control.client != client) continue;
        for (ControlPoint& point : control.points)
            if (point.down && point.touch == touch) return &point;
    }
    return nullptr;
}

std::int32_t fingersDown(const std::vector<Control>& controls, std::uint32_t client) {
    std::int32_t count = 0;
    for (const Control& control : controls) {
        if (control.client != client) continue;
        for (const ControlPoint& point : control.points) count += point.down ? 1 : 0;
    }
    return count;
}

// The control that holds a vertex, or null.
const Control* holderOf(const std::vector<Control>& controls, std::int32_t vertex) {
    for (const Control& control : controls)
        for (const ControlPoint& point : control.points)
            if (point.vertex == vertex) return &control;
    return nullptr;
}

// Ends the control that holds a vertex if it was lifted and only follows the rest of its trajectories. False
// where a finger or a pinned control holds the vertex.
bool freeVertex(std::vector<Control>& controls, std::int32_t vertex) {
    const Control* holder = holderOf(controls, vertex);
    if (holder == nullptr) return true;
    if (holder->pinned || anyDown(*holder)) return false;
    controls.erase(controls.begin() + (holder - controls.data()));
    return true;
}

// True where the control ends in the next step.
bool hasEnded(const Control& control) {
    if (control.pinned) return false;
    return std::none_of(control.points.begin(), control.points.end(),
                        [](const ControlPoint& p) { return p.down || !p.trajectory.empty(); });
}

bool isMeshOf(const TriangleMesh& rest, std::span<const Vec2> vertices) {
    return !vertices.empty() && rest.vertices.size() == vertices.size();
}

}  // namespace

bool ControlSet::touchDown(const Parameters::Input& input, std::uint32_t client, std::uint32_t touch,
                           Vec2 position, double time, const TriangleMesh& rest,
                           std::span<const Vec2> finalVertices, std::span<const Vec2> userVertices) {
    if (userVertices.empty()) userVertices = finalVertices;
    if (!isFinite(position) || !std::isfinite(time) || !isMeshOf(rest, finalVertices) ||
        !isMeshOf(rest, userVertices))
        return false;
    if (findFinger(controls_, client, touch) != nullptr) return false;
    if (fingersDown(controls_, client) >= kMaxFingersPerClient) return false;
    const std::int32_t vertex = nearestVertex(finalVertices, position);
    if (!freeVertex(controls_, vertex)) return false;
    const ControlPoint point = holdVertex(vertex, touch, position, userVertices);
    for (Control& control : controls_) {
        const bool joins = control.open && control.client == client && anyDown(control) &&
                           std::fabs(time - control.startTime) <= input.window;
        if (!joins) continue;
        control.points.push_back(point);
        control.kind = kindFor(control.points.size());
        sampleSupplementary(control, rest, kSupplementarySpacing);
        return true;
    }
    if (controls_.size() >= kMaxControls) return false;
    Control control;
    control.id = ControlId{nextId_++};
    control.client = client;
    control.startTime = time;
    control.clock = time;
    control.points.push_back(point);
    controls_.push_back(std::move(control));
    return true;
}

bool ControlSet::addControl(std::uint32_t client, ControlKind kind, std::span<const std::uint32_t> touches,
                            std::span<const Vec2> positions, double time, const TriangleMesh& rest,
                            std::span<const Vec2> finalVertices, std::span<const Vec2> userVertices) {
    if (userVertices.empty()) userVertices = finalVertices;
    const std::size_t n = positions.size();
    if (n == 0 || touches.size() != n || kindFor(n) != kind || !std::isfinite(time) ||
        !isMeshOf(rest, finalVertices) || !isMeshOf(rest, userVertices))
        return false;
    if (std::cmp_greater(n + fingersDown(controls_, client), kMaxFingersPerClient)) return false;
    Control control;
    for (std::size_t k = 0; k < n; ++k) {
        if (!isFinite(positions[k]) || findFinger(controls_, client, touches[k]) != nullptr) return false;
        const std::int32_t vertex = nearestVertex(finalVertices, positions[k]);
        const Control* holder = holderOf(controls_, vertex);
        if (holder != nullptr && (holder->pinned || anyDown(*holder))) return false;
        for (const ControlPoint& other : control.points)
            if (other.vertex == vertex || other.touch == touches[k]) return false;
        control.points.push_back(holdVertex(vertex, touches[k], positions[k], userVertices));
    }
    for (const ControlPoint& point : control.points) freeVertex(controls_, point.vertex);
    if (controls_.size() >= kMaxControls) return false;
    control.id = ControlId{nextId_++};
    control.kind = kind;
    control.client = client;
    control.open = false;
    control.startTime = time;
    control.clock = time;
    sampleSupplementary(control, rest, kSupplementarySpacing);
    controls_.push_back(std::move(control));
    return true;
}

bool ControlSet::touchMove(const Parameters::Input& input, std::uint32_t client, std::uint32_t touch,
                           Vec2 position, double time) {
    if (!isFinite(position) || !std::isfinite(time)) return false;
    ControlPoint* point = findFinger(controls_, client, touch);
    if (point == nullptr) return false;
    extendTrajectory(*point, position + point->offset, time, input.checkpointSpacing);
    return true;
}

bool ControlSet::touchUp(std::uint32_t client, std::uint32_t touch) {
    ControlPoint* point = findFinger(controls_, client, touch);
    if (point == nullptr) return false;
    point->down = false;
    return true;
}

bool ControlSet::touchCancel(std::uint32_t client, std::uint32_t touch) {
    for (std::size_t k = 0; k < controls_.size(); ++k) {
        if (controls_[k].client != client) continue;
        for (const ControlPoint& point : controls_[k].points) {
            if (!point.down || point.touch != touch) continue;
            controls_.erase(controls_.begin() + static_cast<std::ptrdiff_t>(k));
            return true;
        }
    }
    return false;
}

void ControlSet::releaseClient(std::uint32_t client) {
    for (Control& control : controls_) {
        if (control.client != client) continue;
        for (ControlPoint& point : control.points) point.down = false;
    }
}

bool ControlSet::setPinned(ControlId id, bool pinned) {
    for (Control& control : controls_) {
        if (control.id != id) continue;
        control.pinned = pinned;
        return true;
    }
    return false;
}

bool ControlSet::remove(ControlId id) {
    const auto found = std::find_if(controls_.begin(), controls_.end(),
                                    [&](const Control& c) { return c.id == id; });
    if (found == controls_.end()) return false;
    controls_.erase(found);
    return true;
}

void ControlSet::clear() {
    controls_.clear();
}

bool ControlSet::advance(const Parameters::Input& input, const Parameters::Control& def, double dt,
                         double now, double pace) {
    // A control that reached its end in the last step has been shown there, and ends now.
    const std::size_t before = controls_.size();
    std::erase_if(controls_, hasEnded);
    const double reach = std::isfinite(pace) ? def.speed * std::clamp(pace, 0.0, 1.0) * dt : 0.0;
    for (Control& control : controls_) {
        if (control.joinDeadline < 0.0) control.joinDeadline = now + input.window + kMaxDelay;
        if (now > control.joinDeadline) control.open = false;
        control.clock = std::min(control.clock, now);
        const double until = std::max(control.clock, std::min(now, control.clock + def.clockRate * dt));
        double reached = until;
        for (const ControlPoint& point : control.points)
            reached = std::min(reached, latestReachable(point, control.clock, until, reach));
        for (ControlPoint& point : control.points) followTrajectory(point, control.clock, reached, reach);
        control.clock = reached;
    }
    return controls_.size() != before;
}

void ControlSet::rebind(const TriangleMesh& rest, std::span<const Vec2> vertices) {
    if (!isMeshOf(rest, vertices)) {
        clear();
        return;
    }
    std::vector<std::uint8_t> taken(vertices.size(), 0);
    for (Control& control : controls_) {
        std::erase_if(control.points, [&](ControlPoint& point) {
            point.vertex = nearestVertex(vertices, point.position);
            return std::exchange(taken[point.vertex], std::uint8_t{1}) != 0;
        });
        if (control.points.empty()) continue;
        control.kind = kindFor(control.points.size());
        sampleSupplementary(control, rest, kSupplementarySpacing);
    }
    std::erase_if(controls_, [](const Control& control) { return control.points.empty(); });
}

void ControlSet::constraints(const Parameters::Control& def, std::vector<std::int32_t>& hard,
                             std::vector<Vec2>& hardTargets, std::vector<SoftConstraint>& soft,
                             std::vector<Vec2>& softTargets) const {
    hard.clear();
    hardTargets.clear();
    soft.clear();
    softTargets.clear();
    for (const Control& control : controls_) {
        for (const ControlPoint& point : control.points) {
            hard.push_back(point.vertex);
            hardTargets.push_back(point.position);
        }
        const std::size_t columns = control.points.size();
        for (std::size_t k = 0; k < control.supplementary.size(); ++k) {
            Vec2 target;
            for (std::size_t c = 0; c < columns; ++c)
                target += control.points[c].position * control.weights[k * columns + c];
            soft.push_back({control.supplementary[k], def.softWeight});
            softTargets.push_back(target);
        }
    }
}

}  // namespace muster
