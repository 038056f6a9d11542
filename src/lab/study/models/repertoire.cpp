#include "lab/study/models/repertoire.h"

namespace muster {

Repertoire repertoireOf(const SchemeDef& def) {
    Repertoire r;
    r.touch = def.kind == SchemeKind::Touch;
    r.draws = def.kind == SchemeKind::Touch || def.kind == SchemeKind::MouseMesh;
    r.queues = def.kind == SchemeKind::MouseFull;
    r.divides = r.draws ? def.splits : true;
    r.spreads = r.touch && def.shapes && !def.oneFinger;
    r.calls = r.touch && def.splits && def.calls;
    r.keepsShape = r.draws || def.movement == SchemeMovement::Free;
    r.keepsGroups = def.kind == SchemeKind::MouseFull;
    return r;
}

}  // namespace muster
