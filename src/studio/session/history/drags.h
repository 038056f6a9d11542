// What a person drags by fingers, from the first that comes down to the last that lifts.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "muster/command.h"
#include "studio/session/history/step_record.h"

namespace muster {

/// What fingers of all directors drag. A drag is undone by ordering the pose and the formation from before.
class Drags {
public:
    /// What a message has to do with drags of its sender.
    struct Part {
        std::uint32_t drag = 0;            ///< Number of the one that is under way; 0 for none.
        std::vector<std::uint8_t> folds;   ///< By command: 1 where it belongs to that.
        std::vector<std::uint32_t> ended;  ///< Those that have ended and changed something.
    };

    /// A director gives these commands for the next step.
    Part note(std::uint32_t client, std::span<const CommandBody> bodies, const Scene& scene);
    /// A part of the drag of that number has led to this.
    void add(std::uint32_t drag, Difference difference);
    /// What the drag, which has ended, has changed.
    Difference take(std::uint32_t drag);
    void forget(std::uint32_t client);
    void clear();

private:
    struct Finger {
        std::uint32_t touch = 0;
        Vec2 from;  // Where it came down [m].
    };
    struct Drag {
        std::uint32_t number = 0;
        std::uint32_t step = 0;  // Of the world, at the last message about fingers.
        std::vector<Finger> fingers;
        std::vector<GroupId> groups;
        bool changed = false;
    };

    void down(std::uint32_t client, std::uint32_t touch, Vec2 at, GroupId group, const Scene& scene);
    void end(Part& part, std::uint32_t client);
    void hold(Drag& drag, GroupId group, const Scene& scene);
    void follow(std::uint32_t client, Drag& drag, const CommandBody& body, const Scene& scene);
    void endForgotten(Part& part, std::uint32_t client, const World& world);

    std::map<std::uint32_t, Drag> open_;               // By client.
    std::map<std::uint32_t, Difference> differences_;  // By number.
    std::uint32_t last_ = 0;
};

}  // namespace muster
