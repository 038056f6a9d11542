// Meshes and touches that several formation tests share.
#pragma once

#include <doctest.h>

#include <cmath>

#include "base/archive.h"
#include "base/maths.h"
#include "base/random.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/mesh/rigid_fit.h"

namespace muster::test {

inline constexpr double kStep = 1.0 / 60.0;

inline Pose poseOf(double angle, Vec2 position) {
    return {position, {cosine(angle), sine(angle)}};
}

inline Formation square(std::int32_t count = 36) {
    return *makeFormation({}, count);
}

/// A mesh under controls, with a clock.
struct Stage {
    explicit Stage(const Formation& formation = square(), const Pose& pose = {}) {
        REQUIRE(mesh.reset(formation, pose).ok());
    }

    bool down(std::uint32_t touch, Vec2 p, std::uint32_t client = 1) {
        return controls.touchDown(parameters.input, client, touch, p, time, mesh.formation().mesh,
                                  mesh.userMesh());
    }
    bool move(std::uint32_t touch, Vec2 p, std::uint32_t client = 1) {
        return controls.touchMove(parameters.input, client, touch, p, time);
    }
    bool up(std::uint32_t touch, std::uint32_t client = 1) { return controls.touchUp(client, touch); }

    /// One step; returns the fastest vertex [m/s].
    double step(double pace = 1.0) {
        const std::vector<Vec2> before = mesh.userMesh();
        time += kStep;
        controls.advance(parameters.input, parameters.control, kStep, time, pace);
        const Status status = mesh.deform(parameters.mesh, parameters.control, controls, kStep);
        REQUIRE_MESSAGE(status.ok(), status.message());
        double fastest = 0.0;
        for (std::size_t v = 0; v < before.size() && v < mesh.userMesh().size(); ++v) {
            REQUIRE(isFinite(mesh.userMesh()[v]));
            fastest = std::max(fastest, distance(before[v], mesh.userMesh()[v]) / kStep);
        }
        return fastest;
    }
    double run(double seconds, double pace = 1.0) {
        double fastest = 0.0;
        for (int k = 0; k < static_cast<int>(seconds / kStep + 0.5); ++k)
            fastest = std::max(fastest, step(pace));
        return fastest;
    }
    Vec2 vertex(std::int32_t v) const { return mesh.userMesh()[v]; }
    std::int32_t nearest(Vec2 p) const {
        std::size_t best = 0;
        for (std::size_t v = 0; v < mesh.userMesh().size(); ++v)
            if (distance(mesh.userMesh()[v], p) < distance(mesh.userMesh()[best], p)) best = v;
        return static_cast<std::int32_t>(best);
    }
    /// The largest distance of a vertex from the rest shape best fitted to the mesh [m].
    double deviation() const {
        const Pose fit = bestRigidFit(mesh.formation().mesh.vertices, mesh.userMesh());
        double most = 0.0;
        for (std::size_t v = 0; v < mesh.userMesh().size(); ++v)
            most = std::max(most, distance(fit.apply(mesh.formation().mesh.vertices[v]), mesh.userMesh()[v]));
        return most;
    }

    Parameters parameters;
    ControlSet controls;
    FormationMesh mesh;
    double time = 0.0;
};

template <class T>
std::uint64_t hashOf(T& value) {
    Hasher hasher;
    hasher(value);
    return hasher.value();
}

}  // namespace muster::test
