// The binary part of a glTF file while it is being written: a temporary file with reserved ranges.
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

/// A temporary file of bytes; it is removed with this object.
class GltfBuffer {
public:
    GltfBuffer() = default;
    GltfBuffer(const GltfBuffer&) = delete;
    GltfBuffer& operator=(const GltfBuffer&) = delete;
    ~GltfBuffer();

    /// Creates the empty file. Fails with IoError, naming the path.
    Status open(const std::string& path);
    /// Reserves a range at the end; returns its offset, a multiple of 4.
    std::uint64_t reserve(std::uint64_t bytes);
    /// Writes within a reserved range.
    Status write(std::uint64_t offset, std::string_view bytes);
    /// Reserves a range and writes it.
    Status append(std::string_view bytes, std::uint64_t& offset);
    std::uint64_t size() const { return size_; }  ///< Number of bytes reserved so far, a multiple of 4.
    /// Appends all bytes to `file`; bytes never written are zeros.
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

/// Writes an animation track: several values per frame, each contiguous over all frames. Some frames are
/// buffered before they are written.
class GltfTrack {
public:
    /// `widths` are the bytes of each value, multiples of 4. Reserves the range for all frames.
    GltfTrack(GltfBuffer& buffer, std::size_t frames, std::span<const std::uint32_t> widths);

    /// Offset of a value's frames within the track's range.
    std::uint64_t offset(std::size_t value) const { return starts_[value] * frames_; }
    /// Offset of the track's range in the buffer.
    std::uint64_t begin() const { return begin_; }
    std::uint64_t bytes() const { return starts_.back() * frames_; }  ///< Size of the track's range.
    std::size_t filled() const { return filled_; }                    ///< Number of frames so far.
    /// Adds frames up to `frames`; they repeat the last frame, or `record` where there is none yet.
    Status fill(std::size_t frames, std::string_view record);
    /// Adds a frame: all values in their order.
    Status add(std::string_view record);
    /// Writes the buffered frames.
    Status flush();

private:
    GltfBuffer* buffer_;
    std::size_t frames_;
    /// Offset of each value within a frame's record, then the record's size.
    std::vector<std::uint64_t> starts_;
    std::uint64_t begin_ = 0;
    std::string records_;  ///< Frames not yet written.
    std::string last_;
    std::string column_;
    std::size_t filled_ = 0;
};

}  // namespace muster
