// The contents of SVG documents read as XML, and of PNG files decoded by another library.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/random.h"
#include "lab/picture/canvas.h"
#include "lab/picture/canvas_pixels.h"
#include "lab/picture/debug_draw.h"
#include "lab/picture/xml.h"
#include "temporary_folder.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr Colour kBlue = Colour::of(0x1D5FD1);

std::string svgOf(const DebugDraw& draw) {
    const TemporaryFolder folder("picture");
    REQUIRE(draw.write(folder / "a.svg").ok());
    return folder.read("a.svg");
}

struct Decoded {
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> bytes;
    std::array<int, 3> at(int x, int y) const {
        const auto i = static_cast<std::size_t>((y * width + x) * channels);
        return {bytes[i], bytes[i + 1], bytes[i + 2]};
    }
    /// Pixels that are not white within [x0, x1) x [y0, y1).
    int inked(int x0, int y0, int x1, int y1) const {
        int count = 0;
        for (int y = std::max(0, y0); y < std::min(height, y1); ++y) {
            for (int x = std::max(0, x0); x < std::min(width, x1); ++x)
                count += at(x, y) != std::array<int, 3>{255, 255, 255};
        }
        return count;
    }
};

Decoded decode(const std::string& png) {
    Decoded d;
    unsigned char* pixels = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                                                  static_cast<int>(png.size()), &d.width, &d.height,
                                                  &d.channels, 0);
    REQUIRE(pixels != nullptr);
    d.bytes.assign(pixels, pixels + d.width * d.height * d.channels);
    stbi_image_free(pixels);
    return d;
}

Decoded pngOf(const DebugDraw& draw) {
    const TemporaryFolder folder("picture");
    REQUIRE(draw.write(folder / "a.png").ok());
    return decode(folder.read("a.png"));
}

std::string unbase64(const std::string& text) {
    std::string bytes;
    std::uint32_t word = 0;
    int bits = 0;
    for (const char c : text) {
        const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const char* found = c == '=' ? nullptr : std::strchr(digits, c);
        if (found == nullptr) break;
        word = word << 6 | static_cast<std::uint32_t>(found - digits);
        if ((bits += 6) < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(word >> bits & 0xff);
    }
    return bytes;
}

}  // namespace

TEST_CASE("an SVG has the right size and holds each shape at its pixels") {
    const auto draw = makeSvgDraw({{-2, -1}, {6, 3}}, 400, kWhite);  // 50 px a metre.
    CHECK(draw->pixel() == doctest::Approx(0.02));
    draw->disc({0, 0}, 0.5, kBlue, {kBlack, 2.0, 0.0});
    draw->line(std::vector<Vec2>{{-2, 3}, {6, -1}}, {Colour::of(0xCB4A0E, 0.5), 3.0, 4.0});
    draw->polygon(std::vector<Vec2>{{1, 1}, {2, 1}, {2, 2}}, Colour::of(0x00FF00, 0.25), {});
    const std::string document = svgOf(*draw);
    const XmlReader xml(document);
    REQUIRE(xml.error.empty());
    CHECK(xml.elements[0].name == "svg");
    CHECK(xml.elements[0].number("width") == 400);
    CHECK(xml.elements[0].number("height") == 200);
    CHECK(xml.elements[0].attribute("viewBox") == "0 0 400 200");
    REQUIRE(xml.all("circle").size() == 1);
    const Element circle = xml.all("circle")[0];
    CHECK(circle.number("cx") == 100);
    CHECK(circle.number("cy") == 150);
    CHECK(circle.number("r") == 25);
    CHECK(circle.attribute("fill") == "#1D5FD1");
    CHECK(circle.attribute("stroke") == "#000000");
    REQUIRE(xml.all("path").size() == 2);
    const Element line = xml.all("path")[0], triangle = xml.all("path")[1];
    CHECK(line.attribute("d") == "M0 0L400 200");
    CHECK(line.attribute("fill") == "none");
    CHECK(line.number("stroke-opacity") == 0.5);
    CHECK(line.attribute("stroke-dasharray") == "4 7");
    CHECK(triangle.attribute("d") == "M150 100L200 100L200 50Z");
    CHECK(triangle.number("fill-opacity") == 0.25);
    CHECK(triangle.attribute("stroke").empty());
}

