#include "muster/generator/own_clips.h"

namespace muster {

const ClipLibrary& ownClips() {
    static const ClipLibrary kLibrary;
    return kLibrary;
}

}  // namespace muster
