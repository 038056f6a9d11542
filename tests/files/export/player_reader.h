// Reads files of players for tests, by the description of the format in docs/player.md; shares no code with
// the writer.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace muster::testing {

/// Numbers of an adaptive range coder.
class PlayerNumbers {
public:
    struct Bit {
        int quick = 32768, slow = 32768;
    };
    struct Number {
        std::array<Bit, 32> length;
        std::array<Bit, 96> leading;
        Bit sign;
    };

    explicit PlayerNumbers(std::string bytes) : bytes_(std::move(bytes)) {
        for (int k = 0; k < 5; ++k) code_ = code_ << 8 | next();
    }

    bool bit(Bit& model) {
        const std::uint64_t bound = std::uint64_t{range_ >> 15} *
                                    static_cast<std::uint64_t>((model.quick + model.slow) / 4);
        const bool one = below(bound);
        if (one) {
            model.quick -= model.quick / 16;
            model.slow -= model.slow / 128;
        } else {
            model.quick += (65535 - model.quick) / 16;
            model.slow += (65535 - model.slow) / 128;
        }
        return one;
    }

    std::uint32_t plain(int count) {
        std::uint32_t value = 0;
        for (int k = 0; k < count; ++k) value = value * 2 + (below(range_ / 2) ? 1 : 0);
        return value;
    }

    std::uint32_t natural(Number& model) {
        std::size_t length = 0;
        while (length < 31 && bit(model.length[length])) ++length;
        std::uint64_t value = 1;
        std::size_t seen = 0;
        for (std::size_t k = 0; k < length; ++k) {
            bool one = false;
            if (k < 2) {
                one = bit(model.leading[3 * length + seen]);
                seen = one ? 2 : 1;
            } else {
                one = plain(1) == 1;
            }
            value = value * 2 + (one ? 1 : 0);
        }
        return static_cast<std::uint32_t>(value - 1);
    }

    std::int64_t whole(Number& model) {
        const std::int64_t size = natural(model);
        return size != 0 && bit(model.sign) ? -size : size;
    }

    /// True where all bytes were needed and no more.
    bool exhausted() const { return at_ == bytes_.size(); }

private:
    bool below(std::uint64_t bound) {
        const bool one = code_ >= bound;
        if (one) code_ -= bound, range_ -= static_cast<std::uint32_t>(bound);
        if (!one) range_ = static_cast<std::uint32_t>(bound);
        while (range_ < 0x1000000u) {
            range_ *= 256u;
            code_ = (code_ << 8 | next()) & 0xFFFFFFFFu;
        }
        return one;
    }
    std::uint64_t next() {
        return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : (++at_, 0u);
    }

    std::string bytes_;
    std::size_t at_ = 0;
    std::uint64_t code_ = 0;
    std::uint32_t range_ = 0xFFFFFFFFu;
};

/// The parts of a file by their tags. Throws where lengths do not fit.
inline std::map<std::string, std::string> playerParts(const std::string& file) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(file.at(at + k));
        return value;
    };
    if (file.substr(0, 8) != "MUSTERPL" || word(8) != 2 || word(12) != file.size())
        throw std::runtime_error("no file of a player");
    std::map<std::string, std::string> parts;
    for (std::size_t at = 20; at < file.size(); at += 8 + word(at + 4))
        parts[file.substr(at, 4)] = file.substr(at + 8, word(at + 4));
    return parts;
}

/// A character in a frame as the file has it.
struct PlayedCharacter {
    std::uint32_t id = 0;
    std::int64_t x = 0, y = 0, yaw = 0;  ///< In 5 mm and 1/512 turns.
    std::int64_t time = 0;               ///< Of the clip, in 1/256 s.
    std::uint32_t clip = 0, colour = 0;
    bool narrow = false;
    std::int64_t scale = 100;
    std::int64_t stepX = 0, stepY = 0, turn = 0, advance = 0;
    std::size_t stir = 0, turned = 0, paced = 0, switched = 0;
    bool fresh = true;
};

/// A clip's duration in 1/256 s, and whether it goes round.
struct PlayedDuration {
    std::int64_t duration = 1;
    bool cyclic = true;
};

/// Reads frames, one after the other.
class PlayerFrames {
public:
    PlayerFrames(std::string bytes, std::vector<PlayedDuration> clips, std::size_t things)
        : numbers_(std::move(bytes)), clips_(std::move(clips)), things_(things) {}

