// A registered formation: the rest mesh of a group and the places on it (SPEC M1, M3, M7).
#pragma once

#include <vector>

#include "engine/geometry/triangulation.h"
#include "muster/order.h"

namespace muster {

/// A rest mesh in the local frame, and places on it.
struct Formation {
    TriangleMesh mesh;              ///< Rest shape [m].
    std::vector<MeshPoint> places;  ///< Places, one per character, front to back.

    /// Lets an archive read or write the formation.
    template <class Archive>
    void visit(Archive& archive) {
        archive(mesh, places);
    }
};

/// The number of files of a Square of `count` places that does not say it: about as many as it has ranks.
std::int32_t squareFiles(std::int32_t count);

/// Makes a formation with `count` places, 1 to 200,000 (Points: at most as many as it has points). Nearest
/// neighbours of the named shapes are 0.8 to 1.3 spacings apart, and the mesh covers the places with a margin
/// of half a spacing. Fails with InvalidArgument, naming the number that is out of its range.
Result<Formation> makeFormation(const FormationDef& def, std::int32_t count);

}  // namespace muster
