#include "files/export/gltf_buffer.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace muster {
namespace {

constexpr std::size_t kTrackFrames = 64;      // Number of frames that a track buffers.
constexpr std::size_t kCopyBytes = 1u << 20;  // Number of bytes copied at a time.

}  // namespace

GltfBuffer::~GltfBuffer() {
    if (!file_) return;
    file_.reset();
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

Status GltfBuffer::failed() const {
    return {StatusCode::IoError, path_ + ": cannot be written: " + std::strerror(errno)};
}

Status GltfBuffer::open(const std::string& path) {
    path_ = path;
    size_ = 0;
    file_.reset(std::fopen(path.c_str(), "w+b"));
    return file_ ? Status() : failed();
}

std::uint64_t GltfBuffer::reserve(std::uint64_t bytes) {
    const std::uint64_t offset = size_;
    size_ += gltfPadded(bytes);
    return offset;
}

Status GltfBuffer::write(std::uint64_t offset, std::string_view bytes) {
    const bool good = fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) == 0 &&
                      std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
    return good ? Status() : failed();
}

Status GltfBuffer::append(std::string_view bytes, std::uint64_t& offset) {
    offset = reserve(bytes.size());
    return write(offset, bytes);
}

Status GltfBuffer::copyTo(OutputFile& file) {
    if (std::fflush(file_.get()) != 0) return failed();
    std::rewind(file_.get());
    std::vector<char> block(kCopyBytes);
    for (std::uint64_t done = 0; done < size_;) {
        const std::size_t wanted = static_cast<std::size_t>(
            std::min<std::uint64_t>(kCopyBytes, size_ - done));
        const std::size_t got = std::fread(block.data(), 1, wanted, file_.get());
        if (std::ferror(file_.get())) return failed();
        // The file ends at the last byte written; the rest of the range is zeros.
        std::fill(block.begin() + static_cast<std::ptrdiff_t>(got), block.end(), '\0');
        if (Status s = file.write({block.data(), wanted}); !s.ok()) return s;
        done += wanted;
    }
    return {};
}

GltfTrack::GltfTrack(GltfBuffer& buffer, std::size_t frames, std::span<const std::uint32_t> widths)
    : buffer_(&buffer), frames_(frames), starts_(1, 0) {
    for (const std::uint32_t width : widths) starts_.push_back(starts_.back() + width);
    begin_ = buffer.reserve(bytes());
    records_.reserve(std::min(frames, kTrackFrames) * starts_.back());
}

Status GltfTrack::fill(std::size_t frames, std::string_view record) {
    const std::string same = filled_ == 0 ? std::string(record) : last_;
    while (filled_ < frames) {
        if (Status s = add(same); !s.ok()) return s;
    }
    return {};
}

Status GltfTrack::add(std::string_view record) {
    records_ += record;
    last_ = record;
    ++filled_;
    return records_.size() < kTrackFrames * starts_.back() ? Status() : flush();
}

Status GltfTrack::flush() {
    const std::size_t record = starts_.back(), count = records_.size() / record;
    for (std::size_t value = 0; value + 1 < starts_.size() && count > 0; ++value) {
        const std::size_t width = starts_[value + 1] - starts_[value];
        column_.clear();
        for (std::size_t k = 0; k < count; ++k) column_.append(records_, k * record + starts_[value], width);
        const std::uint64_t place = begin_ + offset(value) + (filled_ - count) * width;
        if (Status s = buffer_->write(place, column_); !s.ok()) return s;
    }
    records_.clear();
    return {};
}

}  // namespace muster
