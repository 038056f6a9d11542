// What the screen has shown lately, so that an operator sees it with a delay.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "studio/study/trial/trial.h"

namespace muster {

/// What an operator sees of a trial: nothing that the screen does not show.
struct SeenScene {
    double time = 0.0;                    ///< When the screen showed it [s].
    std::vector<Vec2> positions;          ///< Of all characters, in the order of ids [m].
    std::vector<std::uint32_t> ids;       ///< Their ids.
    std::vector<std::uint32_t> groups;    ///< Per character, the id of its formation.
    std::vector<std::uint32_t> busy;      ///< Ids of formations with a drawn way or a queue ahead, ascending.
    std::vector<std::uint8_t> collected;  ///< Per item: 1 once it has gone.
    std::vector<std::uint32_t> selected;  ///< Ids of the selected.
};

/// Remembers some seconds of scenes.
class SceneMemory {
public:
    /// Looks at the screen; call before every step.
    void look(const Trial& trial);
    /// The newest scene that is not younger than `time` says; the oldest that is known where all are.
    const SeenScene& at(double time) const;
    /// True once there is one.
    bool any() const { return !scenes_.empty(); }

private:
    std::deque<SeenScene> scenes_;
};

}  // namespace muster
