// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// What is read of characters and groups: the name in Python, the member and the description of each property.
#pragma once

#include "muster/views.h"

namespace muster::python {

/// Calls `define` for each array of the characters.
template <class Define>
void eachColumn(const Define& define) {
    using View = CharactersView;
    define("id", &View::id, "Unique id; it is not reused after the character has left. Shape (n,), uint32.");
    define("group", &View::group, "Index of its group. Shape (n,), uint32.");
    define("position", &View::position, "Position [m]. Shape (n, 2), float64.");
    define("velocity", &View::velocity, "Velocity [m/s]. Shape (n, 2), float64.");
    define("heading", &View::heading, "Unit vector in which the body faces. Shape (n, 2), float64.");
    define("place", &View::place,
           "Index of its place in its group; -1 for the unmatched. Shape (n,), int32.");
    define("direction", &View::direction,
           "Unit vector along its planned path; zero where there is no path. Shape (n, 2), float64.");
    define("cost", &View::cost,
           "Cost of the path to its place; infinite for the unmatched. Shape (n,), float64.");
    define("motion", &View::motion,
           "Motion it performs: an index into the world's clips. Shape (n,), int32.");
    define("phase", &View::phase, "Phase of that motion. Shape (n,), uint8: the index of a MotionPhase.");
    define("motion_time", &View::motionTime, "Time since the phase began [s]. Shape (n,), float64.");
    define("patch", &View::patch, "Id of the patch that it is in; 0 for none. Shape (n,), uint32.");
    define("body", &View::body, "What it is. Shape (n,), records with the fields of Body.");
    define("driver", &View::driver, "Who moves it. Shape (n,), uint8: the index of a Driver.");
    define("wanted_velocity", &View::wantedVelocity,
           "Velocity that steering aims at on the ground it is on, before bounds and contacts [m/s]. Those "
           "that are moved from outside have it too. Shape (n, 2), float64.");
    define("goal", &View::goal, "Exit or waiting area that it goes to; 0 for none. Shape (n,), uint32.");
}

/// Calls `define` for each array of a group.
template <class Define>
void eachArray(const Define& define) {
    using View = GroupView;
    define("members", &View::members, "Indices of its characters, ascending. Shape (n,), int32.");
    define("rest_mesh", &View::restMesh,
           "Vertices of the rest shape, in the group's axes [m]. Shape (n, 2), float64.");
    define("user_mesh", &View::userMesh, "Vertices of Vu, deformed by controls [m]. Shape (n, 2), float64.");
    define("final_mesh", &View::finalMesh,
           "Vertices of Vf: Vu deformed by the environment [m]. Shape (n, 2), float64.");
    define("triangles", &View::triangles, "Vertex indices, counter-clockwise. Shape (n, 3), int32.");
    define("mesh_places", &View::meshPlaces,
           "Each place as a point of the mesh. Shape (n,), records of triangle and weight (3).");
    define("place_positions", &View::placePositions,
           "Current position of each place [m]. Shape (n, 2), float64.");
    define("place_velocities", &View::placeVelocities,
           "Current velocity of each place [m/s]. Shape (n, 2), float64.");
    define("place_targets", &View::placeTargets,
           "Reachable target of each place [m]. Shape (n, 2), float64.");
    define("place_usable", &View::placeUsable,
           "1 where a character can stand at the place, else 0. Shape (n,), uint8.");
    define("place_classes", &View::placeClasses,
           "Class of each place by the group's roles, 0 for whoever is left; empty without roles. Shape "
           "(n,), uint8.");
    define("way", &View::way,
           "What is ahead of the way of the order that it carries out: corners up to the end, the next one "
           "first [m]. Shape (n, 2), float64.");
}

/// Calls `define` for each list of a group that is copied.
template <class Define>
void eachList(const Define& define) {
    using View = GroupView;
    define("controls", &View::controls, "Controls in the order of creation.");
    define("orders", &View::orders, "Its queue; the first one is carried out.");
}

/// Calls `define` for each value of a group.
template <class Define>
void eachValue(const Define& define) {
    using View = GroupView;
    define("colour", &View::colour, "Chosen colour, 0xRRGGBB; None for the palette's colour.");
    define("build", &View::build, "Build of its drawn bodies; None for bodies of both builds.");
    define("motions", &View::motions, "How it walks and jogs; None for the plain manner.");
    define("count", &View::count,
           "Number of characters, and of places but where they go without (Leave, Wait, Walk): then there "
           "are none.");
    define("formation", &View::formation, "Current shape. Its whole definition is read separately.");
    define("formation_version", &View::formationVersion, "Increases whenever the mesh is replaced.");
    define("objective", &View::objective, "Objective of the last plan [cost^p].");
    define("gap_bound", &View::gapBound, "Upper bound of its duality gap [cost^p].");
    define("walk", &View::walk, "Path costs by the last plan.");
    define("mean_lag", &View::meanLag,
           "Mean distance of characters to the targets of their places (SPEC U6) [m].");
    define("held", &View::held, "True: it was ordered to hold, and its orders stay.");
    define("patrols", &View::patrols, "True: orders that are done come last again.");
    define("conduct", &View::conduct, "How it behaves.");
}

}  // namespace muster::python
