#include "folders.h"

#include <filesystem>

namespace muster {

std::string findFolder(const std::vector<std::string>& names) {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    for (const std::string& name : names) {
        for (const std::filesystem::path& base : {std::filesystem::path("."), program, program / "../.."}) {
            if (std::filesystem::is_directory(base / name, error))
                return (base / name).lexically_normal().string();
        }
    }
    return names.front();
}

}  // namespace muster
