#include <sstream>

#include "base/maths.h"
#include "engine/geometry/free_area.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/environment/obstacle_piece.h"
#include "files/export/formats.h"

namespace muster {
namespace {

constexpr int kDiscCorners = 32;

Polygon shapeOf(const ObstaclePiece& piece) {
    Polygon shape = piece.corners;
    for (int i = 0; piece.corners.empty() && i < kDiscCorners; ++i) {
        const double angle = 2.0 * kPi * i / kDiscCorners;
        shape.push_back(piece.centre + Vec2{cosine(angle), sine(angle)} * piece.radius);
    }
    return shape;
}

/// A closed ring of the other direction.
void writeRing(std::ostringstream& text, const Polygon& ring) {
    text << '(' << ring[0].x << ' ' << ring[0].y;
    for (std::size_t k = ring.size(); k-- > 0;) text << ',' << ring[k].x << ' ' << ring[k].y;
    text << ')';
}

void writePart(std::ostringstream& text, const PolygonWithHoles& part) {
    text << '(';
    writeRing(text, part.outline);
    for (const Polygon& hole : part.holes) {
        text << ',';
        writeRing(text, hole);
    }
    text << ')';
}

}  // namespace

// Well-known text has outlines clockwise and holes counter-clockwise.
std::string walkableArea(const Environment& environment) {
    std::vector<Polygon> blocked;
    for (const ObstaclePiece& piece : environment.pieces())
        if (!piece.moving) blocked.push_back(shapeOf(piece));
    const std::vector<PolygonWithHoles> parts = freeArea(environment.def().box, blocked);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(12);
    text << (parts.size() == 1 ? "POLYGON" : "MULTIPOLYGON(");
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (k > 0) text << ',';
        writePart(text, parts[k]);
    }
    if (parts.size() != 1) text << ')';
    return text.str();
}

}  // namespace muster
