// The fields of definitions whose forms differ, for both directions (bindings/c/c_world/marshal.h).
#pragma once

#include "bindings/c/c_world/generated/definition_fields.h"
#include "bindings/c/c_world/marshal.h"
#include "muster/generated/world_definitions.h"
#include "muster/muster.h"

namespace muster::c_api {

template <class M>
void fields(M& m, C<M, MusterPolygon>& c, P<M, Polygon>& p) {
    m.list(c.points, c.pointCount, p, "points");
}
template <class M>
void fields(M& m, C<M, MusterMapDef>& c, P<M, MapGround>& p) {
    m.template version<MusterMapDef>(c.structVersion);
    m.plain(c.width, p.grid.width);
    m.plain(c.height, p.grid.height);
    m.list(c.cells, c.cellCount, p.grid.cells, "cells");
    m.plain(c.metresPerCell, p.def.metresPerCell);
    m.plain(c.origin, p.def.origin);
    m.plain(c.swampSpeed, p.def.swampSpeed);
}

}  // namespace muster::c_api
