#include "people/clips/clip_files.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/text_file.h"
#include "people/clips/clip_samples.h"

using namespace muster;
using namespace muster::testing;

namespace {

struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("muster_clip_files_" + std::to_string(::getpid()));
    ~Folder() { std::filesystem::remove_all(path); }
    std::string name() const { return path.string(); }
};

ClipLibrary twoClips() {
    ClipLibrary library{.clips = {wavingClip(true), wavingClip(false, 41)}};
    Clip& over = library.clips[1];
    over.name = "jump-over";
    over.motion = "jump";
    over.rate = 50.0;
    over.entryPhase = 0.25;
    over.exitPhase = 1.0 / 3.0;
    over.obstacle = {0.6f, 0.25f};
    over.contacts = {{Limb::LeftFoot, 0.0, 0.2, {0.1f, 0.2f, 0.08f}},
                     {Limb::RightHand, 0.3, 0.7, {0.5f, -0.2f, 0.6f}}};
    library.clips[0].contacts = {{Limb::RightKnee, 0.4, 0.6, {0.0f, 0.1f, 0.05f}}};
    return library;
}

}  // namespace

TEST_CASE("a folder of clips gives back the library that was written") {
    const Folder folder;
    const ClipLibrary library = twoClips();
    REQUIRE(writeClips(library, folder.name() + "/deep/er").ok());
    const auto again = loadClips(folder.name() + "/deep/er");
    REQUIRE_MESSAGE(again.ok(), again.status().message());
    REQUIRE(again->clips.size() == library.clips.size());
    for (std::size_t i = 0; i < library.clips.size(); ++i) {
        const Clip &a = library.clips[i], &b = again->clips[i];
        CHECK(a.name == b.name);
        CHECK(a.motion == b.motion);
        CHECK(a.rate == b.rate);
        CHECK(a.cyclic == b.cyclic);
        CHECK(a.entryPhase == b.entryPhase);
        CHECK(a.exitPhase == b.exitPhase);
        CHECK(a.obstacle.height == b.obstacle.height);
        CHECK(a.obstacle.thickness == b.obstacle.thickness);
        REQUIRE(a.poses.size() == b.poses.size());
        REQUIRE(a.travel.size() == b.travel.size());
        const ClipDifference most = differenceOf(a, b);
        CHECK(most.place < 1e-4);
        REQUIRE(a.contacts.size() == b.contacts.size());
        for (std::size_t c = 0; c < a.contacts.size(); ++c) {
            CHECK(a.contacts[c].limb == b.contacts[c].limb);
            CHECK(a.contacts[c].begin == b.contacts[c].begin);
            CHECK(a.contacts[c].end == b.contacts[c].end);
            CHECK(a.contacts[c].anchor == b.contacts[c].anchor);
        }
        for (std::size_t f = 0; f < a.poses.size(); ++f)
            for (std::size_t j = 0; j < kJointCount; ++j)
                REQUIRE(std::fabs(dot(a.poses[f].rotation[j], b.poses[f].rotation[j])) > 1.0f - 1e-6f);
    }
}

TEST_CASE("the list tells what it should") {
    const Folder folder;
    REQUIRE(writeClips(twoClips(), folder.name()).ok());
    const auto list = nlohmann::json::parse(*readTextFile(folder.name() + "/clips.json"));
    CHECK(list["format"] == "muster-clips");
    const auto& over = list["clips"][1];
    CHECK(over["clip"] == "jump-over");
    CHECK(over["file"] == "jump-over.bvh");
    CHECK(over["duration_s"] == doctest::Approx(0.8));
    CHECK(over["speed_mps"].get<double>() == doctest::Approx(over["length_m"].get<double>() / 0.8));
    CHECK(over["ratio"].get<double>() == doctest::Approx(over["speed_mps"].get<double>() / 2.6));
    CHECK(over["obstacle"]["height_m"] == doctest::Approx(0.6));
}

TEST_CASE("bad lists are refused by what is wrong") {
    const Folder folder;
    REQUIRE(writeClips(twoClips(), folder.name()).ok());
    const std::string path = folder.name() + "/clips.json";
    const auto good = nlohmann::json::parse(*readTextFile(path));
    const auto failure = [&](const nlohmann::json& list) {
        REQUIRE(writeTextFile(path, list.dump()).ok());
        const auto library = loadClips(folder.name());
        REQUIRE_FALSE(library.ok());
        return library.status().message();
    };
    const auto with = [&](const char* pointer, nlohmann::json value) {
        nlohmann::json changed = good;
        changed[nlohmann::json::json_pointer(pointer)] = std::move(value);
        return failure(changed);
    };
    const auto has = [&](const std::string& message, const char* part) {
        CHECK_MESSAGE(message.find(part) != std::string::npos, message);
    };
    has(with("/format", "x"), "$.format: expected \"muster-clips\"");
    has(with("/version", 2), "$.version");
    has(with("/clips", 3), "$.clips: expected a list");
    has(with("/clips/0", 3), "$.clips[0]: expected an object");
    has(with("/clips/1/clip", "wave"), "\"wave\" a second time");
    // Pictures of clips are called like them.
    has(with("/clips/1/clip", "../../up"), "$.clips[1].clip");
    has(with("/clips/1/clip", ""), "$.clips[1].clip");
    has(with("/clips/1/file", "../x.bvh"), "$.clips[1].file");
    has(with("/clips/1/file", "gone.bvh"), "gone.bvh: cannot be opened");
    has(with("/clips/1/cyclic", "no"), "$.clips[1].cyclic: expected true or false");
    has(with("/clips/1/entry_phase", 7), "$.clips[1].entry_phase");
    has(with("/clips/1/obstacle", nullptr), "$.clips[1].obstacle");
    has(with("/clips/1/contacts/0/limb", "tail"), "$.clips[1].contacts[0].limb");
    has(with("/clips/1/contacts/0/anchor_m", {1, 2}), "$.clips[1].contacts[0].anchor_m");
    has(with("/clips/1/contacts/0/begin_s", 99), "left foot lies outside it");
    REQUIRE(writeTextFile(path, "{").ok());
    has(loadClips(folder.name()).status().message(), "is not JSON");
    CHECK(loadClips(folder.name() + "/gone").status().code() == StatusCode::IoError);
    ClipLibrary named{.clips = {wavingClip(true)}};
    named.clips[0].name = "../up";
    CHECK_FALSE(writeClips(named, folder.name()).ok());
}
