#include "base/text_file.h"

#include <cstdio>
#include <memory>

namespace muster {

Result<std::string> readTextFile(const std::string& path, std::size_t limit) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) return Status(StatusCode::IoError, path + ": cannot be opened");
    std::string text;
    char buffer[65536];
    while (const std::size_t got = std::fread(buffer, 1, sizeof(buffer), file.get())) {
        text.append(buffer, got);
        if (text.size() > limit) {
            return Status(StatusCode::LimitExceeded,
                          path + ": found more than " + std::to_string(limit) + " bytes");
        }
    }
    if (std::ferror(file.get())) return Status(StatusCode::IoError, path + ": cannot be read");
    return text;
}

Status writeTextFile(const std::string& path, std::string_view text) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return {StatusCode::IoError, path + ": cannot be written"};
    const bool wrote = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    const bool closed = std::fclose(file) == 0;
    return wrote && closed ? Status() : Status(StatusCode::IoError, path + ": cannot be written in full");
}

}  // namespace muster
