// The deformable mesh of one group: rest shape, user mesh Vu, final mesh Vf (paper sections 4.1 and 5; SPEC
// M2, M4, M5).
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/formation/control/control_set.h"
#include "engine/formation/mesh/arap.h"
#include "engine/formation/shapes/make_formation.h"
#include "engine/ground/environment/environment.h"
#include "muster/generated/parameters.h"

namespace muster {

/// The rest shape is the registered formation, never a deformed mesh. Vu is a goal shape, which the controls
/// give, plus a residual per vertex. When the set of constraints changes, the residual takes up the
/// difference, so that Vu is continuous in time; then it decays over about relaxTime, at most at morphSpeed.
/// Hard constraints have none.
class FormationMesh {
public:
    /// Sets a formation and the pose of its rest shape; the mesh stands there at once. Fails with
    /// InvalidArgument, changing nothing, where the mesh or a place is invalid or the pose is not finite.
    Status reset(const Formation& formation, const Pose& pose);
    /// Changes to another formation at the same pose. The vertices stand in their new rest placement at once,
    /// because the meshes have no common vertices. Displacements are taken from the nearest old vertices.
    /// Call ControlSet::rebind() afterwards. Fails, changing nothing, as reset().
    Status change(const Formation& formation);
    /// Takes a formation at the pose of another mesh, with its displacements, as change() does.
    Status changeFrom(const FormationMesh& other, const Formation& formation);
    /// Takes other places on the same mesh; none for a group without characters.
    void setPlaces(std::vector<MeshPoint> places) { formation_.places = std::move(places); }
    /// Makes `centre`, a point in the axes of the rest shape [m], its origin; nothing moves in the world.
    void recentre(Vec2 centre);
    /// Moves the whole mesh with its rest placement to another pose at once.
    void setPose(const Pose& pose);

    /// Computes Vu from the controls after `dt` [s]: two and more constraints by the ARAP solver; one
    /// translates the rest placement; with none the mesh relaxes to it. Fails, leaving Vu as it is, where the
    /// controls hold vertices of another mesh.
    Status deform(const Parameters::Mesh& mesh, const Parameters::Control& control,
                  const ControlSet& controls, double dt);
    /// Computes Vf after `dt` [s]: the potential field displaces each vertex at bounded speed, and vertices
    /// inside obstacles are moved to the nearest surface.
    void applyEnvironment(const Parameters::Field& field, const Environment& environment, double dt);
    /// Moves the final mesh along with the user mesh, with unchanged displacements.
    void keepDisplacement();

    const Formation& formation() const { return formation_; }      ///< Rest shape and places.
    const Pose& pose() const { return pose_; }                     ///< Pose of the rest shape.
    const std::vector<Vec2>& userMesh() const { return user_; }    ///< Vu [m].
    const std::vector<Vec2>& finalMesh() const { return final_; }  ///< Vf [m].
    /// Positions of all places on Vf [m].
    void placePositions(std::vector<Vec2>& positions) const;
    /// Positions of all places on the rest shape, in its axes [m].
    void restPlaces(std::vector<Vec2>& positions) const;
    /// Positions of all places on Vu, in the axes of the rest shape [m].
    void heldPlaces(std::vector<Vec2>& positions) const;

    /// Takes over the factorised systems of `before`, where the rest shape is the same. Call after reading an
    /// archive.
    void keepCachesOf(FormationMesh& before);

    /// Lets an archive read or write the state (not the solver: that is a cache).
    template <class Archive>
    void visit(Archive& archive) {
        archive(formation_, pose_, user_, final_, displacement_, residual_, constraintHash_);
        if constexpr (Archive::kReading) {
            solverReady_ = false;
            if (!consistent()) archive.fail();
        }
    }

private:
    bool consistent() const;
    void placesOn(const std::vector<Vec2>& vertices, std::vector<Vec2>& positions) const;
    std::uint64_t hashOfConstraints() const;
    Status findGoal();
    void decayResidual(const Parameters::Mesh& mesh, double dt);

    Formation formation_;
    Pose pose_;                         // Pose of the rest shape.
    std::vector<Vec2> user_;            // Vu [m].
    std::vector<Vec2> final_;           // Vf [m].
    std::vector<Vec2> displacement_;    // Displacement of each vertex by the environment [m].
    std::vector<Vec2> residual_;        // Vu minus the goal shape [m].
    std::uint64_t constraintHash_ = 0;  // Hash of the set of constraints; 0 for none.

    // Caches and working memory.
    ArapSolver solver_;
    bool solverReady_ = false;  // True where the solver has the mesh.
    std::vector<std::int32_t> hard_;
    std::vector<Vec2> hardTargets_;  // Targets of hard constraints [m].
    std::vector<SoftConstraint> soft_;
    std::vector<Vec2> softTargets_;  // Targets of soft constraints [m].
    std::vector<Vec2> goal_;         // Goal shape [m].
};

}  // namespace muster
