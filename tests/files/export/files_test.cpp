// Files of the simple formats, read back.
#include <doctest.h>

#include <fstream>
#include <sstream>

#include "base/maths.h"
#include "base/output_file.h"
#include "base/text_file.h"
#include "engine/ground/environment/environment.h"
#include "files/export/export_fixture.h"
#include "files/export/formats.h"
#include "people/clips/retarget.h"

#if __has_include(<sqlite3.h>)
#include <sqlite3.h>
#endif

using namespace muster;
using namespace muster::testing;

namespace {

std::unique_ptr<Exporter> exporterOf(const char* format, const std::string& path) {
    auto exporter = makeExporter(format, path);
    REQUIRE(exporter.ok());
    return std::move(exporter).value();
}

}  // namespace

TEST_CASE("text for PedPy holds every character in every frame") {
    const Take take = shortTake();
    const std::string path = (exportFolder() / "t.txt").string();
    Recorder recorder;
    recorder.poses = false;
    REQUIRE(exportTake(take, ownClips(), {0.5, 1.5, 24.0, 1}, recorder).ok());
    REQUIRE(exportTake(take, ownClips(), {0.5, 1.5, 24.0, 1}, *exporterOf("pedpy", path)).ok());
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    CHECK(line == "# framerate: 24");
    std::getline(file, line);
    CHECK(line.front() == '#');
    for (const auto& frame : recorder.frames) {
        for (const ExportCharacter& c : frame.characters) {
            std::uint32_t id = 0;
            std::size_t number = 0;
            double x = 0.0, y = 0.0, z = 1.0, heading = 9.0;
            std::uint32_t group = 0, goal = 9;
            int motion = -1;
            file >> id >> number >> x >> y >> z >> group >> heading >> motion >> goal;
            REQUIRE(file.good());
            CHECK(group >= 1);
            CHECK(heading == doctest::Approx(c.yaw).epsilon(1e-3));
            CHECK(motion >= 0);
            CHECK(goal == 0);
            CHECK(id == c.id);
            CHECK(number == frame.index);
            CHECK(x == doctest::Approx(c.position.x).epsilon(1e-6));
            CHECK(y == doctest::Approx(c.position.y).epsilon(1e-6));
            CHECK(z == 0.0);
        }
    }
    file >> line;
    CHECK(file.eof());
}

TEST_CASE("a table has a row for every character in every frame, with units in its head") {
    const Take take = shortTake();
    const std::string path = (exportFolder() / "t.csv").string();
    Recorder recorder;
    recorder.poses = false;
    REQUIRE(exportTake(take, ownClips(), {0.5, 1.5, 10.0, 1}, recorder).ok());
    REQUIRE(exportTake(take, ownClips(), {0.5, 1.5, 10.0, 1}, *exporterOf("csv", path)).ok());
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    CHECK(line == "time_s,person,group,group_name,x_m,y_m,heading_deg,speed_m_s,motion,goal");
    for (const auto& frame : recorder.frames) {
        for (const ExportCharacter& c : frame.characters) {
            REQUIRE(std::getline(file, line).good());
            char motion[20] = "";
            double time = 0.0, x = 0.0, y = 0.0, heading = 9.0, speed = -1.0;
            unsigned id = 0;
            REQUIRE(std::sscanf(line.c_str(), "%lf,%u,1,Group,%lf,%lf,%lf,%lf,%19[^,],", &time, &id, &x, &y,
                                &heading, &speed, motion) == 7);
            CHECK(time == doctest::Approx(frame.time));
            CHECK(id == c.id);
            CHECK(std::fabs(x - c.position.x) < 1e-4);
            CHECK(std::fabs(y - c.position.y) < 1e-4);
            CHECK(speed >= 0.0);
            CHECK(ownClips().find(motion) != nullptr);
        }
    }
    CHECK_FALSE(std::getline(file, line).good());
}

