// Named formations: a rest mesh and evenly spread places (SPEC M1, M3, M7).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/triangulation.h"
#include "muster/status.h"

namespace muster {

/// The library of shapes.
enum class FormationKind : std::uint8_t {
    Square,
    Line,
    Column,
    Wedge,
    Ring,
    Circle,
    Crescent,
    Pacman,
    Outline,  ///< Any polygon with holes, scaled to hold the count at the spacing.
    Points,   ///< Explicit places; the mesh is made round them.
};

/// "square", "line"... as files and messages spell it.
std::string_view formationName(FormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
Result<FormationKind> formationKind(std::string_view name);

/// Describes a formation. Local frame: it faces +x, its centre is the origin.
struct FormationDef {
    FormationKind kind = FormationKind::Square;
    double spacing = 1.0;      ///< Distance between neighbouring places [m] > 0.
    double opening = 1.2;      ///< Full angle of Pacman's mouth or the crescent's gap [rad] in (0, 6].
    PolygonWithHoles outline;  ///< For Outline, any size.
    std::vector<Vec2> points;  ///< For Points: places in the local frame [m]; kept in order.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, spacing, opening, outline, points);
    }
};

/// A registered formation: rest mesh in the local frame, and places on it.
struct Formation {
    TriangleMesh mesh;              ///< Rest shape [m].
    std::vector<MeshPoint> places;  ///< One per character, front to back.

    /// Lets an archive read or write the formation.
    template <class Archive>
    void visit(Archive& archive) {
        archive(mesh, places);
    }
};

/// Makes a formation with `count` >= 1 places (Points: at most as many as it has points).
/// Places lie `spacing` apart (nearest neighbours within 0.8 to 1.3 of it in the named shapes), the
/// mesh covers them with a margin of half a spacing. Fails with InvalidArgument on bad numbers.
Result<Formation> makeFormation(const FormationDef& def, std::int32_t count);

}  // namespace muster
