#include <doctest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "lab/picture/canvas.h"
#include "lab/picture/canvas_pixels.h"
#include "lab/picture/debug_draw.h"
#include "lab/picture/picture.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Sum of ink over a white canvas, in pixels.
double ink(const Canvas& canvas) {
    double sum = 0.0;
    for (std::uint8_t byte : canvas.bytes()) sum += (255.0 - byte) / 255.0 / 3.0;
    return sum;
}

std::string temporary(const char* name) {
    return (std::filesystem::temp_directory_path() / name).string();
}

std::string contents(const std::string& path) {
    std::string text;
    std::FILE* file = std::fopen(path.c_str(), "rb");
    REQUIRE(file != nullptr);
    char buffer[4096];
    while (const std::size_t got = std::fread(buffer, 1, sizeof(buffer), file)) text.append(buffer, got);
    std::fclose(file);
    return text;
}

WorldDef pictureDef() {
    WorldDef def{.box = {{-8, -6}, {8, 6}}};
    ObstacleDef wall, tree;
    wall.polygon = {{1, -3}, {2, -3}, {2, 3}, {1, 3}};
    tree.centre = {5, 4};
    tree.radius = 0.5;
    def.obstacles = {wall, tree};
    def.patches = {{.name = "Pool <&>", .polygon = {{3, -5}, {7, -5}, {7, -1}, {3, -1}}, .motion = 4}};
    def.groups = {{.count = 9, .position = {-4, 0}}};
    return def;
}

}  // namespace

TEST_CASE("overlapping loops unite, and loops of opposite orientation are holes") {
    Canvas united(40, 40, kWhite);
    const std::vector<Vec2> a{{5, 5}, {25, 5}, {25, 15}, {5, 15}}, b{{15, 5}, {35, 5}, {35, 15}, {15, 15}};
    united.fill(std::vector<std::vector<Vec2>>{a, b}, Colour::of(0x000000, 0.5));
    CHECK(ink(united) == doctest::Approx(0.5 * 300.0).epsilon(0.01));
    Canvas holed(40, 40, kWhite);
    std::vector<Vec2> hole{{10, 8}, {10, 12}, {20, 12}, {20, 8}};
    holed.fill(std::vector<std::vector<Vec2>>{a, hole}, kBlack);
    CHECK(ink(holed) == doctest::Approx(200.0 - 40.0).epsilon(0.01));
}

TEST_CASE("shapes outside the canvas or with invalid numbers draw nothing") {
    Canvas canvas(20, 20, kWhite);
    canvas.fill(std::vector<std::vector<Vec2>>{{{-50, -50}, {-30, -50}, {-30, -30}}}, kBlack);
    canvas.fill(std::vector<std::vector<Vec2>>{{{1e9, 1}, {2e9, 1}, {1e9, 5}}}, kBlack);
    canvas.fill(std::vector<std::vector<Vec2>>{{{NAN, 1}, {5, 1}, {5, 5}}}, {});
    CHECK(ink(canvas) == 0.0);
}

TEST_CASE("layers have names") {
    for (const std::string& name : layerNames()) CHECK(parseLayers(name).ok());
    CHECK(*parseLayers("mesh,cost") == (*parseLayers("cost") | *parseLayers("mesh")));
    CHECK(*parseLayers("") == 0);
    CHECK(parseLayers("mesh,clouds").status().message().find("clouds") != std::string::npos);
}

TEST_CASE("every layer draws something of its own, and SVG text is escaped") {
    auto world = World::create(pictureDef());
    REQUIRE(world.ok());
    REQUIRE(world->submit({1, 1, 0, Touch{TouchPhase::Down, 1, {-4, 0}, 0.0, {}}}).ok());
    REQUIRE(world->submit({2, 1, 1, Touch{TouchPhase::Move, 1, {0, 1}, 1.0, {}}}).ok());
    for (int i = 0; i < 10; ++i) world->step();
    const std::string path = temporary("muster_debug_test.svg");
    std::vector<std::string> pictures;
    for (const std::string& name : layerNames()) {
        CAPTURE(name);
        PictureDef def{.layers = *parseLayers(name), .width = 640};
        REQUIRE(writePicture(*world, def, path).ok());
        const std::string text = contents(path);
        CHECK(text.rfind("<svg", 0) == 0);
        for (const char* bad : {"\"nan", "\"-nan", "Mnan", "Lnan", " nan", "inf"})
            CHECK(text.find(bad) == std::string::npos);
        for (const std::string& other : pictures) CHECK(other != text);
        pictures.push_back(text);
    }
    CHECK(pictures[0].find("Pool &lt;&amp;>") != std::string::npos);
    CHECK(pictures[2].find("Cost to place") != std::string::npos);
    std::filesystem::remove(path);
}

TEST_CASE("bad picture requests are refused") {
    auto world = World::create(pictureDef());
    REQUIRE(world.ok());
    PictureDef def;
    CHECK(writePicture(*world, def, "x.jpeg").code() == StatusCode::InvalidArgument);
    def.width = 10;
    CHECK(writePicture(*world, def, "x.png").code() == StatusCode::InvalidArgument);
    def.width = 100;
    def.view = Box{{0, 0}, {0, 5}};
    CHECK(writePicture(*world, def, "x.png").code() == StatusCode::InvalidArgument);
    def.view.reset();
    def.place = 999;
    def.layers = *parseLayers("cost");
    def.group = 7;
    const std::string path = temporary("muster_debug_other.png");
    CHECK(writePicture(*world, def, path).ok());
    std::filesystem::remove(path);
}
