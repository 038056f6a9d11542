#include "motion_bodies.h"

#include <filesystem>

#include "muster/bodies/body.h"
#include "muster/export/output_file.h"

namespace muster {

Status writeBodies(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return {StatusCode::IoError, folder + ": cannot be made: " + error.message()};
    for (std::size_t kind = 0; kind < kBodyKindCount; ++kind) {
        for (const BodyLevel level : {BodyLevel::Near, BodyLevel::Far}) {
            const std::string path = folder + "/body-" + std::to_string(kind + 1) +
                                     (level == BodyLevel::Far ? "-far" : "") + ".glb";
            OutputFile file;
            if (Status s = file.open(path); !s.ok()) return s;
            if (Status s = file.write(bodyGlb(static_cast<BodyKind>(kind), level)); !s.ok()) return s;
            if (Status s = file.commit(); !s.ok()) return s;
        }
    }
    return {};
}

}  // namespace muster
