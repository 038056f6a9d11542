// Made by schema/generate.mjs from schema/parameters.txt: change these, not this file.
// Parameters of a world: every number that researchers and users may change.
#pragma once

#include <cstdint>

namespace muster {

/// How often places are assigned to characters.
enum class PlanMode : std::uint8_t {
    Transport,     ///< In every period.
    AssignedOnce,  ///< At the start and after each change of formation.
    Fixed,         ///< Never: character i has place i.
};

/// Which method makes plans.
enum class PlanSolver : std::uint8_t {
    Exact,  ///< The reference: one cost field per place and an exact assignment.
    Fast,   ///< Near-optimal, for large crowds: landmark fields and a dynamic assignment.
};

/// What a plan minimises.
enum class PlanObjective : std::uint8_t {
    Power,        ///< The sum of cost^p, p by Parameters::Plan::exponent.
    LongestWalk,  ///< The cost of the costliest pair first, then the sum of cost^p.
};

/// The definition of a world's behaviour. The defaults are the preset `units`. parameterTable() has the
/// name of each field in files and messages: "plan.exponent".
struct Parameters {
    /// Touches and drawn trajectories (SPEC U1 to U3).
    struct Input {
        double window = 0.15;            ///< Touches that begin within it form one control [s]; 0 to 2.
        double reach = 1.5;              ///< A touch farther than this from every mesh holds nothing [m]; 0
                                         ///< to 100.
        double checkpointSpacing = 0.5;  ///< Distance between checkpoints of a drawn path [m]; 0.01 to 100.
    };

    /// Control points (SPEC U4, U5).
    struct Control {
        double speed = 1.6;       ///< Top speed of control points along their paths [m/s]; 0.01 to 100.
        double clockRate = 4.0;   ///< Drawing seconds followed per second when catching up, at most; 1 to
                                  ///< 100.
        double softWeight = 6.0;  ///< Weight of supplementary points against the mesh's own stiffness; 1e-6
                                  ///< to 1e6.
    };

    /// The opposing force: the mesh waits for a crowd that falls behind (SPEC U6).
    struct Opposing {
        bool enabled = true;  ///< The mesh waits for a crowd that falls behind.
        double gain = 0.35;   ///< Share of control speed lost per metre of mean lag [1/m]; 0 to 100.
    };

    /// The deformable mesh (SPEC M2, M4).
    struct Mesh {
        double relaxTime = 1.0;   ///< Time in which a mesh without controls returns to its rest shape [s];
                                  ///< 0.01 to 60.
        double morphSpeed = 3.0;  ///< Top vertex speed while relaxing or changing formation [m/s]; 0.01 to
                                  ///< 100.
    };

    /// The potential field by which obstacles bend meshes (SPEC M5; paper eq. 1).
    struct Field {
        bool enabled = true;    ///< Obstacles push mesh vertices away and out.
        double range = 1.5;     ///< Range of the potential field of obstacles that give none [m]; 0 to 100.
        double strength = 1.0;  ///< Strength of the potential field of obstacles that give none; 0 to 100.
        double gain = 1.0;      ///< Displacement of a vertex per unit of field [m]; 0 to 100.
        double speed = 1.5;     ///< Top speed at which a vertex's displacement changes [m/s]; 0.01 to 100.
    };

    /// Travelling places (SPEC M5).
    struct Place {
        double speed = 2.0;       ///< Top speed of travelling places in the open [m/s]; 0.01 to 100.
        double clearance = 0.02;  ///< Kept between a place and obstacles beyond the characters' radius [m]; 0
                                  ///< to 1.5.
    };

    /// The unit cost (SPEC A3; paper eq. 7); alpha and beta sum up to at least 0.01.
    struct Cost {
        double alpha = 0.5;      ///< Weight of path length in the unit cost; 0 to 1000.
        double beta = 0.5;       ///< Weight of time in the unit cost; 0 to 1000.
        double gamma = 1.0;      ///< Weight of discomfort in the unit cost; 0 to 1000.
        double minSpeed = 0.05;  ///< Floor of the speed in a crowd, relative to the free speed; 1e-3 to 1.
    };

