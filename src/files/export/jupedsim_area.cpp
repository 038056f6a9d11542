#include "engine/ground/environment/environment.h"
#include "engine/ground/environment/obstacle_piece.h"
#include "files/export/formats.h"

#if MUSTER_SQLITE
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <sstream>

#include "base/maths.h"
#endif

namespace muster {

#if MUSTER_SQLITE
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Shape = bg::model::polygon<Point>;
using Shapes = bg::model::multi_polygon<Shape>;

constexpr int kDiscCorners = 32;

Shape shapeOf(const ObstaclePiece& piece) {
    Shape shape;
    for (const Vec2 p : piece.corners) bg::append(shape.outer(), Point(p.x, p.y));
    for (int i = 0; piece.corners.empty() && i < kDiscCorners; ++i) {
        const double angle = 2.0 * kPi * i / kDiscCorners;
        bg::append(shape.outer(), Point(piece.centre.x + piece.radius * cosine(angle),
                                        piece.centre.y + piece.radius * sine(angle)));
    }
    bg::correct(shape);
    return shape;
}

/// The union of all shapes by recursive halving, so that no large shape is rebuilt for each small one.
Shapes united(const std::vector<Shape>& shapes, std::size_t begin, std::size_t end) {
    Shapes result;
    if (end - begin == 1) result.push_back(shapes[begin]);
    if (end - begin <= 1) return result;
    const std::size_t middle = (begin + end) / 2;
    bg::union_(united(shapes, begin, middle), united(shapes, middle, end), result);
    return result;
}

}  // namespace

std::string walkableArea(const Environment& environment) {
    const Box& box = environment.def().box;
    Shape ground;
    for (const Point corner : {Point(box.min.x, box.min.y), Point(box.max.x, box.min.y),
                               Point(box.max.x, box.max.y), Point(box.min.x, box.max.y)})
        bg::append(ground.outer(), corner);
    bg::correct(ground);
    std::vector<Shape> blocked;
    for (const ObstaclePiece& piece : environment.pieces())
        if (!piece.moving) blocked.push_back(shapeOf(piece));
    Shapes area;
    bg::difference(ground, united(blocked, 0, blocked.size()), area);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(12);
    if (area.size() == 1) {
        text << bg::wkt(area.front());
    } else {
        text << bg::wkt(area);
    }
    return text.str();
}
#else
std::string walkableArea(const Environment&) {
    return {};
}
#endif

}  // namespace muster
