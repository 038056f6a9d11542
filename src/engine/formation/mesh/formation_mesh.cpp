#include "engine/formation/mesh/formation_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "base/hash.h"
#include "engine/formation/mesh/rigid_fit.h"

namespace muster {
namespace {

// Slowest decay of a residual [m/s], so that it becomes exactly zero.
constexpr double kLeastDecay = 0.05;
constexpr double kFarthest = 1e9;  // Bound on coordinates that are loaded [m].

bool goodPose(const Pose& pose) {
    const Rotation& r = pose.rotation;
    return isFinite(pose.position) && std::fabs(r.c * r.c + r.s * r.s - 1.0) < 1e-9;
}

Status checkPlaces(const Formation& formation) {
    for (std::size_t k = 0; k < formation.places.size(); ++k) {
        const MeshPoint& place = formation.places[k];
        const double sum = place.weight[0] + place.weight[1] + place.weight[2];
        const bool good = place.triangle >= 0 &&
                          std::cmp_less(place.triangle, formation.mesh.triangles.size()) &&
                          std::fabs(sum - 1.0) < 1e-6 && std::fabs(place.weight[0]) < 1e3 &&
                          std::fabs(place.weight[1]) < 1e3;
        if (!good) return invalidArgument("place " + std::to_string(k) + " does not lie on the mesh");
    }
    return {};
}

void applyPose(const Pose& pose, const std::vector<Vec2>& rest, std::vector<Vec2>& out) {
    out.resize(rest.size());
    for (std::size_t v = 0; v < rest.size(); ++v) out[v] = pose.apply(rest[v]);
}

}  // namespace

bool FormationMesh::consistent() const {
    const std::size_t n = formation_.mesh.vertices.size();
    if (user_.size() != n || final_.size() != n || displacement_.size() != n || residual_.size() != n)
        return false;
    for (const Triangle& t : formation_.mesh.triangles)
        for (const std::int32_t v : t)
            if (v < 0 || std::cmp_greater_equal(v, n)) return false;
    for (const auto* points : {&formation_.mesh.vertices, &user_, &final_, &displacement_, &residual_})
        for (const Vec2 p : *points)
            if (!(std::fabs(p.x) <= kFarthest && std::fabs(p.y) <= kFarthest)) return false;
    return goodPose(pose_) && checkPlaces(formation_).ok() && ArapSolver::checkMesh(formation_.mesh).ok();
}

Status FormationMesh::reset(const Formation& formation, const Pose& pose) {
    if (!goodPose(pose))
        return invalidArgument("the formation's pose is not finite or its rotation not of unit length");
    Status status = checkPlaces(formation);
    if (status.ok()) status = ArapSolver::checkMesh(formation.mesh);
    if (!status.ok()) return status;
    solverReady_ = false;  // Only controls need it.
    formation_ = formation;
    pose_ = pose;
    applyPose(pose_, formation_.mesh.vertices, user_);
    final_ = user_;
    displacement_.assign(user_.size(), {});
    residual_.assign(user_.size(), {});
    constraintHash_ = 0;
    return {};
}

Status FormationMesh::change(const Formation& formation) {
    return changeFrom(*this, formation);
}

Status FormationMesh::changeFrom(const FormationMesh& other, const Formation& formation) {
    const std::vector<Vec2> oldFinal = other.final_;
    const std::vector<Vec2> oldDisplacement = other.displacement_;
    const Status status = reset(formation, other.pose_);
    if (!status.ok()) return status;
    const bool displaced = std::any_of(oldDisplacement.begin(), oldDisplacement.end(),
                                       [](Vec2 d) { return !(d == Vec2{}); });
    for (std::size_t v = 0; v < final_.size() && displaced; ++v) {
        std::size_t nearest = 0;
        for (std::size_t o = 1; o < oldFinal.size(); ++o)
            if (lengthSquared(oldFinal[o] - user_[v]) < lengthSquared(oldFinal[nearest] - user_[v]))
                nearest = o;
        displacement_[v] = oldDisplacement[nearest];
        final_[v] = user_[v] + displacement_[v];
    }
    return {};
}

void FormationMesh::keepCachesOf(FormationMesh& before) {
    const TriangleMesh& mesh = formation_.mesh;
    const TriangleMesh& old = before.formation_.mesh;
    if (!before.solverReady_ || mesh.vertices != old.vertices || mesh.triangles != old.triangles) return;
    std::swap(solver_, before.solver_);
    solverReady_ = true;
    before.solverReady_ = false;
}

void FormationMesh::setPose(const Pose& pose) {
    MUSTER_ASSERT(goodPose(pose));
    const Pose old = pose_;
    const auto move = [&](Vec2 p) { return pose.apply(old.applyInverse(p)); };
    for (Vec2& p : user_) p = move(p);
    for (Vec2& p : final_) p = move(p);
    for (Vec2& d : residual_) d = pose.rotation.apply(old.rotation.applyInverse(d));
    for (Vec2& d : displacement_) d = pose.rotation.apply(old.rotation.applyInverse(d));
    pose_ = pose;
}

void FormationMesh::recentre(Vec2 centre) {
    for (Vec2& v : formation_.mesh.vertices) v -= centre;
    pose_.position += pose_.rotation.apply(centre);
    solverReady_ = false;
    constraintHash_ = 0;
}

// The hash of the constraints: 0 without any; never 0 with some.
std::uint64_t FormationMesh::hashOfConstraints() const {
    if (hard_.empty() && soft_.empty()) return 0;
    Hash digest;
    digest.add(static_cast<std::uint32_t>(hard_.size()));
    for (const std::int32_t v : hard_) digest.add(v);
    for (const SoftConstraint& s : soft_) {
        digest.add(s.point.triangle);
        for (const double w : s.point.weight) digest.add(w);
        digest.add(s.weight);
    }
    return digest.value() | 1u;
}

// Computes the goal shape from the constraints.
Status FormationMesh::findGoal() {
    const std::vector<Vec2>& rest = formation_.mesh.vertices;
    if (hard_.size() + soft_.size() >= 2) {
        if (!solverReady_) {
            const Status set = solver_.setMesh(formation_.mesh);
            if (!set.ok()) return set;
            solverReady_ = true;
        }
        Status status = solver_.setConstraints(hard_, soft_);
        if (status.ok()) status = solver_.solve(hardTargets_, softTargets_, goal_);
        return status;
    }
    if (hard_.size() == 1) {
        const std::int32_t v = hard_[0];
        if (v < 0 || std::cmp_greater_equal(v, rest.size()))
            return invalidArgument("a control holds vertex " + std::to_string(v) +
                                   ", which the mesh does not have");
        pose_.position = hardTargets_[0] - pose_.rotation.apply(rest[v]);
    }
    applyPose(pose_, rest, goal_);
    if (hard_.size() == 1) goal_[hard_[0]] = hardTargets_[0];
    return {};
}

// The exponential decay, of which 2 % are left after relaxTime, between two bounds on the speed.
void FormationMesh::decayResidual(const Parameters::Mesh& mesh, double dt) {
    const double share = std::min(1.0, 4.0 * dt / std::max(mesh.relaxTime, 1e-9));
    for (Vec2& r : residual_) {
        const double size = length(r);
        if (size == 0.0) continue;
        const double step = std::min(std::max(size * share, kLeastDecay * dt), mesh.morphSpeed * dt);
        r = step >= size ? Vec2{} : r * (1.0 - step / size);
    }
}

Status FormationMesh::deform(const Parameters::Mesh& mesh, const Parameters::Control& control,
                             const ControlSet& controls, double dt) {
    controls.constraints(control, hard_, hardTargets_, soft_, softTargets_);
    const std::uint64_t hash = hashOfConstraints();
    // A released mesh keeps the pose that fits it best.
    const bool changed = hash != constraintHash_;
    if (changed && hard_.size() + soft_.size() < 2 && !user_.empty())
        pose_ = bestRigidFit(formation_.mesh.vertices, user_);
    const Status status = findGoal();
    if (!status.ok()) return status;
    if (changed) {
        for (std::size_t v = 0; v < goal_.size(); ++v) residual_[v] = user_[v] - goal_[v];
        // A held vertex follows its control without lag, unless it is too far from it.
        for (const std::int32_t v : hard_) {
            Vec2& r = residual_[v];
            if (length(r) <= mesh.morphSpeed * dt) r = {};
        }
        constraintHash_ = hash;
    }
    decayResidual(mesh, dt);
    for (std::size_t v = 0; v < goal_.size(); ++v) user_[v] = goal_[v] + residual_[v];
    if (hard_.size() + soft_.size() >= 2) pose_ = bestRigidFit(formation_.mesh.vertices, user_);
    return {};
}

namespace {

// Moves a vertex that lies inside obstacles to the nearest surface (SPEC M5). Where pieces overlap, the
// nearest surface of one may lie inside another, so this is repeated; a vertex that stays inside is projected
// onto the free space.
Vec2 leaveObstacles(const Environment& environment, Vec2 p) {
    if (environment.distanceToObstacle(p, 0.0) >= 0.0) return p;
    struct Deepest {
        Vec2 p;
        double depth = -1e-12;
        Vec2 surface;
    };
    for (int k = 0; k < 6; ++k) {
        Deepest deepest{p, -1e-12, p};
        environment.forPiecesNear(p, 0.0, [&deepest](const ObstaclePiece& piece) {
            const double d = piece.signedDistance(deepest.p);
            if (d >= deepest.depth) return;
            deepest.depth = d;
            deepest.surface = piece.closestSurface(deepest.p);
        });
        if (deepest.depth >= -1e-12) return p;
        p = deepest.surface;
    }
    return environment.distanceToObstacle(p) < -1e-9 ? environment.projectToFreeSpace(p, 0.0) : p;
}

}  // namespace

void FormationMesh::applyEnvironment(const Parameters::Field& field, const Environment& environment,
                                     double dt) {
    const double rate = std::min(1.0, 12.0 * dt);
    const double most = field.speed * dt;
    for (std::size_t v = 0; v < user_.size(); ++v) {
        Vec2& d = displacement_[v];
        if (!field.enabled) {
            d = {};
            final_[v] = user_[v];
            continue;
        }
        // The field is evaluated at the displaced vertex, so that it slides along walls.
        const Vec2 wanted = environment.potentialField(user_[v] + d) * field.gain;
        const Vec2 change = wanted - d;
        const double size = length(change);
        // At least a millimetre, so that the vertex comes to rest.
        const double step = std::min({size, std::max(size * rate, 1e-3), most});
        if (size > 0.0) d += change * (step / size);
        if (!isFinite(d)) d = {};
        final_[v] = leaveObstacles(environment, user_[v] + d);
    }
}

void FormationMesh::keepDisplacement() {
    for (std::size_t v = 0; v < user_.size(); ++v) final_[v] = user_[v] + displacement_[v];
}

void FormationMesh::placePositions(std::vector<Vec2>& positions) const {
    placesOn(final_, positions);
}

void FormationMesh::restPlaces(std::vector<Vec2>& positions) const {
    placesOn(formation_.mesh.vertices, positions);
}

void FormationMesh::heldPlaces(std::vector<Vec2>& positions) const {
    placesOn(user_, positions);
    for (Vec2& p : positions) p = pose_.applyInverse(p);
}

void FormationMesh::placesOn(const std::vector<Vec2>& vertices, std::vector<Vec2>& positions) const {
    positions.resize(formation_.places.size());
    for (std::size_t k = 0; k < positions.size(); ++k)
        positions[k] = formation_.places[k].position(formation_.mesh.triangles, vertices);
}

}  // namespace muster
