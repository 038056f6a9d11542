#include "take_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>

namespace muster {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Status failed(const std::string& path) {
    return {StatusCode::IoError, path + ": cannot be written: " + std::strerror(errno)};
}

class TakeFile : public TakeSink {
public:
    TakeFile(File file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

    Status append(std::span<const std::uint8_t> bytes) override {
        const bool wrote = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
        return wrote && std::fflush(file_.get()) == 0 ? Status{} : failed(path_);
    }

    Status finish() override {
        const bool synced = fsync(fileno(file_.get())) == 0 || errno == EINVAL || errno == ENOTSUP;
        const bool closed = std::fclose(file_.release()) == 0;
        return synced && closed ? Status{} : failed(path_);
    }

private:
    File file_;
    std::string path_;
};

std::string stampNow() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    localtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &parts);
    return text;
}

}  // namespace

Result<std::unique_ptr<TakeSink>> openTakeFile(const std::string& folder, const std::string& name) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::string safe;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_';
        safe += plain ? c : '-';
    }
    const std::string stem = folder + "/" + safe.substr(0, 60) + "-" + stampNow();
    for (int attempt = 1; attempt < 100; ++attempt) {
        const std::string path = stem + (attempt == 1 ? "" : "-" + std::to_string(attempt)) + ".take";
        if (File file{std::fopen(path.c_str(), "wbxe")})
            return std::unique_ptr<TakeSink>(new TakeFile(std::move(file), path));
        if (errno != EEXIST) return failed(path);
    }
    return failed(stem);
}

}  // namespace muster