TEST_CASE("only chosen people are exported") {
    const Take take = shortTake();
    const auto idsIn = [&](const ExportDef& def) {
        Recorder recorder;
        const Status status = exportTake(take, ownClips(), def, recorder);
        std::vector<std::uint32_t> ids;
        if (!status.ok()) return std::pair{status.message(), ids};
        for (const ExportCharacter& c : recorder.frames.back().characters) ids.push_back(c.id);
        CHECK(recorder.frames.front().poses.size() == ids.size());
        CHECK(recorder.info.people() == ids.size());
        return std::pair{std::string(), ids};
    };
    ExportDef def;
    CHECK(idsIn(def).second.size() == 9);
    def.groups = {1};
    CHECK(idsIn(def).second.size() == 9);
    def.firstPerson = 3, def.lastPerson = 4;
    CHECK(idsIn(def).second == std::vector<std::uint32_t>{3, 4});
    def.groups = {2};
    CHECK(idsIn(def).first == "nobody in this part of the take was chosen");
    def.groups.clear();
    def.firstPerson = 5;
    CHECK(idsIn(def).first == "people: found 5 to 4, expected the smaller number first");
}

TEST_CASE("BVH files of all characters show them where they are") {
    const Take take = shortTake();
    const std::string folder = (exportFolder() / "bodies").string();
    Recorder recorder;
    REQUIRE(exportTake(take, ownClips(), {0.0, 1.0, 30.0, 1}, recorder).ok());
    REQUIRE(exportTake(take, ownClips(), {0.0, 1.0, 30.0, 1}, *exporterOf("bvh", folder)).ok());
    for (std::size_t i = 0; i < 9; ++i) {
        const ExportCharacter& first = recorder.frames[0].characters[i];
        char name[40];
        std::snprintf(name, sizeof(name), "/character-%04u.bvh", first.id);
        const auto motion = readBvh(folder + name);
        REQUIRE_MESSAGE(motion.ok(), motion.status().message());
        REQUIRE(motion->frames == 31);
        CHECK(motion->rate == 30.0);
        CHECK(motion->unit == 0.01);
        // The body has its size: hip to knee.
        CHECK(length(motion->joints[15].offset) == doctest::Approx(0.42 * first.size).epsilon(1e-4));
        for (std::size_t f = 0; f < 31; ++f) {
            const ExportCharacter& c = recorder.frames[f].characters[i];
            const Transform root = motion->frame(f)[0], hips = motion->frame(f)[1];
            CHECK(root.translation.x == doctest::Approx(c.position.x).epsilon(1e-5));
            CHECK(root.translation.y == doctest::Approx(c.position.y).epsilon(1e-5));
            CHECK(angleBetween(root.rotation, yawTurn(c.yaw)) < 2e-3);
            CHECK(distance(hips.translation, recorder.frames[f].poses[i].hips * c.size) < 1e-5f);
        }
    }
    CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 9);
}

TEST_CASE("the walkable area is the box without static obstacles") {
    auto environment = Environment::create({.box = {{0, 0}, {10, 4}}});
    REQUIRE(environment.ok());
    if (walkableArea(*environment).empty()) {
        MESSAGE("skipped: this build has no SQLite");
        return;
    }
    CHECK(walkableArea(*environment) == "POLYGON((0 0,0 4,10 4,10 0,0 0))");
    ObstacleDef wall{.polygon = {{4, 1}, {5, 1}, {5, 3}, {4, 3}}};
    REQUIRE(environment->addObstacle(wall).ok());
    environment->setTime(0.0);
    CHECK(walkableArea(*environment).find("(4 1,5 1,5 3,4 3,4 1)") != std::string::npos);
    // A neighbour that touches gives one hole; one across the whole box gives two parts.
    wall.polygon = {{5, 1}, {6, 1}, {6, 3}, {5, 3}};
    REQUIRE(environment->addObstacle(wall).ok());
    environment->setTime(0.0);
    const std::string joined = walkableArea(*environment);
    CHECK(std::count(joined.begin(), joined.end(), '(') == 3);
    wall.polygon = {{8, -1}, {9, -1}, {9, 5}, {8, 5}};
    REQUIRE(environment->addObstacle(wall).ok());
    environment->setTime(0.0);
    CHECK(walkableArea(*environment).rfind("MULTIPOLYGON(", 0) == 0);
    // Moving obstacles are left out.
    const std::string before = walkableArea(*environment);
    ObstacleDef car{
        .centre = {2, 2}, .radius = 0.5, .path = {.waypoints = {{0.0, {}, 0.0}, {1.0, {1, 0}, 0.0}}}};
    REQUIRE(environment->addObstacle(car).ok());
    environment->setTime(0.5);
    CHECK(walkableArea(*environment) == before);
}

