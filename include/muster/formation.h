// Which formations a group can take (SPEC M1, M3, M7).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/geometry.h"
#include "muster/status.h"

namespace muster {

/// The name of a kind as files and messages spell it: "square", "line"...
std::string_view formationName(FormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
Result<FormationKind> formationKind(std::string_view name);

/// Definition of a formation in its local axes: it faces +x, its centre is the origin.
struct FormationDef {
    FormationKind kind = FormationKind::Square;  ///< Shape.
    double spacing = 1.0;      ///< Distance between neighbouring places [m], above 1e-6 and below 1e6.
    double opening = 1.2;      ///< Full angle of Pacman's mouth or of the crescent's gap [rad] in (0, 6].
    PolygonWithHoles outline;  ///< For Outline: the shape, in any size [m].
    std::vector<Vec2> points;  ///< For Points: the places in this order [m]; at least as many as characters.
    /// For Square: how many stand abreast, 0 to 200,000; 0 for about as many as there are ranks.
    std::int32_t files = 0;

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, spacing, opening, outline, points);
        archive.since(2, files);
    }
};

}  // namespace muster
