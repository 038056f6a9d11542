// What this library is: its version and its components.
#include <cstring>

#include "muster/muster.h"

const char* muster_version(void) {
    return MUSTER_VERSION;
}

bool muster_has_component(const char* component) {
    if (component == nullptr) return false;
    if (std::strcmp(component, "core") == 0) return true;
#ifdef MUSTER_WITH_MOTION
    if (std::strcmp(component, "motion") == 0) return true;
#endif
#ifdef MUSTER_WITH_IO
    if (std::strcmp(component, "io") == 0) return true;
#endif
    return false;
}
