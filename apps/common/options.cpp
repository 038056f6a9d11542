#include "options.h"

#include <filesystem>

namespace muster {
namespace {

namespace fs = std::filesystem;

bool sameFile(const std::string& a, const std::string& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    // A file that does not exist yet can only be compared by its path.
    std::error_code first, second;
    const fs::path left = fs::weakly_canonical(fs::absolute(a), first);
    const fs::path right = fs::weakly_canonical(fs::absolute(b), second);
    return !first && !second && left == right;
}

}  // namespace

Status differentFiles(const std::vector<std::string>& read, const std::vector<std::string>& written) {
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i].empty()) continue;
        for (const std::string& other : read) {
            if (!other.empty() && sameFile(written[i], other))
                return invalidArgument(written[i] + ": is read as well, expected another file to write");
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (!written[j].empty() && sameFile(written[i], written[j]))
                return invalidArgument(written[i] + ": would be written twice, expected different files");
        }
    }
    return {};
}

}  // namespace muster
