#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/maths.h"
#include "base/text_file.h"
#include "muster/clip.h"
#include "people/clips/bvh_axes.h"
#include "people/clips/bvh_scanner.h"

namespace muster {
namespace {

constexpr double kLargestOffset = 1e6;  // Largest offset [units of the file].
// Relative rounding error of frame times, within which a rate is rounded to a whole number.
constexpr double kRateGrain = 2e-4;
// number are rounded to it.

/// The channel of one column of the motion: position along x, y, z or rotation about x, y, z.
using Channel = std::uint8_t;
constexpr std::array<std::string_view, 6> kChannelNames{"xposition", "yposition", "zposition",
                                                        "xrotation", "yrotation", "zrotation"};

class BvhParser {
public:
    BvhParser(std::string_view text, const std::string& sourceName, const BvhOptions& options)
        : scanner_(text, sourceName), source_(sourceName), options_(options) {}

    Result<BvhMotion> parse() {
        if (options_.unit != 0.0 && !(options_.unit >= 1e-6 && options_.unit <= 1e3))
            return invalidArgument("unit: expected 0.000001 to 1000 m");
        Status status = hierarchy();
        if (status.ok()) status = head();
        if (status.ok()) status = values();
        if (status.ok()) status = toOurs();
        if (!status.ok()) return status;
        return std::move(motion_);
    }

private:
    Status expect(std::string_view keyword) {
        return sameWord(scanner_.word(), keyword)
                   ? Status()
                   : scanner_.unexpected(std::string("\"").append(keyword).append("\""));
    }

    Status hierarchy() {
        if (Status s = expect("HIERARCHY"); !s.ok()) return s;
        if (Status s = expect("ROOT"); !s.ok()) return s;
        if (Status s = beginJoint(); !s.ok()) return s;
        while (true) {
            const std::string word = lowered(scanner_.word());
            Status status;
            if (open_ < 0 && word == "motion") return {};
            if (open_ < 0 && word == "root")
                status = beginJoint();
            else if (open_ < 0)
                status = scanner_.unexpected("\"ROOT\" or \"MOTION\"");
            else
                status = jointEntry(word);
            if (!status.ok()) return status;
        }
    }

    Status beginJoint() {
        if (motion_.joints.size() >= kMaxBvhJoints)
            return {StatusCode::LimitExceeded,
                    source_ + ": found more than " + std::to_string(kMaxBvhJoints) + " joints"};
        BvhJoint joint;
        joint.name = std::string(scanner_.restOfLine().substr(0, 100));
        joint.parent = open_;
        open_ = static_cast<std::int32_t>(motion_.joints.size());
        motion_.joints.push_back(std::move(joint));
        channels_.emplace_back();
        return expect("{");
    }

    /// Parses one entry of a joint whose first word is already read.
    Status jointEntry(const std::string& word) {
        BvhJoint& joint = motion_.joints[open_];
        if (word == "offset") return point(joint.offset);
        if (word == "channels") return channels();
        if (word == "joint") return beginJoint();
        if (word == "end" || word == "endsite") return endSite(joint);
        if (word != "}") return scanner_.unexpected("OFFSET, CHANNELS, JOINT, End Site or \"}\"");
        open_ = joint.parent;
        return {};
    }

    Status endSite(BvhJoint& joint) {
        scanner_.restOfLine();
        if (Status s = expect("{"); !s.ok()) return s;
        if (Status s = expect("OFFSET"); !s.ok()) return s;
        if (joint.ends.size() >= kMaxBvhJoints) return scanner_.unexpected("at most 1000 end sites");
        if (Status s = point(joint.ends.emplace_back()); !s.ok()) return s;
        return expect("}");
    }

