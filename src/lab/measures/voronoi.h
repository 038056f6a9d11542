// Density and speed by Voronoi cells (Steffen and Seyfried 2010), as PedPy defines them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/measures/region.h"
#include "lab/measures/trajectories.h"

namespace muster {

/// The limit of a cell.
struct CutOff {
    double radius = 0.0;  ///< Radius of the circle round each person that bounds its cell [m]; 0 for none.
    std::int32_t quadSegments = 3;  ///< Number of edges by which a quarter of that circle is drawn, 1 to 100.
};

/// The cell of a person: the ground that is nearer to it than to anybody else, within its cut-off, as far as
/// it hangs together with the person.
struct VoronoiCell {
    std::uint32_t id = 0;         ///< Id of the person.
    std::vector<Polygon> pieces;  ///< Convex parts, which do not overlap; none for a person off the ground.
    double area = 0.0;            ///< Area of the cell [m^2].
};

/// The cells of one frame, in the order of the sightings. Persons on the same spot have the same cell.
std::vector<VoronoiCell> voronoiCells(std::span<const Sighting> persons, const Region& walkable,
                                      const CutOff& cutOff = {});
/// Area of a cell within a measurement area [m^2].
double areaWithin(const VoronoiCell& cell, const Region& area);

/// Density and speed per frame, from the first frame on.
struct VoronoiSeries {
    std::vector<double> density;  ///< Sum over the cells of (share of the cell in the area) / area [1/m^2].
    /// Sum over the cells of speed * (their part in the area) / area [m/s]: ground without anybody counts as
    /// speed 0. Empty where no speeds were given.
    std::vector<double> speed;
};
/// Density, and speed where `speeds` are given: one per sighting, in the order of all(); NaN for none.
VoronoiSeries voronoiSeries(const Trajectories& trajectories, const Region& walkable, const Region& area,
                            const CutOff& cutOff = {}, std::span<const double> speeds = {});

}  // namespace muster