#if __has_include(<sqlite3.h>)
namespace {

/// All rows of a query as text; a bar separates the columns.
std::vector<std::string> query(const std::string& path, const char* text) {
    sqlite3* base = nullptr;
    REQUIRE(sqlite3_open_v2(path.c_str(), &base, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK);
    std::vector<std::string> rows;
    const auto add = [](void* out, int columns, char** values, char**) {
        std::string row;
        for (int c = 0; c < columns; ++c)
            row += (c > 0 ? "|" : "") + std::string(values[c] != nullptr ? values[c] : "null");
        static_cast<std::vector<std::string>*>(out)->push_back(row);
        return 0;
    };
    CHECK(sqlite3_exec(base, text, add, &rows, nullptr) == SQLITE_OK);
    sqlite3_close(base);
    return rows;
}

}  // namespace

TEST_CASE("JuPedSim's file holds trajectories, directions, metadata and the area of each frame") {
    const Take take = shortTake();
    const std::string path = (exportFolder() / "t.sqlite").string();
    Recorder recorder;
    recorder.poses = false;
    REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, 25.0, 1}, recorder).ok());
    REQUIRE(exportTake(take, ownClips(), {0.0, -1.0, 25.0, 1}, *exporterOf("jupedsim", path)).ok());
    CHECK(query(path, "PRAGMA integrity_check") == std::vector<std::string>{"ok"});
    CHECK(query(path, "SELECT value FROM metadata WHERE key='version'") == std::vector<std::string>{"2"});
    CHECK(query(path, "SELECT value FROM metadata WHERE key='fps'") == std::vector<std::string>{"25"});
    CHECK(query(path, "SELECT value FROM metadata WHERE key='xmax'") == std::vector<std::string>{"10"});
    CHECK(query(path, "SELECT count(*), min(frame), max(frame) FROM frame_data") ==
          std::vector<std::string>{"51|0|50"});
    CHECK(query(path, "SELECT count(*) FROM frame_data JOIN geometry ON geometry_hash = hash") ==
          std::vector<std::string>{"51"});
    CHECK(
        query(path,
              "SELECT count(*), min(group_id), min(motion), max(goal) FROM muster_data WHERE motion >= 0") ==
        std::vector<std::string>{"459|1|0|0"});
    const auto areas = query(path, "SELECT wkt FROM geometry");
    REQUIRE(areas.size() == 1);
    CHECK(areas[0].rfind("POLYGON((", 0) == 0);
    const auto rows = query(
        path, "SELECT frame, id, pos_x, pos_y, ori_x, ori_y FROM trajectory_data ORDER BY frame, id");
    REQUIRE(rows.size() == 51 * 9);
    for (std::size_t f = 0; f < 51; ++f) {
        for (std::size_t i = 0; i < 9; ++i) {
            const ExportCharacter& c = recorder.frames[f].characters[i];
            std::istringstream row(rows[f * 9 + i]);
            double value[6];
            for (double& number : value) {
                row >> number;
                row.ignore();
            }
            CHECK(value[0] == static_cast<double>(f));
            CHECK(value[1] == c.id);
            CHECK(value[2] == doctest::Approx(c.position.x).epsilon(1e-9));
            CHECK(value[3] == doctest::Approx(c.position.y).epsilon(1e-9));
            CHECK(value[4] == doctest::Approx(cosine(c.yaw)).epsilon(1e-6));
            CHECK(value[5] == doctest::Approx(sine(c.yaw)).epsilon(1e-6));
        }
    }
}
#endif

