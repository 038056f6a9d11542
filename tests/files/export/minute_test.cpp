// How long a minute of a hundred people takes to export.
#include <doctest.h>

#include <chrono>
#include <filesystem>

#include "files/take/take_encoder.h"
#include "muster/export.h"
#include "muster/own_clips.h"

using namespace muster;

namespace {

/// A hundred people who are dragged back and forth for a minute.
Take minuteTake() {
    WorldDef def{.name = "Minute", .box = {{-20, -20}, {20, 20}}, .groups = {{.count = 100}}};
    std::vector<std::uint8_t> bytes = TakeEncoder::begin(def);
    World world = World::create(def).value();
    const auto append = [&](const std::vector<std::uint8_t>& record) {
        bytes.insert(bytes.end(), record.begin(), record.end());
    };
    std::uint32_t sequence = 0;
    const auto submit = [&](CommandBody body) {
        const Command command{world.stepCount(), 1, ++sequence, std::move(body)};
        REQUIRE(world.submit(command).ok());
        append(TakeEncoder::command(command));
    };
    for (int step = 0; step < 3600; ++step) {
        const int part = step % 240;
        const Vec2 at{(part < 120 ? part : 240 - part) * 0.05 - 3.0, 1.0};
        if (part == 0) submit(Touch{TouchPhase::Down, 1, at, world.time(), {}});
        if (part > 0 && part < 200) submit(Touch{TouchPhase::Move, 1, at, world.time(), {}});
        if (part == 200) submit(Touch{TouchPhase::Up, 1, {}, world.time(), {}});
        world.step();
    }
    append(TakeEncoder::end({world.stepCount(), world.hash()}));
    return parseTake(bytes, "minute").value();
}

}  // namespace

TEST_CASE("A minute of a hundred people becomes a GLB in seconds, and can be stopped") {
    const Take take = minuteTake();
    const std::string path = (std::filesystem::temp_directory_path() / "muster-minute.glb").string();
    const auto begun = std::chrono::steady_clock::now();
    double last = 0.0;
    const Status done = exportTake(take, ownClips(), "glb", path, {}, [&](double share) {
        CHECK(share >= last);
        last = share;
        return true;
    });
    REQUIRE_MESSAGE(done.ok(), done.message());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    CHECK(last == 1.0);
    MESSAGE("measured: 60 s of 100 people as GLB, ", std::filesystem::file_size(path) / 1000000, " MB in ",
            seconds, " s");
    std::filesystem::remove(path);
    CHECK(exportTake(take, ownClips(), "glb", path, {}, [](double share) { return share < 0.1; }).code() ==
          StatusCode::Unsupported);
    CHECK_FALSE(std::filesystem::exists(path));
}
