// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// Random commands of every kind.
#pragma once

#include "command_draw.h"
#include "generated/random_definitions.h"

namespace muster {

/// A valid command of that kind, an index into CommandKinds.
inline CommandBody randomCommand(std::size_t kind, CommandDraw& draw) {
    switch (kind) {
        case 0: {
            Touch c;
            c.phase = draw.value<TouchPhase>();
            c.touch = draw.number();
            c.position = draw.place();
            c.time = draw.real(0, 1e9);
            if (draw.flag()) c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 1: {
            AddControl c;
            c.group = GroupId{draw.number()};
            c.kind = draw.value<ControlKind>();
            draw.list(c.touches, [&] { return draw.number(); });
            draw.list(c.positions, [&] { return draw.place(); });
            c.time = draw.real(0, 1e9);
            draw.relate(c);
            return c;
        }
        case 2: {
            EditControl c;
            c.group = GroupId{draw.number()};
            c.control = ControlId{draw.number()};
            c.edit = draw.value<ControlEdit>();
            draw.relate(c);
            return c;
        }
        case 3: {
            ReleaseClient c;
            c.unused = std::uint8_t{0};
            draw.relate(c);
            return c;
        }
        case 4: {
            ChangeGroup c;
            c.group = GroupId{draw.number()};
            if (draw.flag()) c.formation = randomFormationDef(draw);
            if (draw.flag()) c.count = draw.whole(1, 200000);
            if (draw.flag()) draw.list(c.people.emplace(), [&] { return randomPeopleDef(draw); });
            if (draw.flag()) c.conduct = randomConduct(draw);
            if (draw.flag()) draw.list(c.roles.emplace(), [&] { return randomRoleDef(draw); });
            if (draw.flag()) draw.list(c.demands.emplace(), [&] { return draw.real(0, 1000); });
            if (draw.flag()) c.name = draw.text();
            if (draw.flag()) c.colour = randomGroupColour(draw);
            if (draw.flag()) c.look = randomGroupLook(draw);
            draw.relate(c);
            return c;
        }
        case 5: {
            SetPose c;
            c.group = GroupId{draw.number()};
            c.position = draw.place();
            c.angle = draw.real(-1e6, 1e6);
            c.characters = draw.flag();
            draw.relate(c);
            return c;
        }
        case 6: {
            AddGroup c;
            c.group = randomGroupDef(draw);
            draw.relate(c);
            return c;
        }
        case 7: {
            RemoveGroup c;
            c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 8: {
            PutThing c;
            c.id = draw.number();
            if (draw.flag()) c.obstacle = randomObstacleDef(draw);
            if (draw.flag()) c.patch = randomPatchDef(draw);
            if (draw.flag()) c.item = randomItemDef(draw);
            if (draw.flag()) c.checkpoint = randomCheckpointDef(draw);
            if (draw.flag()) c.area = randomAreaDef(draw);
            if (draw.flag()) c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 9: {
            RemoveThing c;
            c.thing = draw.value<ThingKind>();
            c.id = draw.number();
            draw.relate(c);
            return c;
        }
        case 10: {
            SetParameter c;
            c.name = draw.text();
            c.value = draw.real(-1e9, 1e9);
            draw.relate(c);
            return c;
        }
        case 11: {
            GiveOrder c;
            c.group = GroupId{draw.number()};
            c.mode = draw.value<QueueMode>();
            c.index = draw.number();
            c.order = randomOrder(draw);
            draw.relate(c);
            return c;
        }
        case 12: {
            EditQueue c;
            c.group = GroupId{draw.number()};
            c.edit = draw.value<QueueEdit>();
            c.order = draw.number();
            draw.relate(c);
            return c;
        }
        case 13: {
            AddCharacters c;
            c.group = GroupId{draw.number()};
            draw.list(c.positions, [&] { return draw.place(); });
            draw.list(c.bodies, [&] { return randomBody(draw); });
            draw.relate(c);
            return c;
        }
        case 14: {
            TransferCharacters c;
            c.ids = draw.ids();
            if (draw.flag()) c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 15: {
            SplitGroup c;
            c.group = GroupId{draw.number()};
            c.by = draw.value<SplitBy>();
            c.ids = draw.ids();
            draw.list(c.points, [&] { return draw.place(); });
            draw.list(c.shares, [&] { return draw.real(0, 1e6); });
            c.abreast = draw.flag();
            c.shape = draw.value<PartShape>();
            draw.relate(c);
            return c;
        }
        case 16: {
            MergeGroups c;
            draw.list(c.groups, [&] { return GroupId{draw.number()}; });
            c.shape = draw.value<PartShape>();
            draw.relate(c);
            return c;
        }
        case 17: {
            ChangeCharacters c;
            c.ids = draw.ids();
            if (draw.flag()) draw.list(c.bodies.emplace(), [&] { return randomBody(draw); });
            if (draw.flag()) c.driver = draw.value<Driver>();
            draw.relate(c);
            return c;
        }
        case 18: {
            WriteMotion c;
            c.ids = draw.ids();
            draw.list(c.positions, [&] { return draw.place(); });
            draw.list(c.velocities, [&] { return draw.place(); });
            draw.relate(c);
            return c;
        }
        case 19: {
            ReverseQueue c;
            c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        default:
            return Touch{};
    }
}

}  // namespace muster
