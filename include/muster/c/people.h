/* People: how the persons of a group differ, and the areas where they leave the world, come and wait. */
#ifndef MUSTER_C_PEOPLE_H
#define MUSTER_C_PEOPLE_H

#include "muster/c/orders.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The distribution of a number over persons. What lies outside `least` to `most` is not drawn.
typedef struct MusterDistribution {
    MusterSpread spread;  ///< Its kind.
    double a;             ///< First number, in the unit of what is drawn but for LogNormal.
    double b;             ///< Second number; not read for Constant.
    double least;         ///< The smallest value that occurs.
    double most;          ///< The largest one.
} MusterDistribution;

/// 0 for all, which stands for a parameter.
MUSTER_API MusterDistribution muster_default_distribution(void);
/// The value below which a share of persons lie, in (0, 1). Fails with InvalidArgument for other shares, and
/// for a kind that is not known.
MUSTER_API MusterStatus muster_distribution_quantile(const MusterDistribution* distribution, double share,
                                                     double* outValue);

/// One sort of persons in a group. A number of 0 stands for that of the parameters, as in MusterBody.
typedef struct MusterPeopleDef {
    uint32_t structVersion;          ///< Set by muster_default_people_def().
    const char* name;                ///< Name for display; null or empty for none.
    double share;                    ///< Share of the group, above 0; shares are divided by their sum.
    uint8_t unitClass;               ///< Class, for roles; 0 for none.
    MusterDistribution speed;        ///< Top speed in the open [m/s], 0 or 0.01 to 50.
    MusterDistribution radius;       ///< Radius of the body [m], 0 or 0.05 to 1.5.
    MusterDistribution headway;      ///< Time that it keeps from who is ahead [s], 0 or 0.02 to 5.
    MusterDistribution premovement;  ///< Time until it sets out on its first order [s], 0 to 1e7.
    MusterDistribution age;          ///< Age [years]; above 0 it gives the top speed in the place of `speed`.
    double upstairs;                 ///< Speed up stairs as a share of that in the open, 0 or 0.01 to 1.
    double downstairs;               ///< Speed down stairs as a share of that in the open, 0 or 0.01 to 1.
} MusterPeopleDef;

/// One sort, by the parameters.
MUSTER_API MusterPeopleDef muster_default_people_def(void);
/// Adults: free speeds of mean 1.34 m/s and deviation 0.26 m/s, cut off at 0.5 and 2.2 m/s.
MUSTER_API MusterPeopleDef muster_adults(void);
/// The mean free speed of persons by age [m/s], 5 to 90 years.
MUSTER_API double muster_walking_speed_at_age(double years);

/// How many people a source has let in by a time.
typedef struct MusterArrivals {
    double time;    ///< [s] of the world.
    int32_t count;  ///< That come at this time.
} MusterArrivals;

/// An area where people leave the world, come into it, or wait. It is no obstacle.
typedef struct MusterAreaDef {
    uint32_t structVersion;   ///< Set by muster_default_area_def().
    const char* name;         ///< Name for display; null or empty for none.
    MusterAreaKind kind;      ///< What it does.
    MusterPolygon polygon;    ///< Corners of a simple polygon, convex or not [m].
    bool open;                ///< False: nobody leaves or comes here for now.
    double rate;              ///< For Exit: the most who leave in a second, 0 for as many as come. For
                              ///< Source: how many come in a second on average. 0 to 1000.
    const MusterVec2* queue;  ///< For Exit: a line in which people queue, from who is next to the last [m].
    int32_t queueCount;       ///< Number of its points: 0 for a crowd, else 2 or more.
    int32_t group;            ///< For Source in a MusterWorldDef: index of the group whom its people join.
    double from;              ///< For Exit: when it opens; for Source with a rate: when it begins [s].
    double until;             ///< For Exit: when it closes; for Source with a rate: when it ends [s].
    int32_t most;             ///< For Source with a rate: how many come in all; 0 for no end.
    const MusterArrivals* timetable;  ///< For Source: further people, by ascending times.
    int32_t timetableCount;           ///< Their number.
} MusterAreaDef;

/// An exit without a shape yet, open, for as many as come.
MUSTER_API MusterAreaDef muster_default_area_def(void);

#ifdef __cplusplus
}
#endif

#endif
