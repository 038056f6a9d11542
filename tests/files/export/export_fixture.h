// Short takes, and an exporter that records what it receives.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "files/export/exporter.h"
#include "muster/own_clips.h"
#include "temporary_folder.h"

namespace muster::testing {

/// A temporary folder for the files of one test run; it is removed afterwards.
inline const std::filesystem::path& exportFolder() {
    static const TemporaryFolder folder("export");
    return folder.base;
}

/// The number of files and folders, including incomplete ones.
inline std::size_t thingsInFolder() {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::recursive_directory_iterator(exportFolder()))
        ++count;
    return count;
}

/// Nine characters whose formation is dragged ahead, around a pillar, for two seconds: 120 steps.
inline Take shortTake() {
    WorldDef def{.name = "Short", .box = {{-10, -6}, {10, 6}}};
    def.groups = {{.count = 9, .position = {-4, 0}, .jitter = 0.3}};
    def.obstacles = {{.polygon = {{0, -1}, {1, -1}, {1, 1}, {0, 1}}}};
    def.obstacles.push_back({.centre = {5, 3}, .radius = 1.0});
    const std::string path = (exportFolder() / "short.take").string();
    auto world = World::create(def);
    auto writer = TakeWriter::create(path, def);
    for (int step = 0; step < 120; ++step) {
        world->step();
        if (!writer->observe(*world).ok()) break;
    }
    if (writer->finish(*world).ok()) return *readTake(path);
    return {};
}

/// Stores everything that it receives.
class Recorder : public Exporter {
public:
    struct Seen {
        std::size_t index = 0;
        double time = 0.0;
        std::vector<ExportCharacter> characters;
        std::vector<BodyPose> poses;
        std::uint32_t step = 0;
    };
    bool poses = true;
    std::size_t failAt = 1000000;
    ExportInfo info;
    std::vector<Seen> frames;
    int finished = 0;

    bool wantsPoses() const override { return poses; }
    Status begin(const ExportInfo& of) override {
        info = of;
        return {};
    }
    Status frame(const ExportFrame& frame) override {
        if (frame.index == failAt) return {StatusCode::IoError, "the disk is full"};
        Seen& seen = frames.emplace_back();
        seen = {frame.index,
                frame.time,
                {frame.characters.begin(), frame.characters.end()},
                {},
                frame.world->stepCount()};
        for (const ExportCharacter& c : frame.characters)
            if (c.pose != nullptr) seen.poses.push_back(*c.pose);
        return {};
    }
    Status finish() override {
        ++finished;
        return {};
    }
};

}  // namespace muster::testing
