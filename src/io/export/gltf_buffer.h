// The binary part of a glTF file while its parts grow: on disk, at places known beforehand.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/gltf.h"
#include "base/output_file.h"
#include "muster/status.h"

namespace muster {

/// Bytes in a file of its own, which goes when this goes.
class GltfBuffer {
public:
    GltfBuffer() = default;
    GltfBuffer(const GltfBuffer&) = delete;
    GltfBuffer& operator=(const GltfBuffer&) = delete;
    ~GltfBuffer();

    /// Begins with no bytes. Fails with IoError, naming the path.
    Status open(const std::string& path);
    /// Sets aside a stretch at the end; returns where it begins, a multiple of 4.
    std::uint64_t reserve(std::uint64_t bytes);
    /// Writes within what was set aside.
    Status write(std::uint64_t offset, std::string_view bytes);
    /// Sets aside and writes.
    Status append(std::string_view bytes, std::uint64_t& offset);
    std::uint64_t size() const { return size_; }  ///< Set aside so far, a multiple of 4.
    /// Adds all bytes to `file`; stretches never written are zeros.
    Status copyTo(OutputFile& file);

private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    Status failed() const;

    std::unique_ptr<std::FILE, CloseFile> file_;
    std::string path_;
    std::uint64_t size_ = 0;
};

/// Several values a frame, each kept together over all frames: buffered for some frames, then written.
class GltfTrack {
public:
    /// `widths`: bytes of each value, multiples of 4. Sets aside what all frames need.
    GltfTrack(GltfBuffer& buffer, std::size_t frames, std::span<const std::uint32_t> widths);

    /// Where a value's frames begin, from the front of the stretch.
    std::uint64_t offset(std::size_t value) const { return starts_[value] * frames_; }
    std::uint64_t begin() const { return begin_; }                    ///< Of the stretch in the buffer.
    std::uint64_t bytes() const { return starts_.back() * frames_; }  ///< Of the stretch.
    std::size_t filled() const { return filled_; }                    ///< Frames so far.
    /// Adds frames until there are `frames`, all like the last, or like `record` where there is none yet.
    Status fill(std::size_t frames, std::string_view record);
    /// Adds a frame: all values one behind another.
    Status add(std::string_view record);
    /// Writes what is buffered.
    Status flush();

private:
    GltfBuffer* buffer_;
    std::size_t frames_;
    std::vector<std::uint64_t> starts_;  ///< Of each value within a frame's record, and the record's end.
    std::uint64_t begin_ = 0;
    std::string records_;  ///< Not yet written.
    std::string last_;
    std::string column_;
    std::size_t filled_ = 0;
};

}  // namespace muster
