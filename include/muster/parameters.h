// Parameters of a world: every number that researchers and users may change.
#pragma once

#include <cstdint>

namespace muster {

/// How often places are assigned to characters.
enum class PlanMode : std::uint8_t {
    Transport = 0,     ///< In every period.
    AssignedOnce = 1,  ///< At the start and after each change of formation.
    Fixed = 2,         ///< Never: character i has place i.
};

/// Which method makes plans.
enum class PlanSolver : std::uint8_t {
    Exact = 0,  ///< The reference: one cost field per place and an exact assignment.
    Fast = 1,   ///< Near-optimal, for large crowds: landmark fields and a dynamic assignment.
};

/// What a plan minimises.
enum class PlanObjective : std::uint8_t {
    Power = 0,        ///< The sum of cost^p, p by Parameters::Plan::exponent.
    LongestWalk = 1,  ///< The cost of the costliest pair first, then the sum of cost^p.
};

/// The definition of a world's behaviour. The defaults are the preset `units`. Ranges are those of
/// parameterTable(), which also has the name of each field in files and messages: "plan.exponent".
struct Parameters {
    /// Touches and drawn trajectories (SPEC U1 to U3).
    struct Input {
        double window = 0.15;  ///< Touches that begin within this time form one control [s], 0 to 2.
        double reach = 1.5;    ///< A touch farther than this from every mesh has no effect [m], 0 to 100.
        double checkpointSpacing = 0.5;  ///< Distance between checkpoints of a trajectory [m], 0.01 to 100.
    };

    /// Control points (SPEC U4, U5).
    struct Control {
        double speed = 1.6;      ///< Top speed of control points [m/s], 0.01 to 100.
        double clockRate = 4.0;  ///< Largest number of drawing seconds followed per second, 1 to 100.
        /// Weight of supplementary points against the mesh's own stiffness, 1e-6 to 1e6.
        double softWeight = 6.0;
    };

    /// The opposing force: the mesh waits for a crowd that falls behind (SPEC U6).
    struct Opposing {
        bool enabled = true;  ///< False: the mesh does not wait for characters.
        double gain = 0.35;   ///< Share of control speed lost per metre of mean lag [1/m], 0 to 100.
    };

    /// The deformable mesh (SPEC M2, M4).
    struct Mesh {
        double relaxTime = 1.0;   ///< Time to return to the rest shape without controls [s], 0.01 to 60.
        double morphSpeed = 3.0;  ///< Top vertex speed while it relaxes or changes [m/s], 0.01 to 100.
    };

    /// The potential field by which obstacles bend meshes (SPEC M5; paper eq. 1).
    struct Field {
        bool enabled = true;    ///< False: obstacles do not displace vertices.
        double range = 1.5;     ///< Range of obstacles that do not define one [m], 0 to 100.
        double strength = 1.0;  ///< Strength of obstacles that do not define one, 0 to 100.
        double gain = 1.0;      ///< Displacement of a vertex per unit of field [m], 0 to 100.
        double speed = 1.5;     ///< Top rate of change of a vertex's displacement [m/s], 0.01 to 100.
    };

    /// Travelling places (SPEC M5).
    struct Place {
        double speed = 2.0;       ///< Top speed [m/s], 0.01 to 100; multiplied by the ground's travel speed.
        double clearance = 0.02;  ///< Distance to obstacles beyond the characters' radius [m], 0 to 1.5.
    };

    /// The unit cost (SPEC A3; paper eq. 7).
    struct Cost {
        double alpha = 0.5;      ///< Weight of path length, 0 to 1000; alpha + beta is at least 0.01.
        double beta = 0.5;       ///< Weight of time, 0 to 1000.
        double gamma = 1.0;      ///< Weight of discomfort, 0 to 1000.
        double minSpeed = 0.05;  ///< Floor of the speed in a crowd, relative to the free speed, 0.001 to 1.
    };

