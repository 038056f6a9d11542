#include "engine/formation/shapes/make_formation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/generated/enumeration_words.h"
#include "engine/formation/shapes/formation_shape.h"

namespace muster {
namespace {

constexpr std::int32_t kMostPlaces = 200000;

Status check(const FormationDef& def, std::int32_t count) {
    if (static_cast<std::size_t>(def.kind) >= kFormationKindWords.size())
        return invalidArgument("the formation's kind is unknown");
    if (count < 1 || count > kMostPlaces)
        return invalidArgument("found count " + std::to_string(count) + ", expected 1 to " +
                               std::to_string(kMostPlaces));
    if (!(def.spacing > 1e-6 && def.spacing < 1e6))
        return invalidArgument("found spacing " + std::to_string(def.spacing) +
                               ", expected more than 0 and less than 1e6 m");
    if (def.files < 0 || def.files > kMostPlaces)
        return invalidArgument("found files " + std::to_string(def.files) + ", expected 0 to " +
                               std::to_string(kMostPlaces));
    if (!(def.opening > 0.0 && def.opening <= 6.0))
        return invalidArgument("found opening " + std::to_string(def.opening) +
                               ", expected more than 0 and at most 6 rad");
    return {};
}

Result<FormationShape> outlineOf(const FormationDef& def, std::int32_t count) {
    Result<Polygon> outline = cleanPolygon(def.outline.outline);
    if (!outline.ok()) return outline.status().within("outline");
    PolygonWithHoles clean{*outline, {}};
    for (std::size_t k = 0; k < def.outline.holes.size(); ++k) {
        Result<Polygon> hole = cleanPolygon(def.outline.holes[k]);
        if (!hole.ok()) return hole.status().within("hole " + std::to_string(k));
        std::reverse(hole->begin(), hole->end());
        clean.holes.push_back(*hole);
    }
    // A trial triangulation reports where holes leave the outline or meet each other.
    const Box box = boundsOf(clean.outline);
    const Result<TriangleMesh> trial = triangulate(clean, box.width() + box.height());
    if (!trial.ok()) return trial.status().within("outline");
    return outlineShape(count, def.spacing, clean);
}

Result<FormationShape> pointsOf(const FormationDef& def, std::int32_t count) {
    if (std::cmp_greater(count, def.points.size()))
        return invalidArgument("found " + std::to_string(def.points.size()) + " points for " +
                               std::to_string(count) + " places");
    for (std::size_t k = 0; k < def.points.size(); ++k)
        if (!isFinite(def.points[k]) ||
            std::fmax(std::fabs(def.points[k].x), std::fabs(def.points[k].y)) > 1e7)
            return invalidArgument("point " + std::to_string(k) + " is not finite or farther than 1e7 m");
    FormationShape shape;
    shape.places.assign(def.points.begin(), def.points.begin() + count);
    shape.outline.outline = grownHull(shape.places, 0.5 * def.spacing);
    return shape;
}

Result<FormationShape> shapeOf(const FormationDef& def, std::int32_t count) {
    switch (def.kind) {
        case FormationKind::Square:
            return squareShape(count, def.spacing, def.files);
        case FormationKind::Line:
            return lineShape(count, def.spacing);
        case FormationKind::Column:
            return columnShape(count, def.spacing);
        case FormationKind::Wedge:
            return wedgeShape(count, def.spacing);
        case FormationKind::Ring:
            return ringShape(count, def.spacing);
        case FormationKind::Circle:
            return circleShape(count, def.spacing);
        case FormationKind::Crescent:
            return crescentShape(count, def.spacing, def.opening);
        case FormationKind::Pacman:
            return pacmanShape(count, def.spacing, def.opening);
        case FormationKind::Outline:
            return outlineOf(def, count);
        case FormationKind::Points:
            break;
    }
    return pointsOf(def, count);
}

// Moves the mean of the places to the origin, and orders them from front to back, then by ascending y.
void centreAndSort(FormationShape& shape, double spacing) {
    Vec2 mean;
    for (const Vec2 p : shape.places) mean += p;
    mean = mean / static_cast<double>(shape.places.size());
    for (Vec2& p : shape.places) p = p - mean;
    for (Vec2& p : shape.outline.outline) p = p - mean;
    for (Polygon& hole : shape.outline.holes)
        for (Vec2& p : hole) p = p - mean;
    // The rank is rounded to a millionth of the spacing, so that places of one rank compare as equal.
    const auto rank = [&](Vec2 p) { return std::floor(p.x / (1e-6 * spacing) + 0.5); };
    std::sort(shape.places.begin(), shape.places.end(), [&](Vec2 a, Vec2 b) {
        if (rank(a) != rank(b)) return rank(a) > rank(b);
        return a.y != b.y ? a.y < b.y : a.x > b.x;
    });
}

}  // namespace

std::string_view formationName(FormationKind kind) {
    const auto index = static_cast<std::size_t>(kind);
    return index < kFormationKindWords.size() ? kFormationKindWords[index] : "unknown";
}

Result<FormationKind> formationKind(std::string_view name) {
    std::string all;
    for (std::size_t k = 0; k < kFormationKindWords.size(); ++k) {
        if (name == kFormationKindWords[k]) return static_cast<FormationKind>(k);
        all += (k == 0 ? "" : ", ") + std::string(kFormationKindWords[k]);
    }
    return Status(StatusCode::NotFound,
                  "found formation '" + std::string(name) + "', expected one of " + all);
}

std::int32_t squareFiles(std::int32_t count) {
    auto files = static_cast<std::int32_t>(std::floor(std::sqrt(static_cast<double>(count))));
    while (files * files < count) ++files;
    return files;
}

Result<Formation> makeFormation(const FormationDef& def, std::int32_t count) {
    const Status checked = check(def, count);
    if (!checked.ok()) return checked;
    Result<FormationShape> shape = shapeOf(def, count);
    if (!shape.ok()) return shape.status();
    MUSTER_ASSERT(std::cmp_equal(shape->places.size(), count));
    if (def.kind != FormationKind::Points) centreAndSort(*shape, def.spacing);
    Result<Formation> formation = meshShape(*shape, def.spacing);
    if (!formation.ok()) return formation.status().within(std::string(formationName(def.kind)));
    return formation;
}

}  // namespace muster
