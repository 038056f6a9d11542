#include "motion_bodies.h"

#include <filesystem>

#include "base/output_file.h"
#include "character/bodies/body.h"

namespace muster {

std::vector<BodyFile> bodyFiles() {
    std::vector<BodyFile> files;
    for (std::size_t kind = 0; kind < kBodyKindCount; ++kind) {
        const std::string name = "body-" + std::to_string(kind + 1);
        files.push_back({name + ".glb", bodyGlb(static_cast<BodyKind>(kind), BodyLevel::Near)});
        files.push_back({name + "-far.glb", bodyGlb(static_cast<BodyKind>(kind), BodyLevel::Far)});
    }
    return files;
}

Status writeBodies(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return {StatusCode::IoError, folder + ": cannot be made: " + error.message()};
    for (const BodyFile& body : bodyFiles()) {
        OutputFile file;
        if (Status s = file.open(folder + "/" + body.name); !s.ok()) return s;
        if (Status s = file.write(body.bytes); !s.ok()) return s;
        if (Status s = file.commit(); !s.ok()) return s;
    }
    return {};
}

}  // namespace muster
