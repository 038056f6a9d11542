// A crowd of 64 follows one finger round a pillar.
#include <muster/world.h>

#include <cstdio>

int main() {
    muster::WorldDef def;  // Plain data: a box of ground, obstacles, groups, parameters.
    def.box = {{-32.0, -32.0}, {32.0, 32.0}};
    muster::ObstacleDef pillar;
    pillar.centre = {8.0, 0.0};
    pillar.radius = 1.5;
    def.obstacles.push_back(pillar);
    muster::GroupDef group;
    group.count = 64;
    def.groups.push_back(group);
    muster::Result<muster::World> made = muster::World::create(def);
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;

    // A finger comes down on the mesh, moves 16 m to the right in one second, and lifts. Commands wait for
    // their step.
    using muster::Touch, muster::TouchPhase;
    const muster::Vec2 start = world.group(0).finalMesh.front(), end = start + muster::Vec2{16.0, 0.0};
    bool accepted = world.submit({0, 1, 0, Touch{TouchPhase::Down, 1, start, 0.0, {}}}).ok();
    accepted &= world.submit({60, 1, 1, Touch{TouchPhase::Move, 1, end, 1.0, {}}}).ok();
    accepted &= world.submit({61, 1, 2, Touch{TouchPhase::Up, 1, {}, 61.0 / 60.0, {}}}).ok();
    for (int step = 0; step < 900; ++step)
        world.step();  // 15 s of 1/60 s each; the same bits on every machine.

    double mean = 0.0;
    for (const muster::Vec2 position : world.characters().position) mean += position.x / group.count;
    std::printf("after %.0f s the crowd stands %.1f m to the right, %.2f m from its places\n", world.time(),
                mean, world.group(0).meanLag);
    return accepted && mean > 12.0 ? 0 : 1;
}