TEST_CASE("holes are further loops of one path, and later shapes come later") {
    const auto draw = makeSvgDraw({{0, 0}, {10, 10}}, 100, kWhite);
    draw->area(std::vector<std::vector<Vec2>>{{{0, 0}, {8, 0}, {8, 8}}, {{2, 1}, {3, 2}, {3, 1}}}, kBlue, {});
    draw->disc({1, 1}, 1, kBlack, {});
    const std::string document = svgOf(*draw);
    const XmlReader xml(document);
    REQUIRE(xml.error.empty());
    const std::string data = xml.all("path")[0].attribute("d");
    CHECK(std::count(data.begin(), data.end(), 'M') == 2);
    CHECK(std::count(data.begin(), data.end(), 'Z') == 2);
    CHECK(xml.elements.back().name == "circle");
}

TEST_CASE("with any name, the document stays well-formed and the text reads the same") {
    for (const std::string words : {"Pool <&>", "a \"b\" 'c'", "]]>", "&amp;", "</svg>", "x=\"1\"/><rect"}) {
        CAPTURE(words);
        const auto draw = makeSvgDraw({{0, 0}, {4, 4}}, 100, kWhite);
        draw->text({2, 2}, words, 12, kBlack, TextAnchor::Centre);
        const std::string document = svgOf(*draw);
        const XmlReader xml(document);
        CHECK(xml.error.empty());
        REQUIRE(xml.all("text").size() == 1);
        CHECK(xml.all("text")[0].text == words);
        CHECK(xml.all("text")[0].attribute("text-anchor") == "middle");
        CHECK(xml.elements.size() == 3);  // Document, ground and text.
    }
    const auto draw = makeSvgDraw({{0, 0}, {4, 4}}, 100, kWhite);
    draw->text({2, 2}, "bell\a\nline", 12, kBlack, TextAnchor::Left);
    CHECK(svgOf(*draw).find('\a') == std::string::npos);
}

TEST_CASE("the picture inside an SVG is a PNG with the colours, the upper row first") {
    const auto draw = makeSvgDraw({{0, 0}, {4, 4}}, 80, kWhite);
    std::vector<Colour> colours;
    for (std::uint32_t i = 0; i < 6; ++i)
        colours.push_back(Colour::of(0x102030 * (i + 1), i == 5 ? 0.5 : 1.0));
    draw->raster({{1, 1}, {4, 3}}, 3, 2, colours);
    const std::string document = svgOf(*draw);
    const XmlReader xml(document);
    REQUIRE(xml.error.empty());
    const Element image = xml.all("image").at(0);
    CHECK(image.number("x") == 20);
    CHECK(image.number("y") == 20);
    CHECK(image.number("width") == 60);
    CHECK(image.number("height") == 40);
    const std::string href = image.attribute("href"), head = "data:image/png;base64,";
    REQUIRE(href.rfind(head, 0) == 0);
    const Decoded png = decode(unbase64(href.substr(head.size())));
    CHECK(png.width == 3);
    CHECK(png.height == 2);
    REQUIRE(png.channels == 4);
    for (int i = 0; i < 6; ++i) {
        const Colour c = colours[i];
        CHECK(png.at(i % 3, 1 - i / 3) == std::array<int, 3>{c.red, c.green, c.blue});
    }
    CHECK(int(png.bytes[3 * 4 - 1]) == 128);  // The last pixel of the upper row is half transparent.
}

