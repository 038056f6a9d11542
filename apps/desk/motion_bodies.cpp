#include "motion_bodies.h"

#include <filesystem>

#include "base/output_file.h"
#include "people/bodies/body_mesh.h"

namespace muster {

namespace {

std::string fileName(std::size_t kind, BodyLevel level) {
    return "body-" + std::to_string(kind + 1) + (level == BodyLevel::Near ? ".glb" : "-far.glb");
}

/// Calls `visit(kind, level)` for every body at every level, until it returns false.
template <class Visit>
void eachBody(Visit visit) {
    for (std::size_t kind = 0; kind < kBodyKindCount; ++kind)
        for (const BodyLevel level : {BodyLevel::Near, BodyLevel::Far})
            if (!visit(kind, level)) return;
}

}  // namespace

std::optional<std::string> bodyFile(std::string_view name) {
    std::optional<std::string> bytes;
    eachBody([&](std::size_t kind, BodyLevel level) {
        if (fileName(kind, level) == name) bytes = bodyGlb(static_cast<BodyKind>(kind), level);
        return !bytes;
    });
    return bytes;
}

std::vector<BodyFile> bodyFiles() {
    std::vector<BodyFile> files;
    eachBody([&](std::size_t kind, BodyLevel level) {
        files.push_back({fileName(kind, level), bodyGlb(static_cast<BodyKind>(kind), level)});
        return true;
    });
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
