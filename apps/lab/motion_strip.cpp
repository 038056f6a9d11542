#include "motion_parts.h"

#include <filesystem>

#include "base/output_file.h"
#include "lab/picture/pose_strip.h"

namespace muster {

Status writeStrips(const std::vector<Clip>& clips, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return {StatusCode::IoError, folder + ": cannot be made: " + error.message()};
    for (const Clip& clip : clips) {
        OutputFile file;
        if (Status s = file.open(folder + "/" + clip.name + ".svg"); !s.ok()) return s;
        if (Status s = file.write(poseStrip(clip, {}, false)); !s.ok()) return s;
        if (Status s = file.commit(); !s.ok()) return s;
    }
    return {};
}

}  // namespace muster
