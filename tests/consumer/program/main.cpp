// The smallest program a game would start from: a crowd, one finger, ten seconds.
#include <muster/world/world.h>

#include <cstdio>

int main() {
    muster::WorldDef def;
    muster::GroupDef group;
    group.count = 25;
    def.groups.push_back(group);
    muster::Result<muster::World> made = muster::World::create(def);
    if (!made.ok()) {
        std::fprintf(stderr, "%s\n", made.status().message().c_str());
        return 1;
    }
    muster::World& world = *made;
    const muster::Vec2 start = world.group(0).mesh->finalMesh().front();
    const auto submit = [&](std::uint32_t step, std::uint32_t sequence, muster::CommandBody body) {
        return world.submit({step, 1, sequence, std::move(body)});
    };
    bool accepted = submit(0, 0, muster::TouchDown{1, start, 0.0, {}}).ok();
    accepted = accepted && submit(30, 1, muster::TouchMove{1, {start.x + 6.0, start.y}, 0.5}).ok();
    accepted = accepted && submit(31, 2, muster::TouchUp{1, 31.0 / 60.0}).ok();
    for (int i = 0; i < 600; ++i) world.step();
    double mean = 0.0;
    for (const muster::Vec2 p : world.characters().position) mean += p.x / 25.0;
    std::printf("25 characters walked %.2f m on average\n", mean);
    return accepted && mean > 4.0 ? 0 : 1;
}
