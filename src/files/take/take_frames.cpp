#include "files/take/take_frames.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace muster {
namespace {

constexpr std::size_t kMostCharacters = 1u << 20;  // Of one frame.
constexpr std::size_t kCharactersPerStep = 170;    // Stored per step, about.
constexpr double kJump = 5.0;                      // Nobody walks farther between two frames [m].
constexpr std::uint32_t kSpacings[] = {3, 4, 5, 6, 10, 12, 15, 20, 30};

// Whole multiples of the grain.
std::int64_t grains(double metres) {
    return static_cast<std::int64_t>(std::floor(metres / kFrameGrain + 0.5));
}

class ByteWriter {
public:
    void number(std::uint64_t value) {
        for (; value >= 128; value >>= 7) bytes_.push_back(static_cast<std::uint8_t>(value | 128));
        bytes_.push_back(static_cast<std::uint8_t>(value));
    }
    void difference(std::int64_t value) {
        number((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
    }
    std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<std::uint8_t> bytes_;
};

class ByteReader {
public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    std::uint64_t number() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 63; shift += 7) {
            if (at_ >= bytes_.size()) break;
            const std::uint8_t byte = bytes_[at_++];
            value |= static_cast<std::uint64_t>(byte & 127) << shift;
            if (byte < 128) return value;
        }
        good_ = false;
        return 0;
    }
    std::int64_t difference() {
        const std::uint64_t value = number();
        return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
    }
    bool good() const { return good_; }
    bool atEnd() const { return at_ == bytes_.size(); }

private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
    bool good_ = true;
};

// What a frame's coordinates are predicted from: those of up to two frames before, of the same characters; in
// the first frame the neighbour before.
class Prediction {
public:
    // Numbers of the frame are x, y, x, y...
    void begin(bool sameIds) {
        if (!sameIds) before_.clear(), last_.clear();
        now_.clear();
    }
    std::int64_t next() const {
        const std::size_t k = now_.size();
        if (k < before_.size()) return 2 * last_[k] - before_[k];
        if (k < last_.size()) return last_[k];
        return k < 2 ? 0 : now_[k - 2];
    }
    void add(std::int64_t value) { now_.push_back(value); }
    void end() {
        before_.swap(last_);
        last_.swap(now_);
    }

private:
    std::vector<std::int64_t> before_, last_, now_;
};

bool readIds(ByteReader& reader, std::vector<std::uint32_t>& ids) {
    const std::uint64_t count = reader.number();
    if (!reader.good() || count > kMostCharacters) return false;
    ids.clear();
    std::uint64_t id = 0;
    for (std::uint64_t k = 0; k < count && reader.good(); ++k) {
        id += reader.number();
        if (id > 0xffffffffu) return false;
        ids.push_back(static_cast<std::uint32_t>(id));
    }
    return reader.good();
}

// Where a curve through four values is between the second and the third (Catmull and Rom 1974).
Vec2 curve(Vec2 a, Vec2 b, Vec2 c, Vec2 d, double t) {
    const Vec2 first = (c - a) * 0.5, last = (d - b) * 0.5;
    const double t2 = t * t, t3 = t2 * t;
    return b * (2 * t3 - 3 * t2 + 1) + first * (t3 - 2 * t2 + t) + c * (3 * t2 - 2 * t3) + last * (t3 - t2);
}

}  // namespace

std::vector<std::uint8_t> packFrames(std::span<const TakeFrame> frames) {
    ByteWriter writer;
    Prediction prediction;
    std::uint32_t step = 0;
    writer.number(frames.size());
    const std::vector<std::uint32_t>* ids = nullptr;
    for (const TakeFrame& frame : frames) {
        writer.number(frame.step - step);
        step = frame.step;
        const bool same = ids != nullptr && *ids == frame.ids;
        writer.number(same ? 1 : 0);
        if (!same) {
            writer.number(frame.ids.size());
            std::uint32_t last = 0;
            for (const std::uint32_t id : frame.ids) writer.number(id - std::exchange(last, id));
        }
        ids = &frame.ids;
        prediction.begin(same);
        for (const Vec2 p : frame.positions) {
            for (const double metres : {p.x, p.y}) {
                const std::int64_t value = grains(metres);
                writer.difference(value - prediction.next());
                prediction.add(value);
            }
        }
        prediction.end();
    }
    return writer.take();
}