    /// What the density of the crowd adds to the unit cost (SPEC A4).
    struct Density {
        bool enabled = true;     ///< False: density does not raise the unit cost.
        double cell = 1.0;       ///< Edge of a density cell [m], 0.1 to 100.
        double lambda = 1.0;     ///< Exponent of the shares that a character gives to cells, 0.1 to 10.
        double min = 1.3;        ///< Density below which the speed is the free speed [1/m^2], 0 to 100.
        double max = 3.5;        ///< Density above which the speed is that of the flow [1/m^2], above `min`.
        double lookAhead = 0.5;  ///< Distance ahead at which density is sampled [m], 0 to 10.
    };

    /// What moving obstacles add to the unit cost (SPEC A5).
    struct Discomfort {
        bool enabled = true;  ///< False: moving obstacles do not raise the unit cost.
        double time = 1.5;    ///< Time over which obstacles are predicted [s], 0 to 60.
        double range = 1.0;   ///< Reach beyond the swept surface [m], 0.01 to 100.
        double gain = 8.0;    ///< Largest discomfort: at the obstacle itself, now; 0 to 1000.
    };

    /// Planning: the assignment of places (SPEC A1).
    struct Plan {
        PlanMode mode = PlanMode::Transport;             ///< How often places are assigned.
        PlanSolver solver = PlanSolver::Fast;            ///< Which method makes plans.
        PlanObjective objective = PlanObjective::Power;  ///< What they minimise.
        std::int32_t period = 0;        ///< Steps from plan to plan, 1 to 600; 0 for the solver's default.
        double exponent = 2.0;          ///< Exponent p, 1 to 8: 1 for least sum, 2 for least squares.
        double threshold = 0.02;        ///< Commit threshold: least gain of an exchange [cost^p], 0 to 1e9.
        double thresholdShare = 0.003;  ///< Least gain as a share of the cost of its moves, 0 to 1.
        bool geodesic = true;           ///< False: costs are straight-line distances.
        bool waits = true;  ///< False: nobody goes round because many wait before a passage (SPEC A8).
    };

    /// The characters (SPEC A6).
    struct Character {
        double radius = 0.25;        ///< Radius of the body [m], 0.05 to 1.5.
        double maxSpeed = 2.0;       ///< Top speed in the open [m/s], 0.01 to 50.
        double acceleration = 10.0;  ///< Top acceleration [m/s^2], 0.01 to 1000.
        double velocityGain = 12.0;  ///< Gain of the PD controller on velocity [1/s], 0 to 60.
        double positionGain = 3.0;   ///< Gain of the PD controller on distance [1/s], 0 to 60.
        /// Distance to its place below which it walks straight there if the line is clear [m], 0 to 100.
        double directReach = 1.5;
        double headway = 0.2;  ///< Time that it keeps from who is ahead [s], 0.02 to 5.
        double inStep = 1.0;   ///< Share of the speed ahead that it walks on top of that, 0 to 1: 1 in step.
        double foresight = 1.0;  ///< Time for which it keeps clear of who comes towards it [s], 0.1 to 10.
    };

    /// Contacts between characters (SPEC A6).
    struct Contact {
        std::int32_t iterations = 8;  ///< Iterations of contact resolution per step, 1 to 100.
    };

    double stepTime = 1.0 / 60.0;  ///< Simulated time of one step [s], 1/240 to 1/10; "time.step".
    Input input;                   ///< Touches and drawn trajectories.
    Control control;               ///< Control points.
    Opposing opposing;             ///< Slows the mesh when the crowd falls behind.
    Mesh mesh;                     ///< The deformable mesh.
    Field field;                   ///< Deformation of meshes by obstacles.
    Place place;                   ///< Travelling places.
    Cost cost;                     ///< The unit cost.
    Density density;               ///< Cost of crowded ground.
    Discomfort discomfort;         ///< Cost of ground ahead of moving obstacles.
    Plan plan;                     ///< The assignment of places.
    Character character;           ///< Motion of characters.
    Contact contact;               ///< Resolution of overlaps.
};

}  // namespace muster
