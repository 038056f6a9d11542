// People that leave a world by its exits or come into it by its sources: figures of an evacuation.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/world/generated/figures.h"
#include "muster/world.h"

namespace muster {

/// Watches people that leave and come.
class DepartureWatch {
public:
    /// Call before the first step and after every one.
    void observe(const World& world);
    /// The figures so far.
    DepartureFigures figures(const World& world) const;
    /// The step in which each person that left did, ascending.
    const std::vector<std::uint32_t>& leftAt() const { return leftAt_; }
    /// True while an open source may still send people to a group that is there.
    static bool moreMayCome(const World& world);

private:
    void listAreas(const World& world);

    std::vector<ExitFigures> exits_;      // Figures of all exits that have been there, by ascending ids.
    std::vector<SourceFigures> sources_;  // Figures of all sources that have been there, by ascending ids.
    std::vector<std::uint32_t> leftAt_;
    bool listed_ = false;
};

}  // namespace muster
