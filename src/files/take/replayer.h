// Replays a take step by step. The order in which commands are submitted and hashes are compared is defined
// here, for replayTake() and for the studio.
#pragma once

#include <cstdint>

#include "muster/take.h"

namespace muster {

/// Submits a take's commands to a new world and compares its hash marks. Until atEnd(), call submit(), step
/// the world, and call compare().
class Replayer {
public:
    /// The take must outlive this.
    explicit Replayer(const Take& take) : take_(&take), steps_(take.steps()) {}
    /// For a take whose marks have no hashes yet: they are put there instead of compared. It must outlive
    /// this.
    static Replayer marking(Take& take) {
        Replayer replayer(take);
        replayer.marked_ = &take;
        return replayer;
    }

    /// Puts characters where the take's stored frames say, and compares nothing. It must outlive this.
    static Replayer stored(const Take& take) {
        Replayer replayer(take);
        replayer.stored_ = true;
        return replayer;
    }

    /// True where the take has no further step.
    bool atEnd(const World& world) const { return world.stepCount() >= steps_; }
    std::uint32_t steps() const { return steps_; }        ///< Number of steps of the take.
    std::uint32_t compared() const { return compared_; }  ///< Marks that matched so far.
    std::uint64_t lastHash() const { return lastHash_; }  ///< The last hash compared; 0 before the first.
    /// Steps after the last mark; they are replayed but not compared.
    std::uint32_t unmarked() const { return steps_ - take_->markedSteps(); }

    /// How far a replay has come; with a snapshot of the world, all that it takes to go on from there.
    struct Cursor {
        std::size_t command = 0;     ///< Commands submitted.
        std::size_t mark = 0;        ///< Marks compared.
        std::size_t event = 0;       ///< Events compared.
        std::uint64_t lastHash = 0;  ///< As lastHash().
    };
    /// Valid between compare() and submit().
    Cursor cursor() const { return {nextCommand_, nextMark_, nextEvent_, lastHash_}; }
    /// Goes back or on, with the world.
    void goTo(const Cursor& cursor) {
        nextCommand_ = cursor.command, nextMark_ = cursor.mark, nextEvent_ = cursor.event;
        lastHash_ = cursor.lastHash;
        compared_ = static_cast<std::uint32_t>(cursor.mark);
    }

    /// Submits the commands recorded before the next mark. Fails like World::submit and compare().
    Status submit(World& world);
    /// Compares the marks and events of the world's step. Fails with Corrupt, naming the step, where a hash
    /// differs or the world does not raise an event of the take.
    Status compare(World& world);

private:
    Status submitUntil(World& world, std::size_t end);
    Status compareEvents(const World& world);
    Status putCharacters(World& world);

    const Take* take_;
    Take* marked_ = nullptr;  // The same take, where its marks are to be made.
    std::uint32_t steps_;     // Stored, because counting the steps takes long.
    bool stored_ = false;     // True where characters are put where frames say.
    std::size_t nextCommand_ = 0;
    std::size_t nextMark_ = 0;
    std::size_t nextEvent_ = 0;
    std::uint32_t compared_ = 0;
    std::uint64_t lastHash_ = 0;
};

}  // namespace muster
