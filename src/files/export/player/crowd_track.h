// The frames of a crowd as one stream of numbers: who comes and goes, where everybody is and which clip they
// play. Each number is written as its difference to what the frames before let expect.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "files/export/exporter.h"
#include "files/export/player/range_encoder.h"
#include "people/bodies/body_mesh.h"

namespace muster {

/// What is written of a clip besides its poses: its number in the file follows from the order of first use.
struct PlayedClip {
    std::uint16_t index = 0;    ///< In the library.
    std::int32_t duration = 1;  ///< In units of time of clips.
    bool cyclic = true;
};

/// Writes frames. Give one frame after the other.
class CrowdTrack {
public:
    /// `clips` are those of the take; they must outlive this.
    explicit CrowdTrack(const ClipLibrary& clips) : library_(clips) {}

    /// Adds the characters of a frame.
    void frame(const ExportFrame& frame);
    /// Adds the places and angles of one moving thing of the frame that was added last.
    void thing(std::size_t which, Vec2 place, double angle);

    /// All numbers. Nothing can be added afterwards.
    std::string finish() { return coder_.finish(); }
    const std::vector<PlayedClip>& clips() const { return clips_; }  ///< Clips that occur.
    /// Shirts: below kAccents the number of an accent, else 0x1000000 + 0xRRGGBB.
    const std::vector<std::uint32_t>& colours() const { return colours_; }
    std::uint64_t samples() const { return samples_; }              ///< Characters in all frames together.
    std::size_t mostAtOnce() const { return most_; }                ///< Characters in the fullest frame.
    bool hasBody(std::size_t kind) const { return bodies_[kind]; }  ///< True where somebody has that body.

private:
    /// A number that moves on by about the same in each frame.
    struct Course {
        std::int32_t now = 0, before = 0;
        void begin(std::int32_t value) { now = before = value; }
        std::int32_t next() const { return 2 * now - before; }  ///< What is expected.
        void go(std::int32_t value) { before = now, now = value; }
    };
    /// A character as the frames so far tell of it.
    struct Member {
        std::uint32_t id = 0;
        Course x, y, yaw;
        std::int32_t time = 0, advance = 0;  ///< Of its clip, and by how much that went on.
        std::uint32_t clip = 0, colour = 0;
        float fade = 0.0f;
        /// How large the differences of the frame before were, of place, heading and time: 0 for none.
        std::size_t stir = 0, turned = 0, paced = 0, switched = 0;
    };
    /// A moving thing.
    struct Thing {
        Course x, y, angle;
    };

    void findColours(const World& world);
    void changeMembers(const ExportFrame& frame);
    void come(const ExportCharacter& character, const World& world);
    void move(Member& member, const ExportCharacter& character);
    void play(Member& member, const ExportCharacter& character);
    std::uint32_t clipNumber(std::uint16_t index);
    std::int32_t timeUnits(std::uint32_t clip, float time) const;

    const ClipLibrary& library_;
    RangeEncoder coder_;
    std::vector<Member> members_;  ///< In order of ids.
    std::vector<PlayedClip> clips_;
    std::map<std::uint16_t, std::uint32_t> clipNumbers_;
    std::vector<std::uint32_t> colours_;
    std::map<std::uint32_t, std::uint32_t> colourNumbers_;
    std::vector<std::uint32_t> groupColours_;  ///< Number of the colour of each group of the frame.
    std::int32_t lastPlace_[2] = {0, 0};       ///< Of who came last.
    std::vector<Thing> things_;
    double time_ = 0.0;    ///< Of the frame in the take [s].
    double passed_ = 0.0;  ///< Since the frame before [s].
    std::uint64_t samples_ = 0;
    std::size_t most_ = 0;
    bool bodies_[2] = {false, false};

    // Models of the numbers; the reader has the same.
    BitModel changed_, recoloured_, body_, switched_[2];
    NumberModel gone_, came_, ids_, scale_, colour_, place_, heading_, clip_, clipTime_, fade_, phase_;
    NumberModel step_[3], turn_[2], pace_[2];
    std::map<std::uint32_t, NumberModel> nextClip_;  ///< By the clip before.
    NumberModel thingPlace_, thingAngle_;
};

/// The skeleton, then for each kind of body that `track` has seen its fine and its coarse mesh.
std::string playerBodies(const CrowdTrack& track);
/// The poses of clips, in their order.
std::string playerClips(const ClipLibrary& library, std::span<const PlayedClip> clips);

}  // namespace muster