    const std::vector<PlayedCharacter>& next() {
        for (PlayedCharacter& c : characters_) c.fresh = false;
        if (numbers_.bit(changed_)) change();
        for (PlayedCharacter& c : characters_)
            if (!c.fresh) move(c);
        for (auto& thing : things_)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t by = numbers_.whole(k < 2 ? thingPlace_ : thingAngle_);
                const std::int64_t now = thing.value[k] + (begun_ ? thing.step[k] : 0) + by;
                thing.step[k] = begun_ ? now - thing.value[k] : 0;
                thing.value[k] = now;
            }
        begun_ = true;
        return characters_;
    }
    /// x, y [5 mm] and angle [1/4096 turn] of a moving thing.
    const std::array<std::int64_t, 3>& thing(std::size_t k) const { return things_[k].value; }
    bool exhausted() const { return numbers_.exhausted(); }

private:
    using Bit = PlayerNumbers::Bit;
    using Number = PlayerNumbers::Number;
    struct Thing {
        std::array<std::int64_t, 3> value{}, step{};
    };

    static std::int64_t around(std::int64_t value, std::int64_t turn) {
        return ((value % turn) + turn) % turn;
    }

    void change() {
        const std::uint32_t gone = numbers_.natural(gone_);
        std::vector<std::size_t> leaving;
        for (std::uint32_t k = 0; k < gone; ++k)
            leaving.push_back((leaving.empty() ? 0 : leaving.back()) + numbers_.natural(gone_));
        for (std::size_t k = leaving.size(); k-- > 0;)
            characters_.erase(characters_.begin() + static_cast<std::ptrdiff_t>(leaving[k]));
        const std::uint32_t came = numbers_.natural(came_);
        std::uint32_t id = 0;
        for (std::uint32_t k = 0; k < came; ++k) {
            PlayedCharacter c;
            c.id = id += numbers_.natural(ids_);
            c.narrow = numbers_.bit(body_);
            c.scale = 100 + numbers_.whole(scale_);
            c.colour = numbers_.natural(colour_);
            c.x = lastX_ += numbers_.whole(place_);
            c.y = lastY_ += numbers_.whole(place_);
            c.yaw = numbers_.whole(heading_);
            c.clip = numbers_.natural(clip_);
            c.time = numbers_.natural(time_);
            characters_.push_back(c);
        }
        std::sort(characters_.begin(), characters_.end(),
                  [](const auto& a, const auto& b) { return a.id < b.id; });
    }

    void move(PlayedCharacter& c) {
        const std::int64_t byX = numbers_.whole(step_[c.stir]), byY = numbers_.whole(step_[c.stir]);
        const std::int64_t stir = std::abs(byX) + std::abs(byY);
        c.stir = stir == 0 ? 0 : stir < 3 ? 1 : 2;
        c.x += c.stepX += byX;
        c.y += c.stepY += byY;
        const std::int64_t turn = numbers_.whole(turn_[c.turned]);
        c.turned = turn == 0 ? 0 : 1;
        c.yaw += c.turn += turn;
        if (numbers_.bit(recoloured_)) c.colour = numbers_.natural(colour_);
        const bool switched = numbers_.bit(switched_[c.switched]);
        c.switched = switched ? 1 : 0;
        if (!switched) {
            const std::int64_t by = numbers_.whole(pace_[c.paced]);
            c.paced = by == 0 ? 0 : 1;
            c.time += c.advance += by;
            if (clips_.at(c.clip).cyclic) c.time = around(c.time, clips_[c.clip].duration);
            return;
        }
        const std::int64_t before = clips_.at(c.clip).duration;
        c.clip = numbers_.natural(next_[c.clip]);
        numbers_.natural(fade_);
        const std::int64_t now = clips_.at(c.clip).duration;
        c.time = around(c.time * now / before + numbers_.whole(phase_), now + 1);
    }

    PlayerNumbers numbers_;
    std::vector<PlayedDuration> clips_;
    std::vector<PlayedCharacter> characters_;
    std::vector<Thing> things_;
    bool begun_ = false;
    std::int64_t lastX_ = 0, lastY_ = 0;
    Bit changed_, recoloured_, body_, switched_[2];
    Number gone_, came_, ids_, scale_, colour_, place_, heading_, clip_, time_, fade_, phase_;
    Number step_[3], turn_[2], pace_[2], thingPlace_, thingAngle_;
    std::map<std::uint32_t, Number> next_;
};

}  // namespace muster::testing