TEST_CASE("a failed export leaves no new file and does not change an existing one") {
    Take take = shortTake();
    const std::string before = (exportFolder() / "kept.txt").string();
    REQUIRE(writeTextFile(before, "precious").ok());
    const std::size_t things = thingsInFolder();
    take.marks.front().hash ^= 1;
    take.frames.clear();
    for (const ExportFormat& format : exportFormats()) {
        const std::string path = (exportFolder() / (std::string("half-") + format.name)).string();
        CHECK_MESSAGE(!exportTake(take, ownClips(), format.name, path).ok(), format.name);
        CHECK_MESSAGE(thingsInFolder() == things, format.name);
        CHECK_MESSAGE(!exportTake(take, ownClips(), format.name, "/proc/nowhere/x").ok(), format.name);
    }
    CHECK_FALSE(exportTake(take, ownClips(), {}, *exporterOf("pedpy", before)).ok());
    CHECK(*readTextFile(before) == "precious");
    CHECK_FALSE(exportTake(take, ownClips(), {}, *exporterOf("pedpy", exportFolder().string())).ok());
    CHECK_FALSE(exportTake(take, ownClips(), {}, *exporterOf("bvh", before)).ok());
    CHECK(exportTake(take, ownClips(), "doc", "x").message().find("found \"doc\", expected one of ") !=
          std::string::npos);
}

TEST_CASE("a take that simulates otherwise is exported from its stored frames, whatever mark differs") {
    const std::string file = (exportFolder() / "same.txt").string();
    REQUIRE(exportTake(shortTake(), ownClips(), "pedpy", file).ok());
    const std::string simulated = *readTextFile(file);
    for (const bool first : {true, false}) {
        Take take = shortTake();
        (first ? take.marks.front() : take.marks.back()).hash ^= 1;
        REQUIRE(exportTake(take, ownClips(), "pedpy", file).ok());
        std::istringstream frames(*readTextFile(file)), steps(simulated);
        std::string line;
        for (int comment = 0; comment < 2; ++comment) {
            std::getline(frames, line);
            std::getline(steps, line);
        }
        std::size_t lines = 0;
        double id = 0.0, number = 0.0, x = 0.0, y = 0.0, z = 0.0;
        while (steps >> id >> number >> x >> y >> z) {
            double storedId = 0.0, storedNumber = 0.0, storedX = 0.0, storedY = 0.0;
            frames >> storedId >> storedNumber >> storedX >> storedY >> z;
            REQUIRE(!frames.fail());
            std::getline(steps, line);
            std::getline(frames, line);
            CHECK(storedId == id);
            CHECK(storedNumber == number);
            // Frames are stored to the millimetre, and curves lie between them.
            CHECK(distance(Vec2{storedX, storedY}, Vec2{x, y}) < 0.01);
            ++lines;
        }
        CHECK(lines == 9 * 61);
    }
}

TEST_CASE("an output file exists completely or not at all") {
    const std::string path = (exportFolder() / "whole.bin").string();
    {
        OutputFile file;
        REQUIRE(file.open(path).ok());
        REQUIRE(file.write("0123456789").ok());
        CHECK_FALSE(std::filesystem::exists(path));
    }
    CHECK_FALSE(std::filesystem::exists(path + ".part"));
    OutputFile file;
    REQUIRE(file.open(path).ok());
    REQUIRE(file.write("0123456789").ok());
    REQUIRE(file.rewrite(2, "ab").ok());
    REQUIRE(file.write("!").ok());
    CHECK(file.size() == 11);
    OutputFile moved = std::move(file);
    REQUIRE(moved.commit().ok());
    CHECK(*readTextFile(path) == "01ab456789!");
    CHECK_FALSE(std::filesystem::exists(path + ".part"));
}