TEST_CASE("any bytes survive PNG, in any number of channels") {
    Random random(51);
    for (int channels = 1; channels <= 4; ++channels) {
        for (int i = 0; i < 10; ++i) {
            const auto width = static_cast<std::int32_t>(1 + random.below(40)),
                       height = static_cast<std::int32_t>(1 + random.below(40));
            std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width * height * channels));
            for (std::uint8_t& byte : bytes)
                byte = static_cast<std::uint8_t>(random.below(i % 2 == 0 ? 256 : 3));
            const auto file = encodePng(width, height, channels, bytes);
            const Decoded back = decode(std::string(file.begin(), file.end()));
            CHECK(back.width == width);
            CHECK(back.height == height);
            CHECK(back.channels == channels);
            CHECK(back.bytes == bytes);
        }
    }
}

TEST_CASE("a PNG has the requested width and the height of its view") {
    const auto size = [](const Box& view, std::int32_t width) {
        const Decoded png = pngOf(*makePngDraw(view, width, kBlue));
        CHECK(png.at(png.width - 1, png.height - 1) == std::array<int, 3>{0x1D, 0x5F, 0xD1});
        return std::pair{png.width, png.height};
    };
    CHECK(size({{0, 0}, {16, 9}}, 320) == std::pair{320, 180});
    CHECK(size({{-3, -7}, {-2, -2}}, 64) == std::pair{64, 320});
    CHECK(size({{0, 0}, {300, 1}}, 100) == std::pair{100, 1});  // Never less than a row.
}

TEST_CASE("shapes of a PNG lie at their world positions, y upwards") {
    const auto draw = makePngDraw({{0, 0}, {10, 10}}, 100, kWhite);
    draw->disc({2, 8}, 1.0, kBlue, {});
    draw->line(std::vector<Vec2>{{5, 1}, {9, 1}}, {kBlack, 4.0, 0.0});
    const Decoded png = pngOf(*draw);
    CHECK(png.at(20, 20) == std::array<int, 3>{0x1D, 0x5F, 0xD1});
    CHECK(png.at(70, 90) == std::array<int, 3>{0, 0, 0});
    CHECK(png.inked(0, 0, 100, 100) == png.inked(9, 9, 31, 31) + png.inked(47, 87, 93, 93));
    CHECK(png.inked(9, 9, 31, 31) == doctest::Approx(3.14159 * 100).epsilon(0.15));
}

TEST_CASE("text is aligned left of, at or right of its point") {
    const auto inkOf = [](TextAnchor anchor) {
        const auto draw = makePngDraw({{0, 0}, {20, 5}}, 200, kWhite);
        draw->text({10, 2.5}, "Density", 12, kBlack, anchor);
        const Decoded png = pngOf(*draw);
        CHECK(png.inked(0, 0, 200, 15) + png.inked(0, 35, 200, 50) == 0);  // Centred in height.
        return std::pair{png.inked(0, 0, 100, 50), png.inked(100, 0, 200, 50)};
    };
    const auto left = inkOf(TextAnchor::Left), centre = inkOf(TextAnchor::Centre),
               right = inkOf(TextAnchor::Right);
    CHECK(left.first <= 10);  // At most a hair beyond the line.
    CHECK(left.second > 60);
    CHECK(right.first > 60);
    CHECK(right.second <= 10);
    CHECK(std::abs(centre.first - centre.second) < 0.6 * (centre.first + centre.second));
    CHECK(centre.first > 20);
}

TEST_CASE("nothing is drawn in transparent colours or with no width") {
    const auto draw = makePngDraw({{0, 0}, {10, 10}}, 64, kWhite);
    draw->disc({5, 5}, 3, {}, {});
    draw->line(std::vector<Vec2>{{0, 0}, {9, 9}}, {kBlack, 0.0, 0.0});
    draw->polygon(std::vector<Vec2>{{1, 1}, {9, 1}, {9, 9}}, Colour::of(0, 0.0),
                  {Colour::of(0, 0.0), 5.0, 0.0});
    draw->raster({{0, 0}, {9, 9}}, 1, 1, std::vector<Colour>{{}});
    draw->text({5, 5}, "", 20, kBlack, TextAnchor::Left);
    CHECK(pngOf(*draw).inked(0, 0, 64, 64) == 0);
}
