// Records a take, replays it bit for bit, and exports it as glTF. Usage: record_export [FOLDER]
#include <muster/export.h>
#include <muster/own_clips.h>
#include <muster/take.h>
#include <muster/world.h>

#include <cstdio>
#include <string>

namespace {

int fail(const muster::Status& status) {
    std::fprintf(stderr, "%s\n", status.message().c_str());
    return 1;
}

/// Plays three seconds and records them. A take holds the definition, the commands and some hashes.
muster::Status record(const std::string& path) {
    muster::WorldDef def;
    def.name = "Sample";
    muster::GroupDef group;
    group.count = 16;
    def.groups.push_back(group);
    muster::Result<muster::World> world = muster::World::create(def);
    if (!world.ok()) return world.status();
    muster::Result<muster::TakeWriter> take = muster::TakeWriter::create(path, def);
    if (!take.ok()) return take.status();

    const muster::Command command{30, 1, 0, muster::SetPose{world->group(0).id, {4.0, 2.0}, 0.8}};
    if (muster::Status s = world->submit(command); !s.ok()) return s;
    if (muster::Status s = take->command(command); !s.ok()) return s;
    for (int step = 0; step < 180; ++step) {
        world->step();
        if (muster::Status s = take->observe(*world); !s.ok()) return s;
    }
    return take->finish(*world);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : ".";
    const std::string path = folder + "/sample.take";
    if (muster::Status s = record(path); !s.ok()) return fail(s);

    const muster::Result<muster::Take> take = muster::readTake(path);
    if (!take.ok()) return fail(take.status());
    const muster::Result<muster::ReplayReport> replay = muster::replayTake(*take);
    if (!replay.ok()) return fail(replay.status());

    // Positions between steps are interpolated, so any number of frames a second will do.
    muster::ExportDef def;
    def.fps = 24.0;
    const std::string file = folder + "/sample.glb";
    if (muster::Status s = muster::exportTake(*take, muster::ownClips(), "glb", file, def); !s.ok())
        return fail(s);
    std::printf("%s: %u steps with %zu command, replayed to the hash %016llx; %s is ready for Blender\n",
                path.c_str(), replay->steps, take->commands.size(),
                static_cast<unsigned long long>(replay->hash), file.c_str());
    return replay->compared > 0 ? 0 : 1;
}
