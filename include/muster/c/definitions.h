/* Made by schema/generate.mjs from schema/api/definitions.txt: change these, not this file. */
/* What is made of definitions, and of what they are made: paths, formations, maps, orders, people,
 * parameters. */
#ifndef MUSTER_C_DEFINITIONS_H
#define MUSTER_C_DEFINITIONS_H

#include "muster/c/generated/definition_structs.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Position, angle and velocities on a path at one time.
typedef struct MusterPathState {
    MusterWaypoint at;       ///< Position and angle.
    MusterVec2 velocity;     ///< Velocity [m/s].
    double angularVelocity;  ///< Angular velocity [rad/s].
} MusterPathState;

/// Reads a path at `time` [s]. Fails with InvalidArgument, naming the waypoint, where times do not rise or a
/// number is out of range.
MUSTER_API MusterStatus muster_timed_path_at(const MusterTimedPath* path, double time,
                                             MusterPathState* outState);

/// The name of a kind as files spell it: "square", "line"... Null for other numbers.
MUSTER_API const char* muster_formation_name(MusterFormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
MUSTER_API MusterStatus muster_formation_kind(const char* name, MusterFormationKind* outKind);

/// The clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order. Null for
/// `outCount` is fine. Valid for ever.
MUSTER_API const MusterClipFacts* muster_own_clip_facts(int32_t* outCount);

/// A map that was read, and the ground that it makes.
typedef struct MusterMapId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterMapId;

/// Reads the text of a `.map` file (type octile), of `size` bytes. Fails with ParseError, naming the line.
MUSTER_API MusterStatus muster_map_parse(const char* text, size_t size, MusterMapId* outMap);
/// Ends a map. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_map_destroy(MusterMapId map);
/// The cells of a map, with scale and position of muster_default_map_def(). Valid until the map is destroyed.
MUSTER_API MusterStatus muster_map_def(MusterMapId map, MusterMapDef* outDef);
/// Blocked cells (`@ O T W`) as few rectangular obstacles, which do not overlap and cover exactly these
/// cells. `placement` gives scale and position; its cells are not read. Valid until the next call for this
/// map.
MUSTER_API MusterStatus muster_map_obstacles(MusterMapId map, const MusterMapDef* placement,
                                             const MusterObstacleDef** outObstacles, int32_t* outCount);
/// Swamp cells as few rectangular patches on which `motion` is played, as muster_map_obstacles().
MUSTER_API MusterStatus muster_map_patches(MusterMapId map, const MusterMapDef* placement,
                                           MusterMotionIndex motion, const MusterPatchDef** outPatches,
                                           int32_t* outCount);

/// Takes up a front from `left` to `right` [m]: its middle, width and facing.
MUSTER_API MusterOrder muster_order_to_line(MusterVec2 left, MusterVec2 right);

/// What would come of an order.
typedef struct MusterForecast {
    uint32_t structVersion;  ///< Set by muster_default_forecast().
    bool arrives;            ///< True where the target can be reached.
    const MusterVec2* way;   ///< The way of the formation's centre, both ends included [m].
    int32_t wayCount;        ///< Their number.
    MusterVec2 end;          ///< Where the formation would stand: the target, or the nearest ground to it
                             ///< [m].
    double seconds;          ///< Time until it would arrive [s]; infinite where it never does.
} MusterForecast;

/// Nothing yet: to be filled by muster_world_forecast().
MUSTER_API MusterForecast muster_default_forecast(void);

/// The value below which a share of persons lie, in (0, 1). Fails with InvalidArgument for other shares, and
/// for a kind that is not known.
MUSTER_API MusterStatus muster_distribution_quantile(const MusterDistribution* distribution, double share,
                                                     double* outValue);

/// Adults: free speeds of mean 1.34 m/s and deviation 0.26 m/s, cut off at 0.5 and 2.2 m/s.
MUSTER_API MusterPeopleDef muster_adults(void);
/// The mean free speed of persons by age [m/s], 5 to 90 years.
MUSTER_API double muster_walking_speed_at_age(double years);

/// Describes one parameter.
typedef struct MusterParameterInfo {
    const char* name;         ///< Name in files and messages: "plan.exponent".
    const char* unit;         ///< "m", "s", "m/s", "1", "switch", "mode", "steps", "count"...
    double minimum;           ///< Smallest allowed value.
    double maximum;           ///< Largest allowed value.
    double standard;          ///< Value of the preset "units".
    bool whole;               ///< True where only whole numbers are valid: switches, modes, steps and counts.
    const char* description;  ///< One sentence.
} MusterParameterInfo;

/// Number of parameters.
MUSTER_API int32_t muster_parameter_count(void);
/// The parameter of an index. Its texts are valid for ever. Fails with InvalidArgument for other indices.
MUSTER_API MusterStatus muster_parameter_info(int32_t index, MusterParameterInfo* outInfo);
/// The value of a parameter in a preset: "units" (the defaults), "people" or "paper". Fails with NotFound.
MUSTER_API MusterStatus muster_preset_value(const char* preset, const char* name, double* outValue);

#ifdef __cplusplus
}
#endif

#endif
