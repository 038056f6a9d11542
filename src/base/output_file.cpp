#include "base/output_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace muster {

OutputFile::OutputFile() = default;
OutputFile::~OutputFile() {
    remove();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : file_(std::move(other.file_)),
      path_(std::exchange(other.path_, {})),
      size_(std::exchange(other.size_, 0)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
    if (this == &other) return *this;
    remove();
    file_ = std::move(other.file_);
    path_ = std::exchange(other.path_, {});
    size_ = std::exchange(other.size_, 0);
    return *this;
}

void OutputFile::remove() {
    file_.reset();
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(partPath(), ignored);
    path_.clear();
}

Status OutputFile::failed() const {
    return {StatusCode::IoError, path_ + ": cannot be written: " + std::strerror(errno)};
}

Status OutputFile::open(const std::string& path) {
    remove();
    size_ = 0;
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return {StatusCode::IoError, path + ": is a folder, expected a file"};
    file_.reset(std::fopen((path + ".part").c_str(), "wb"));
    if (!file_) return {StatusCode::IoError, path + ": cannot be written: " + std::strerror(errno)};
    path_ = path;
    return {};
}

Status OutputFile::write(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) return failed();
    size_ += bytes.size();
    return {};
}

Status OutputFile::rewrite(std::uint64_t offset, std::string_view bytes) {
    const bool good = fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) == 0 &&
                      std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size() &&
                      fseeko(file_.get(), 0, SEEK_END) == 0;
    return good ? Status() : failed();
}

Status OutputFile::commit() {
    if (std::fclose(file_.release()) != 0) return failed();
    std::error_code error;
    std::filesystem::rename(partPath(), path_, error);
    if (error) return {StatusCode::IoError, path_ + ": cannot be written: " + error.message()};
    path_.clear();
    return {};
}

}  // namespace muster