    Status point(Vec3& p) {
        double xyz[3];
        for (double& number : xyz)
            if (!scanner_.number(number) || std::fabs(number) > kLargestOffset)
                return scanner_.unexpected("a coordinate");
        p = {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
        return {};
    }

    Status channels() {
        std::vector<Channel>& mine = channels_.back();
        std::size_t count = 0;
        if (static_cast<std::size_t>(open_) + 1 != channels_.size() || !mine.empty())
            return scanner_.unexpected("CHANNELS once, before the joint's children");
        if (!scanner_.count(count) || count > 6)
            return scanner_.unexpected("a number of channels from 0 to 6");
        for (std::size_t i = 0; i < count; ++i) {
            const std::string name = lowered(scanner_.word());
            const auto found = std::find(kChannelNames.begin(), kChannelNames.end(), name);
            const auto channel = static_cast<Channel>(found - kChannelNames.begin());
            if (found == kChannelNames.end() || std::find(mine.begin(), mine.end(), channel) != mine.end())
                return scanner_.unexpected("six different channels such as Xposition or Zrotation");
            mine.push_back(channel);
            if (channel < 3) motion_.joints.back().moves = true;
        }
        columns_ += count;
        return {};
    }

    /// Parses "Frames: N" and "Frame Time: T".
    Status head() {
        if (!sameWord(scanner_.keyword(), "frames")) return scanner_.unexpected("\"Frames:\"");
        scanner_.skipColons();
        if (!scanner_.count(motion_.frames) || motion_.frames == 0)
            return scanner_.unexpected("a number of frames > 0");
        std::string word = lowered(scanner_.keyword());
        if (word == "frame") word += lowered(scanner_.keyword());
        if (word != "frametime") return scanner_.unexpected("\"Frame Time:\"");
        scanner_.skipColons();
        double seconds = 0.0;
        if (!scanner_.number(seconds) || !(seconds >= 1e-5 && seconds <= 100.0))
            return scanner_.unexpected("a frame time of 0.00001 to 100 s");
        motion_.rate = 1.0 / seconds;
        const double whole = std::floor(motion_.rate + 0.5);
        if (std::fabs(motion_.rate - whole) <= kRateGrain * whole) motion_.rate = whole;
        if (columns_ == 0) return scanner_.unexpected("channels", "no channel in any joint");
        if (motion_.frames > kMaxBvhValues / motion_.joints.size())
            return {StatusCode::LimitExceeded, source_ + ": found " + std::to_string(motion_.frames) +
                                                   " frames of " + std::to_string(motion_.joints.size()) +
                                                   " joints, expected at most " +
                                                   std::to_string(kMaxBvhValues) + " in all"};
        if (scanner_.left() / 2 + 1 < motion_.frames * columns_)
            return scanner_.unexpected(std::to_string(motion_.frames * columns_) + " numbers behind it",
                                       "a file too short");
        return {};
    }

    Status values() {
        motion_.values.resize(motion_.frames * motion_.joints.size());
        for (std::size_t f = 0, at = 0; f < motion_.frames; ++f) {
            for (std::size_t j = 0; j < motion_.joints.size(); ++j, ++at)
                if (Status s = value(j, motion_.values[at]); !s.ok()) return s;
        }
        if (!scanner_.word().empty()) return scanner_.unexpected("the end of the file");
        return {};
    }

    /// Reads the channels of one joint in one frame, in the file's axes and units.
    Status value(std::size_t joint, Transform& out) {
        static constexpr Vec3 kAxes[3] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
        for (const Channel channel : channels_[joint]) {
            double number = 0.0;
            if (!scanner_.number(number)) return scanner_.unexpected("a number");
            if (channel < 3) {
                (channel == 0   ? out.translation.x
                 : channel == 1 ? out.translation.y
                                : out.translation.z) = static_cast<float>(number);
            } else {
                out.rotation = normalized(out.rotation *
                                          axisAngle(kAxes[channel - 3], number * (kPi / 180.0)));
            }
        }
        return {};
    }

    /// In some programs position channels replace the offset, in others they are added to it. The first frame
    /// decides which is meant.
    void addOffsets() {
        const std::size_t count = motion_.joints.size();
        for (std::size_t j = 0; j < count; ++j) {
            const Vec3 offset = motion_.joints[j].offset, first = motion_.values[j].translation;
            if (motion_.joints[j].moves && distance(first, offset) <= length(first)) continue;
            for (std::size_t f = 0; f < motion_.frames; ++f)
                motion_.values[f * count + j].translation += offset;
        }
    }

    Status toOurs() {
        addOffsets();
        motion_.unit = options_.unit;
        if (motion_.unit == 0.0) {
            const auto unit = guessUnit(motion_.joints);
            if (!unit.ok()) return unit.status().within(source_);
            motion_.unit = *unit;
        }
        const AxisMap axes = guessAxes(motion_.joints, motion_.frame(0));
        const auto scale = static_cast<float>(motion_.unit);
        for (BvhJoint& joint : motion_.joints) {
            joint.offset = axes.apply(joint.offset) * scale;
            for (Vec3& end : joint.ends) end = axes.apply(end) * scale;
        }
        for (Transform& value : motion_.values)
            value = {axes.apply(value.rotation), axes.apply(value.translation) * scale};
        return {};
    }

    BvhScanner scanner_;
    const std::string& source_;
    BvhOptions options_;
    BvhMotion motion_;
    std::vector<std::vector<Channel>> channels_;  ///< Channels of each joint, in the file's order.
    std::size_t columns_ = 0;
    std::int32_t open_ = -1;
};

}  // namespace

Result<BvhMotion> parseBvh(std::string_view text, const std::string& sourceName, const BvhOptions& options) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    return BvhParser(text, sourceName, options).parse();
}

Result<BvhMotion> readBvh(const std::string& path, const BvhOptions& options) {
    const auto text = readTextFile(path, kMaxBvhBytes);
    if (!text.ok()) return text.status();
    return parseBvh(*text, path, options);
}

}  // namespace muster
