// Draws the fields of random commands, and what the fields of one command have to be together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "generated/random_definitions.h"
#include "muster/command.h"

namespace muster {

class CommandDraw : public DefinitionDraw {
public:
    using DefinitionDraw::DefinitionDraw;
    using DefinitionDraw::relate;

    /// One to four different ids.
    std::vector<std::uint32_t> ids() {
        std::vector<std::uint32_t> found;
        for (std::int32_t k = whole(1, 4), id = whole(1, 1000000); k > 0; --k)
            found.push_back(static_cast<std::uint32_t>(id += 3));
        return found;
    }

    // Makes the fields of a command fit each other; most do so already.
    void relate(AddControl& c) {
        c.touches = ids();
        c.positions.assign(c.touches.size(), place());
        c.kind = static_cast<ControlKind>(std::min<std::size_t>(c.touches.size(), 3) - 1);
    }
    void relate(Touch& c) {
        if (c.phase == TouchPhase::Up || c.phase == TouchPhase::Cancel) c.position = {};
        if (c.phase == TouchPhase::Cancel) c.time = 0.0;
    }
    void relate(PutThing& c) {
        const PutThing all{c.id,
                           randomObstacleDef(*this),
                           randomPatchDef(*this),
                           randomItemDef(*this),
                           randomCheckpointDef(*this),
                           randomAreaDef(*this),
                           c.group};
        c = {c.id, {}, {}, {}, {}, {}, c.group};
        const auto thing = value<ThingKind>();
        if (thing == ThingKind::Obstacle) c.obstacle = all.obstacle;
        if (thing == ThingKind::Patch) c.patch = all.patch;
        if (thing == ThingKind::Item) c.item = all.item;
        if (thing == ThingKind::Checkpoint) c.checkpoint = all.checkpoint;
        if (thing == ThingKind::Area) c.area = all.area;
    }
    void relate(SetParameter& c) {
        c.name = "plan.exponent";
        c.value = real(1, 4);
    }
    void relate(AddCharacters& c) { c.bodies.resize(flag() ? 1 : c.positions.size(), randomBody(*this)); }
    void relate(SplitGroup& c) {
        if (c.by == SplitBy::Line) c.points = {place(), {2e3, 0}};
        if (c.by == SplitBy::Lasso) c.points = {place(), place(), {2e3, 0}};
        c.shares = {real(0.1, 2), real(0.1, 2)};
    }
    void relate(MergeGroups& c) { c.groups = {GroupId{number()}, GroupId{1000001}}; }
    void relate(ChangeGroup& c) {
        if (c.demands) c.demands->resize(3, 1.0);
        if (!c.formation && !c.count && !c.people && !c.conduct && !c.roles && !c.demands && !c.colour &&
            !c.look)
            c.name = text();
    }
    void relate(ChangeCharacters& c) {
        if (!c.driver || c.bodies) c.bodies.emplace(flag() ? 1 : c.ids.size(), randomBody(*this));
    }
    void relate(WriteMotion& c) {
        c.positions.resize(c.ids.size(), place());
        c.velocities.resize(flag() ? 0 : c.ids.size());
    }
};

}  // namespace muster