    /// What the density of the crowd adds to the unit cost (SPEC A4).
    struct Density {
        bool enabled = true;     ///< Crowded ground costs more.
        double cell = 1.0;       ///< Edge of a density cell [m]; 0.1 to 100.
        double lambda = 1.0;     ///< Exponent of the shares that a character gives to the cells around it;
                                 ///< 0.1 to 10.
        double min = 1.3;        ///< Density below which nobody is slowed [1/m^2]; 0 to 100.
        double max = 3.5;        ///< Density above which one moves with the flow [1/m^2]; above density.min;
                                 ///< 0.01 to 100.
        double lookAhead = 0.5;  ///< How far ahead density is read [m]; 0 to 10.
    };

    /// What moving obstacles add to the unit cost (SPEC A5).
    struct Discomfort {
        bool enabled = true;  ///< Ground ahead of moving obstacles costs more.
        double time = 1.5;    ///< How far ahead moving obstacles are predicted [s]; 0 to 60.
        double range = 1.0;   ///< How far discomfort reaches beyond the swept surface [m]; 0.01 to 100.
        double gain = 8.0;    ///< Discomfort on the obstacle's own track; 0 to 1000.
    };

    /// Planning: the assignment of places (SPEC A1).
    struct Plan {
        PlanMode mode = PlanMode::Transport;             ///< How often places are assigned to characters.
        PlanSolver solver = PlanSolver::Fast;            ///< Which method makes plans.
        PlanObjective objective = PlanObjective::Power;  ///< What a plan minimises.
        std::int32_t period = 0;                         ///< A plan is made every so many steps; 0 for what
                                                         ///< suits the solver; 0 to 600.
        double exponent = 2.0;                           ///< Exponent p of the objective: 1 least sum, 2
                                                         ///< least squares; 1 to 8.
        double threshold = 0.02;                         ///< A change of places must lower the objective by
                                                         ///< more [cost^p]; 0 to 1e9.
        double thresholdShare = 0.003;                   ///< A change of places must lower the objective of
                                                         ///< those it concerns by more than this share; 0 to
                                                         ///< 1.
        bool geodesic = true;                            ///< Costs by the cost field; else straight-line
                                                         ///< distances.
        bool waits = true;                               ///< Where many wait before a passage, some go round.
    };

    /// The characters (SPEC A6).
    struct Character {
        double radius = 0.25;        ///< Radius of a character [m]; 0.05 to 1.5.
        double maxSpeed = 2.0;       ///< Top speed of a character in the open [m/s]; 0.01 to 50.
        double acceleration = 10.0;  ///< Top acceleration of a character [m/s^2]; 0.01 to 1000.
        double velocityGain = 12.0;  ///< Gain of the controller on the error of velocity [1/s]; 0 to 60.
        double positionGain = 3.0;   ///< Gain of the controller on the distance to the place [1/s]; 0 to 60.
        double directReach = 1.5;    ///< Within this clear straight line a character heads for its place [m];
                                     ///< 0 to 100.
        double headway = 0.2;        ///< Time that a character keeps from who is ahead of it [s]; 0.02 to 5.
        double inStep = 1.0;         ///< Share of the speed of who is ahead that a character may walk on top
                                     ///< of its headway: 1 in step; 0 to 1.
        double foresight = 1.0;      ///< Time for which a character keeps clear of who comes towards it [s];
                                     ///< 0.1 to 10.
    };

    /// Contacts between characters (SPEC A6).
    struct Contact {
        std::int32_t iterations = 8;  ///< Rounds that resolve contacts in a step; 1 to 100.
    };

    double stepTime = 1.0 / 60.0;  ///< Simulated time of one step [s]; 1/240 to 1/10.
    Input input;                   ///< Touches and drawn trajectories.
    Control control;               ///< Control points.
    Opposing opposing;             ///< The opposing force: the mesh waits for a crowd that falls behind.
    Mesh mesh;                     ///< The deformable mesh.
    Field field;                   ///< The potential field by which obstacles bend meshes.
    Place place;                   ///< Travelling places.
    Cost cost;                     ///< The unit cost; alpha and beta sum up to at least 0.01.
    Density density;               ///< What the density of the crowd adds to the unit cost.
    Discomfort discomfort;         ///< What moving obstacles add to the unit cost.
    Plan plan;                     ///< Planning: the assignment of places.
    Character character;           ///< The characters.
    Contact contact;               ///< Contacts between characters.
};

}  // namespace muster
