// Regions of the plane, cut into trapezoids, and their common parts with convex polygons.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "muster/geometry.h"
#include "muster/status.h"

namespace muster {

/// The part of a polygon to the left of the line from `a` to `b`. Corners run counter-clockwise; the result
/// is empty where nothing is left.
void clipLeftOf(Polygon& convex, Vec2 a, Vec2 b);

/// Polygons with holes. A point lies inside where a ray from it crosses the edges an odd number of times, so
/// that outlines and holes may run either way.
class Region {
public:
    /// Cuts the polygons along lines y = const through all corners. Fails with InvalidArgument where there is
    /// no polygon, one has fewer than three corners, or a coordinate is not finite.
    static Result<Region> create(std::span<const PolygonWithHoles> polygons);
    /// Cuts one simple polygon.
    static Result<Region> create(const Polygon& polygon);
    /// Reads well-known text: POLYGON, MULTIPOLYGON, or a GEOMETRYCOLLECTION of these. Fails with ParseError.
    static Result<Region> parse(std::string_view text);

    double area() const { return area_; }  ///< Area of the region [m^2].
    const Box& box() const { return box_; }
    /// True where `p` lies inside; points of the outline may belong to either side.
    bool contains(Vec2 p) const;
    /// Area that the region shares with a convex polygon [m^2].
    double sharedArea(const Polygon& convex) const;
    /// The parts that the region shares with a convex polygon and that hang together with `p`, as convex
    /// pieces that do not overlap; empty where `p` does not lie in the region.
    std::vector<Polygon> partAround(const Polygon& convex, Vec2 p) const;
    /// All edges, for drawings.
    const std::vector<Polygon>& rings() const { return rings_; }

private:
    // A trapezoid between the lines y = low and y = high of its slab.
    struct Trapezoid {
        double leftLow, rightLow, leftHigh, rightHigh;
    };
    void cut();
    void fillSlab(std::size_t slab, std::vector<std::pair<Vec2, Vec2>>& crossing);
    std::pair<std::size_t, std::size_t> slabsOf(const Polygon& convex) const;
    Polygon shared(const Polygon& convex, std::size_t slab, const Trapezoid& trapezoid) const;
    std::size_t slabOf(std::int32_t trapezoid) const;
    std::int32_t find(Vec2 p) const;

    std::vector<Polygon> rings_;
    std::vector<double> lines_;  // Ascending y; slab s lies between lines s and s + 1.
    std::vector<Trapezoid> trapezoids_;
    std::vector<std::int32_t> slabEnd_;  // By slab: the end of its range in trapezoids_.
    Box box_;
    double area_ = 0.0;
};

/// The ground of a box outside of convex obstacles whose corners run counter-clockwise.
Result<Region> regionOutside(const Box& box, std::span<const Polygon> convex);

}  // namespace muster