Status unpackFrames(std::span<const std::uint8_t> bytes, std::vector<TakeFrame>& frames) {
    const Status bad(StatusCode::Corrupt, "found frames that cannot be read");
    ByteReader reader(bytes);
    std::vector<TakeFrame> read;
    Prediction prediction;
    std::uint64_t step = 0;
    const std::uint64_t count = reader.number();
    for (std::uint64_t k = 0; k < count; ++k) {
        TakeFrame frame;
        step += reader.number();
        const bool same = reader.number() == 1;
        if (!reader.good() || step > 0xffffffffu || (same && read.empty())) return bad;
        frame.step = static_cast<std::uint32_t>(step);
        if (same)
            frame.ids = read.back().ids;
        else if (!readIds(reader, frame.ids))
            return bad;
        const TakeFrame* before = read.empty() ? (frames.empty() ? nullptr : &frames.back()) : &read.back();
        if (before != nullptr && frame.step <= before->step) return bad;
        prediction.begin(same);
        for (std::size_t i = 0; i < 2 * frame.ids.size() && reader.good(); ++i) {
            const std::int64_t value = prediction.next() + reader.difference();
            constexpr std::int64_t kFarthest = std::int64_t{1} << 40;
            if (value > kFarthest || value < -kFarthest) return bad;
            prediction.add(value);
            const double metres = static_cast<double>(value) * kFrameGrain;
            if (i % 2 == 0)
                frame.positions.push_back({metres, 0.0});
            else
                frame.positions.back().y = metres;
        }
        if (!reader.good()) return bad;
        prediction.end();
        read.push_back(std::move(frame));
    }
    if (!reader.good() || !reader.atEnd()) return bad;
    frames.insert(frames.end(), std::make_move_iterator(read.begin()), std::make_move_iterator(read.end()));
    return {};
}

std::uint32_t storedFrameSpacing(std::size_t characters) {
    for (const std::uint32_t spacing : kSpacings)
        if (characters <= kCharactersPerStep * spacing) return spacing;
    return kSpacings[std::size(kSpacings) - 1];
}

bool FrameRecorder::observe(const World& world) {
    const CharactersView characters = world.characters();
    const std::uint32_t step = world.stepCount();
    if (frames_.empty() || step % storedFrameSpacing(characters.id.size()) == 0) {
        TakeFrame frame;
        frame.step = step;
        frame.ids.assign(characters.id.begin(), characters.id.end());
        frame.positions.assign(characters.position.begin(), characters.position.end());
        frames_.push_back(std::move(frame));
    }
    return step % kTakeMarkSpacing == 0;
}

std::vector<TakeFrame> FrameRecorder::take() {
    return std::exchange(frames_, {});
}

bool FrameCurve::at(std::uint32_t step, std::vector<std::uint32_t>& ids, std::vector<Vec2>& positions) const {
    const auto& frames = *frames_;
    const auto next = std::lower_bound(
        frames.begin(), frames.end(), step,
        [](const TakeFrame& frame, std::uint32_t at) { return frame.step < at; });
    if (next == frames.end() || (next == frames.begin() && next->step != step)) return false;
    ids.clear();
    positions.clear();
    if (next->step == step) {
        ids = next->ids;
        positions = next->positions;
        return true;
    }
    const TakeFrame &b = *(next - 1), &c = *next;
    const bool hasBefore = next - 1 != frames.begin() && (next - 2)->ids == b.ids;
    const bool hasAfter = next + 1 != frames.end() && (next + 1)->ids == c.ids;
    const double t = static_cast<double>(step - b.step) / (c.step - b.step);
    for (std::size_t k = 0, j = 0; k < b.ids.size(); ++k) {
        while (j < c.ids.size() && c.ids[j] < b.ids[k]) ++j;
        if (j >= c.ids.size() || c.ids[j] != b.ids[k]) continue;
        const Vec2 from = b.positions[k], to = c.positions[j];
        const Vec2 before = hasBefore ? (next - 2)->positions[k] : from * 2.0 - to;
        const Vec2 after = hasAfter ? (next + 1)->positions[j] : to * 2.0 - from;
        ids.push_back(b.ids[k]);
        // Who was put elsewhere is not drawn through what lies between.
        const bool far = lengthSquared(to - from) > kJump * kJump;
        positions.push_back(far ? from : curve(before, from, to, after, t));
    }
    return true;
}

}  // namespace muster
