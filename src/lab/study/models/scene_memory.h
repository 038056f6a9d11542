// Pictures of the screen from the last seconds, so that an operator sees it with a delay.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "studio/study/trial/trial.h"

namespace muster {

/// The scene of a trial as an operator sees it: nothing that the screen does not show.
struct SeenScene {
    double time = 0.0;                    ///< Time at which the screen showed it [s].
    std::vector<Vec2> positions;          ///< Positions of all characters, in the order of ids [m].
    std::vector<std::uint32_t> ids;       ///< Ids of all characters.
    std::vector<std::uint32_t> groups;    ///< By character: the id of its formation.
    std::vector<std::uint32_t> busy;      ///< Ids of formations with a drawn way or a queue ahead, ascending.
    std::vector<std::uint8_t> collected;  ///< By item: 1 once it has gone.
    std::vector<std::uint32_t> selected;  ///< Ids of the selected characters.
};

/// Remembers some seconds of scenes.
class SceneMemory {
public:
    /// Looks at the screen; call before every step.
    void look(const Trial& trial);
    /// The newest scene that is not younger than `time` says; the oldest known one where all are.
    const SeenScene& at(double time) const;
    /// True once there is a scene.
    bool any() const { return !scenes_.empty(); }

private:
    std::deque<SeenScene> scenes_;
};

}  // namespace muster
