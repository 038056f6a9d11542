// A USD file that is written frame by frame, in one of two encodings.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/output_file.h"
#include "files/export/usd_prim.h"

namespace muster {

/// Length and pace of the animation.
struct UsdPace {
    std::size_t frames = 1;
    double fps = 30.0;
};

/// Frames from which a word holds, in ascending order.
using UsdWords = std::vector<std::pair<std::size_t, const char*>>;

/// Writes prims below /World. Sampled properties are tracks; each gets one value per frame.
class UsdFile {
public:
    UsdFile() = default;
    UsdFile(const UsdFile&) = delete;
    UsdFile& operator=(const UsdFile&) = delete;
    virtual ~UsdFile() = default;

    /// Begins the file.
    virtual Status open(const std::string& path, const UsdPace& pace) = 0;
    /// Adds a prim below /World. Its tracks are numbered on from `tracks()`, in the order of its properties
    /// and then of those of its children.
    virtual Status add(const UsdPrim& prim) = 0;
    virtual std::size_t tracks() const = 0;  ///< Tracks of all prims so far.
    /// Adds the next value of a track.
    virtual Status sample(std::size_t track, std::span<const double> numbers) = 0;
    /// Writes all values of a track of words.
    virtual Status words(std::size_t track, const UsdWords& words) = 0;
    /// Completes the file.
    virtual Status finish() = 0;
};

std::unique_ptr<UsdFile> makeUsdTextFile();   ///< USDA.
std::unique_ptr<UsdFile> makeUsdCrateFile();  ///< USDC, version 0.8.0.

/// Records of equal length, one per frame, in a reserved range of a file. Some frames are buffered before
/// they are written.
class UsdSamples {
public:
    /// The number of records and the bytes of each.
    UsdSamples(std::size_t frames, std::size_t width) : frames_(frames), width_(width) {}

    /// Reserves the range at the end of the file. Fails with write errors.
    Status reserve(OutputFile& file);
    std::uint64_t begin() const { return begin_; }  ///< Offset of the range in the file.
    /// Adds a frame's record.
    Status add(OutputFile& file, std::string_view record);
    /// Writes the buffered records.
    Status flush(OutputFile& file);

private:
    std::size_t frames_, width_;
    std::uint64_t begin_ = 0;
    std::size_t filled_ = 0;
    std::string buffered_;
};

}  // namespace muster
