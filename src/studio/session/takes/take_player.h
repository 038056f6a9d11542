// The replay of a take in the studio: forwards, to any moment, over and over (docs/protocol.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "files/take/replayer.h"
#include "files/take/take_frames.h"
#include "muster/take.h"
#include "studio/session/frames/motion_frames.h"
#include "studio/session/inbox/protocol.h"
#include "studio/session/takes/edit_history.h"
#include "studio/session/takes/player_edits.h"
#include "studio/session/takes/take_moments.h"
#include "studio/session/takes/take_news.h"
#include "studio/session/takes/take_paths.h"

namespace muster {

/// A take that a world shows. The world and the motion are the caller's.
///
/// A second world, the scout, runs ahead of the shown one in prepare() and leaves a snapshot each second.
class TakePlayer {
public:
    /// `fileName` is the take's name on the shelf, empty where it lies elsewhere. The clips must outlive
    /// this.
    TakePlayer(std::shared_ptr<Take> take, std::string fileName);
    /// Plays a take whose marks have no hashes yet, and puts them there while it is read.
    static std::unique_ptr<TakePlayer> marking(std::shared_ptr<Take> take);

    /// Plays a take that this Muster simulates otherwise: from its stored frames.
    static std::unique_ptr<TakePlayer> storedFrames(std::shared_ptr<Take> take, std::string fileName);

    const Take& take() const { return *take_; }                        ///< What is played.
    std::shared_ptr<Take> shared() const { return take_; }             ///< The same.
    bool stored() const { return stored_; }                            ///< True where it plays stored frames.
    const std::string& fileName() const { return fileName_; }          ///< Its name on the shelf.
    const TakeAbout& about() const { return about_; }                  ///< Title, part and speeds.
    std::uint32_t steps() const { return replayer_.steps(); }          ///< Steps of the whole take.
    std::uint32_t first() const { return about_.firstStep(steps()); }  ///< First step of the part.
    std::uint32_t last() const { return about_.lastStep(steps()); }    ///< Last step of the part.
    bool loops() const { return loop_; }                               ///< True where it plays over and over.
    std::uint32_t unmarked() const { return replayer_.unmarked(); }    ///< As Replayer::unmarked().
    Replayer::Cursor cursor() const { return replayer_.cursor(); }     ///< How far it has come.
    /// Seconds of the take per second, in the world's present step.
    double speed(const World& world) const { return about_.speedAt(world.time()); }
    /// True where the part ends with the world's step.
    bool atEnd(const World& world) const { return world.stepCount() >= last(); }

    /// Another title, part and speeds; edits of people stay.
    void edit(TakeAbout about, bool loop);
    /// Other edits of people, shown by the clips of a library, which must outlive this.
    void setEdits(std::vector<TakeEdit> edits, const ClipLibrary& library);
    /// The present moment is to be shown again, by the edits as they are now.
    void showAgain(const World& world);
    /// How edited people are shown after the world's step.
    std::span<const ShownCharacter> shown(const World& world) { return edits_.shown(world); }
    EditHistoryList& history() { return history_; }  ///< What was done to the edits.

    /// One step. Fails, naming the step, where it differs from the take.
    Status step(World& world, const std::function<void()>& stepped);
    /// Keeps a snapshot of the present step where one is missing. Call before the first step, and after each.
    void keep(const World& world, const MotionFrames& motion);

    /// Asks for a moment of the take; seek() brings it.
    void want(std::uint32_t step) { wanted_ = std::min(step, steps()); }
    bool seeking() const { return wanted_.has_value(); }  ///< True until it is reached.
    void stay() { wanted_.reset(); }                      ///< Asks for no moment any more.
    /// Goes to the best snapshot towards the wanted moment; true where the world has jumped.
    bool jump(World& world, MotionFrames& motion);
    /// True where somebody is edited or was.
    bool edited() const { return !edits_.touched().empty(); }
    /// Call after every step; true where the wanted moment has just been reached.
    bool reached(const World& world);
    std::uint32_t wanted() const { return wanted_.value_or(0); }  ///< The moment asked for.

    /// True while the scout has not read the whole take.
    bool preparing() const { return !scouted_; }
    /// True while it is reading again what edits need.
    bool gathering() const { return edits_.gathering(); }
    /// A step of the scout, or of what edits need; true where people are shown otherwise afterwards.
    bool prepare(const MotionFrames& motion);
    /// Steps up to which seeks are quick.
    std::uint32_t ready() const { return scouted_ ? steps() : moments_.last(); }
    const TakeMoments& moments() const { return moments_; }  ///< The snapshots.
    const TakePaths& paths() const { return paths_; }        ///< Whole as soon as nothing is preparing.
    const TakeNews& news() const { return news_; }           ///< As `paths`.
    bool marks() const { return marking_; }                  ///< True until the marks are kept.
    /// True where the marks of a take that had none are all there, and it waits to be kept.
    bool marked() const { return marking_ && scouted_; }
    /// It is kept under that name on the shelf, empty for none.
    void kept(std::string fileName);

    /// What the page knows of the take.
    protocol::TakeState state() const;

private:
    struct Scout {
        World world;
        Replayer replayer;
        CrowdMotion motion;
    };
    void beginScout(const MotionFrames& motion);
    void scout(const MotionFrames& motion);
    Replayer replayer();
    void storeFrames(const World& world);

    std::shared_ptr<Take> take_;
    bool marking_ = false;
    bool stored_ = false;
    std::string fileName_;
    TakeAbout about_;
    bool loop_ = false;
    Replayer replayer_;
    std::optional<std::uint32_t> wanted_;
    TakeMoments moments_;
    TakePaths paths_;
    TakeNews news_;
    PlayerEdits edits_;
    EditHistoryList history_;
    bool stale_ = false;  // True where the present moment is to be shown again.
    std::unique_ptr<Scout> scout_;
    bool scouted_ = false;
    FrameRecorder frames_;  // Of a take whose marks are made.
    std::vector<protocol::TakeMark> marks_;
};

/// Touches with their lengths, orders, other commands and events, in ascending order of steps; at most 2,000.
/// Of more, later ones of the same kind and label within a quarter of a second are left out, then the rest.
std::vector<protocol::TakeMark> takeMarks(const Take& take);

}  // namespace muster
