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
    WorldDef def;
    def.box = {{-8, -6}, {8, 6}};
    ObstacleDef wall, tree;
    wall.polygon = {{1, -3}, {2, -3}, {2, 3}, {1, 3}};
    tree.centre = {5, 4};
    tree.radius = 0.5;
    def.obstacles = {wall, tree};
    PatchDef pool;
    pool.name = "Pool <&>";
    pool.polygon = {{3, -5}, {7, -5}, {7, -1}, {3, -1}};
    pool.motion = 4;
    def.patches = {pool};
    GroupDef group;
    group.count = 9;
    group.position = {-4, 0};
    def.groups = {group};
    return def;
}

}  // namespace

TEST_CASE("filled areas have as much ink as their area") {
    Canvas square(40, 40, kWhite);
    const std::vector<std::vector<Vec2>> box{{{5.25, 5.2}, {15.75, 5.2}, {15.75, 25.2}, {5.25, 25.2}}};
    square.fill(box, kBlack);
    CHECK(ink(square) == doctest::Approx(10.5 * 20.0).epsilon(0.01));
    Canvas disc(80, 80, kWhite);
    const std::vector<std::vector<Vec2>> round{discLoop({40, 40}, 30)};
    disc.fill(round, kBlack);
    CHECK(ink(disc) == doctest::Approx(3.14159265 * 900.0).epsilon(0.01));
}

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

TEST_CASE("a line's ink is its length times its width; dashes leave gaps") {
    Canvas whole(220, 20, kWhite), dashed(220, 20, kWhite);
    const std::vector<Vec2> line{{10, 10}, {209.9, 16.3}};  // 200 px, across the rows.
    std::vector<std::vector<Vec2>> loops;
    strokeLoops(line, false, 0.7, 0.0, loops);
    whole.fill(loops, kBlack);
    CHECK(ink(whole) == doctest::Approx(140.0).epsilon(0.03));
    loops.clear();
    strokeLoops(line, false, 0.7, 10.0, loops);
    dashed.fill(loops, kBlack);
    CHECK(ink(dashed) == doctest::Approx(67.3).epsilon(0.06));
}

TEST_CASE("PNG files read by another decoder are equal, pixel for pixel") {
    const auto draw = makePngDraw({{0, 0}, {4, 2}}, 80, kWhite);
    draw->polygon(std::vector<Vec2>{{0, 1}, {1, 1}, {1, 2}, {0, 2}}, Colour::of(0x1D5FD1), {});
    const std::vector<Colour> ramp{kBlack, kWhite};
    draw->raster({{2, 0}, {4, 2}}, 2, 1, ramp);
    const std::string path = temporary("muster_debug_test.png");
    REQUIRE(draw->write(path).ok());
    int width = 0, height = 0, channels = 0;
    unsigned char* pixels = stbi_load(path.c_str(), &width, &height, &channels, 3);
    REQUIRE(pixels != nullptr);
    CHECK(width == 80);
    CHECK(height == 40);
    const auto at = [&](int x, int y) { return &pixels[(y * width + x) * 3]; };
    CHECK(int(at(10, 10)[0]) == 0x1D);  // Upper left: y points upwards in the world.
    CHECK(int(at(10, 10)[2]) == 0xD1);
    CHECK(int(at(10, 30)[0]) == 255);
    CHECK(int(at(41, 20)[0]) == 0);
    CHECK(int(at(79, 20)[0]) == 255);
    CHECK(std::abs(int(at(60, 20)[0]) - 130) < 8);
    stbi_image_free(pixels);
    std::filesystem::remove(path);
    CHECK(draw->write("/nowhere/x.png").code() == StatusCode::IoError);
}

TEST_CASE("contours of a plane are straight and at the right position") {
    std::vector<double> plane;
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 8; ++x) plane.push_back(x + 0.5 * y);
    }
    const auto segments = contourSegments(8, 6, plane, 3.3);
    CHECK(segments.size() >= 5);
    for (const auto& [a, b] : segments) {
        CHECK(a.x + 0.5 * a.y == doctest::Approx(3.3));
        CHECK(b.x + 0.5 * b.y == doctest::Approx(3.3));
    }
    plane[10] = INFINITY;
    CHECK(contourSegments(8, 6, plane, 3.3).size() < segments.size());
    CHECK(contourSegments(8, 6, plane, 99.0).empty());
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
    REQUIRE(world->submit({1, 1, 0, TouchDown{1, {-4, 0}, 0.0, {}}}).ok());
    REQUIRE(world->submit({2, 1, 1, TouchMove{1, {0, 1}, 1.0}}).ok());
    for (int i = 0; i < 10; ++i) world->step();
    const std::string path = temporary("muster_debug_test.svg");
    std::vector<std::string> pictures;
    for (const std::string& name : layerNames()) {
        CAPTURE(name);
        PictureDef def;
        def.layers = *parseLayers(name);
        def.width = 640;
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
