#include "studio/gestures/control_scheme.h"

#include "studio/gestures/mouse_mesh.h"
#include "studio/gestures/mouse_strategy.h"
#include "studio/gestures/touch_scheme.h"

namespace muster {

std::unique_ptr<ControlScheme> makeControlScheme(const SchemeDef& def, std::uint32_t client) {
    switch (def.kind) {
        case SchemeKind::Touch:
            return std::make_unique<TouchScheme>(def, client);
        case SchemeKind::MouseMesh:
            return std::make_unique<MouseMesh>(def, client);
        case SchemeKind::MousePaper:
        case SchemeKind::MouseFull:
            break;
    }
    return std::make_unique<MouseStrategy>(def);
}

}  // namespace muster
