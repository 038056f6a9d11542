#include "files/export/usd_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/maths.h"

namespace muster {
namespace {

constexpr std::size_t kBufferedFrames = 16;

// Codes as in the file format's table of types.
constexpr std::array kTypes{
    UsdType{"token", 11, 0, 4, 0, 0},    UsdType{"int", 3, 1, 4, 12, 0},
    UsdType{"float", 8, 1, 4, 12, 4},    UsdType{"half3", 25, 3, 2, 8, 4},
    UsdType{"float2", 20, 2, 4, 10, 5},  UsdType{"float3", 24, 3, 4, 10, 5},
    UsdType{"color3f", 24, 3, 4, 10, 5}, UsdType{"normal3f", 24, 3, 4, 10, 5},
    UsdType{"point3f", 24, 3, 4, 10, 5}, UsdType{"double3", 23, 3, 8, 12, 4},
    UsdType{"quatf", 17, 4, 4, 8, 5},    UsdType{"matrix4d", 15, 16, 8, 12, 6},
};

}  // namespace

bool isUsdArray(const std::string& type) {
    return type.ends_with("[]");
}

const UsdType& usdType(const std::string& name) {
    std::string_view plain = name;
    if (isUsdArray(name)) plain.remove_suffix(2);
    const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                    [plain](const UsdType& type) { return plain == type.name; });
    MUSTER_ASSERT(found != kTypes.end());
    return *found;
}

Status UsdSamples::reserve(OutputFile& file) {
    begin_ = file.size();
    const std::string blank(std::min<std::size_t>(frames_, 1024) * width_, ' ');
    for (std::size_t left = frames_ * width_; left > 0;) {
        const std::size_t now = std::min(left, blank.size());
        if (Status s = file.write({blank.data(), now}); !s.ok()) return s;
        left -= now;
    }
    return {};
}

Status UsdSamples::add(OutputFile& file, std::string_view record) {
    MUSTER_ASSERT(record.size() == width_ && filled_ < frames_);
    buffered_ += record;
    ++filled_;
    return buffered_.size() < kBufferedFrames * width_ ? Status() : flush(file);
}

Status UsdSamples::flush(OutputFile& file) {
    if (buffered_.empty()) return {};
    const std::uint64_t place = begin_ + filled_ * width_ - buffered_.size();
    Status s = file.rewrite(place, buffered_);
    buffered_.clear();
    return s;
}

}  // namespace muster
