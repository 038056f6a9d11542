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
            TouchDown c;
            c.touch = draw.number();
            c.position = draw.place();
            c.time = draw.real(0, 1e9);
            if (draw.flag()) c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 1: {
            TouchMove c;
            c.touch = draw.number();
            c.position = draw.place();
            c.time = draw.real(0, 1e9);
            draw.relate(c);
            return c;
        }
        case 2: {
            TouchUp c;
            c.touch = draw.number();
            c.time = draw.real(0, 1e9);
            draw.relate(c);
            return c;
        }
        case 3: {
            TouchCancel c;
            c.touch = draw.number();
            draw.relate(c);
            return c;
        }
        case 4: {
            AddControl c;
            c.group = GroupId{draw.number()};
            c.kind = draw.value<ControlKind>();
            draw.list(c.touches, [&] { return draw.number(); });
            draw.list(c.positions, [&] { return draw.place(); });
            c.time = draw.real(0, 1e9);
            draw.relate(c);
            return c;
        }
        case 5: {
            PinControl c;
            c.group = GroupId{draw.number()};
            c.control = ControlId{draw.number()};
            c.pinned = draw.flag();
            draw.relate(c);
            return c;
        }
        case 6: {
            RemoveControl c;
            c.group = GroupId{draw.number()};
            c.control = ControlId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 7: {
            ReleaseClient c;
            c.unused = std::uint8_t{0};
            draw.relate(c);
            return c;
        }
        case 8: {
            SetFormation c;
            c.group = GroupId{draw.number()};
            c.formation = randomFormationDef(draw);
            draw.relate(c);
            return c;
        }
        case 9: {
            SetCount c;
            c.group = GroupId{draw.number()};
            c.count = draw.whole(1, 200000);
            draw.relate(c);
            return c;
        }
        case 10: {
            SetPose c;
            c.group = GroupId{draw.number()};
            c.position = draw.place();
            c.angle = draw.real(-1e6, 1e6);
            draw.relate(c);
            return c;
        }
        case 11: {
            AddGroup c;
            c.group = randomGroupDef(draw);
            draw.relate(c);
            return c;
        }
        case 12: {
            RemoveGroup c;
            c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 13: {
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
        case 14: {
            RemoveThing c;
            c.thing = draw.value<ThingKind>();
            c.id = draw.number();
            draw.relate(c);
            return c;
        }
        case 15: {
            SetParameter c;
            c.name = draw.text();
            c.value = draw.real(-1e9, 1e9);
            draw.relate(c);
            return c;
        }
        case 16: {
            GiveOrder c;
            c.group = GroupId{draw.number()};
            c.mode = draw.value<QueueMode>();
            c.index = draw.number();
            c.order = randomOrder(draw);
            draw.relate(c);
            return c;
        }
        case 17: {
            EditQueue c;
            c.group = GroupId{draw.number()};
            c.edit = draw.value<QueueEdit>();
            c.order = draw.number();
            draw.relate(c);
            return c;
        }
        case 18: {
            SetConduct c;
            c.group = GroupId{draw.number()};
            c.conduct = randomConduct(draw);
            draw.relate(c);
            return c;
        }
        case 19: {
            AddCharacters c;
            c.group = GroupId{draw.number()};
            draw.list(c.positions, [&] { return draw.place(); });
            draw.list(c.bodies, [&] { return randomBody(draw); });
            draw.relate(c);
            return c;
        }
        case 20: {
            RemoveCharacters c;
            c.ids = draw.ids();
            draw.relate(c);
            return c;
        }
        case 21: {
            TransferCharacters c;
            c.ids = draw.ids();
            c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        case 22: {
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
        case 23: {
            MergeGroups c;
            draw.list(c.groups, [&] { return GroupId{draw.number()}; });
            c.shape = draw.value<PartShape>();
            draw.relate(c);
            return c;
        }
        case 24: {
            SetBodies c;
            c.ids = draw.ids();
            draw.list(c.bodies, [&] { return randomBody(draw); });
            draw.relate(c);
            return c;
        }
        case 25: {
            SetRoles c;
            c.group = GroupId{draw.number()};
            draw.list(c.roles, [&] { return randomRoleDef(draw); });
            draw.relate(c);
            return c;
        }
        case 26: {
            SetDemands c;
            c.group = GroupId{draw.number()};
            draw.list(c.demands, [&] { return draw.real(0, 1000); });
            draw.relate(c);
            return c;
        }
        case 27: {
            SetDriver c;
            c.ids = draw.ids();
            c.driver = draw.value<Driver>();
            draw.relate(c);
            return c;
        }
        case 28: {
            WriteMotion c;
            c.ids = draw.ids();
            draw.list(c.positions, [&] { return draw.place(); });
            draw.list(c.velocities, [&] { return draw.place(); });
            draw.relate(c);
            return c;
        }
        case 29: {
            PlaceGroup c;
            c.group = GroupId{draw.number()};
            c.position = draw.place();
            c.angle = draw.real(-1e6, 1e6);
            draw.relate(c);
            return c;
        }
        case 30: {
            NameGroup c;
            c.group = GroupId{draw.number()};
            c.name = draw.text();
            draw.relate(c);
            return c;
        }
        case 31: {
            ColourGroup c;
            c.group = GroupId{draw.number()};
            if (draw.flag()) c.colour = draw.number() & 0xffffffu;
            draw.relate(c);
            return c;
        }
        case 32: {
            SetAppearance c;
            c.group = GroupId{draw.number()};
            if (draw.flag()) c.build = draw.value<BodyBuild>();
            if (draw.flag()) c.motions = draw.value<MotionSet>();
            draw.relate(c);
            return c;
        }
        case 33: {
            SetPeople c;
            c.group = GroupId{draw.number()};
            draw.list(c.people, [&] { return randomPeopleDef(draw); });
            draw.relate(c);
            return c;
        }
        case 34: {
            ReverseQueue c;
            c.group = GroupId{draw.number()};
            draw.relate(c);
            return c;
        }
        default:
            return TouchDown{};
    }
}

}  // namespace muster
