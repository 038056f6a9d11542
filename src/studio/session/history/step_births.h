// Which ids a step has given to what commands have brought.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "muster/command.h"
#include "muster/event.h"
#include "muster/world.h"
#include "studio/session/history/names.h"

namespace muster {

/// What is new in the world after a step. Commands are asked about in the order in which the world has
/// applied them, each once, those that it has refused left out.
class StepBirths {
public:
    /// The step is about to be made. Does nothing until clear() has been called.
    void begin(const World& world);
    /// The step has been made.
    void end(const World& world);
    /// Ids of what the command has brought: one thing, several groups of a split, or characters. Empty for
    /// commands that bring nothing.
    std::vector<std::uint32_t> of(const CommandBody& body, const World& world);
    /// Ids of the new characters of a group, ascending.
    std::vector<std::uint32_t> newMembers(GroupId group, const World& world) const;
    bool begun() const { return begun_; }
    /// True for a character who has come by a source, or left by an exit, of itself.
    bool cameOrLeft(std::uint32_t character) const;
    void clear() { begun_ = false; }

private:
    std::vector<std::uint32_t> takeEvents(EventKind kind, std::uint32_t subject, std::uint32_t value,
                                          std::size_t most);
    std::vector<std::uint32_t> nextNew(SubjectKind kind, const World& world);

    bool begun_ = false;
    std::array<std::uint32_t, kSubjectKinds> highest_{};  // Ids before the step.
    std::vector<Event> events_;
    std::vector<std::uint32_t> ofThemselves_;  // Characters who have come or left, ascending.
    std::vector<Subject> known_;               // Ids that commands have been asked about, and of parts.
};

}  // namespace muster
