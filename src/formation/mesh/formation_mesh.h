// The deformable mesh of one group: rest shape, user mesh Vu, environment, final mesh Vf (SPEC M2, M4, M5).
#pragma once

#include <cstdint>
#include <vector>

#include "environment/environment.h"
#include "formation/control/control_set.h"
#include "formation/mesh/arap.h"
#include "formation/shapes/formation.h"

namespace muster {

/// How the mesh gives way and comes back.
struct FormationMeshDef {
    double relaxTime = 1.0;        ///< To return to the rest shape after the last control [s] > 0.
    bool environmentField = true;  ///< Potential field and contact displace vertices.
    double fieldGain = 1.0;        ///< Displacement per unit of field [m].
    double fieldSpeed = 1.5;       ///< Bound on the change of a vertex's displacement [m/s] > 0.
    double morphSpeed = 3.0;       ///< Bound on vertex speed while relaxing or changing formation [m/s] > 0.
};

/// Vertices and what they remember. The rest shape is the registered formation, never a deformed mesh.
/// Vu is a goal shape, which the controls give, plus a residual per vertex. Whenever the set of
/// constraints or the formation changes, the residual takes up the difference, so that Vu is continuous
/// in time; then it decays over about relaxTime, at most at morphSpeed. Held vertices have none.
class FormationMesh {
public:
    /// Takes a formation at a placement; the mesh stands there at once. Fails with InvalidArgument,
    /// changing nothing, where the mesh or a place is bad or the pose is not finite.
    Status reset(const Formation& formation, const Pose& pose);
    /// Changes to another formation, best fitted where the mesh stands (its orientation is kept). The
    /// vertices stand in their new rest placement at once, because meshes have no common vertices: the
    /// characters make the way by the plan. Displacements go over from the nearest old vertices.
    /// Call ControlSet::rebind afterwards. Fails, changing nothing, as reset().
    Status change(const Formation& formation);
    /// Moves the whole mesh, rest placement and all, to another pose at once.
    void place(const Pose& pose);

    /// Computes Vu from the controls: two and more constraints by the ARAP solver; one translates the
    /// rest placement; none relaxes to the rest shape best fitted where it stands. Fails only where the
    /// controls are bound to another mesh (Vu then stays).
    Status deform(const FormationMeshDef& def, const ControlDef& controlDef, const ControlSet& controls,
                  double dt);
    /// Computes Vf: the potential field displaces each vertex at bounded speed, decays where none acts,
    /// and vertices inside obstacles move to the nearest surface.
    void meet(const FormationMeshDef& def, const Environment& environment, double dt);

    const Formation& formation() const { return formation_; }      ///< Rest shape and places.
    const Pose& pose() const { return pose_; }                     ///< Pose of the rest shape.
    const std::vector<Vec2>& userMesh() const { return user_; }    ///< Vu [m].
    const std::vector<Vec2>& finalMesh() const { return final_; }  ///< Vf [m].
    /// Positions of all places on Vf [m].
    void placePositions(std::vector<Vec2>& positions) const;

    /// Lets an archive read or write the state (not the solver: that is a cache).
    template <class Archive>
    void visit(Archive& archive) {
        archive(formation_, pose_.position, pose_.rotation.c, pose_.rotation.s, user_, final_, displacement_,
                residual_, constraintKey_);
        if constexpr (Archive::kReading) {
            solverReady_ = false;
            if (!consistent()) archive.fail();
        }
    }

private:
    bool consistent() const;
    std::uint64_t keyOfConstraints() const;
    Status findGoal();
    void decayResidual(const FormationMeshDef& def, double dt);

    Formation formation_;
    Pose pose_;
    std::vector<Vec2> user_;
    std::vector<Vec2> final_;
    std::vector<Vec2> displacement_;   ///< Of each vertex by the environment [m].
    std::vector<Vec2> residual_;       ///< Vu minus its goal [m].
    std::uint64_t constraintKey_ = 0;  ///< Tells one set of constraints from another.
    ArapSolver solver_;
    bool solverReady_ = false;
    std::vector<std::int32_t> hard_;  // Working memory.
    std::vector<Vec2> hardTargets_;
    std::vector<SoftConstraint> soft_;
    std::vector<Vec2> softTargets_;
    std::vector<Vec2> goal_;
};

}  // namespace muster
