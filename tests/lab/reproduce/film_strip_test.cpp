// Film strips and the pictures in them.
#include "lab/reproduce/report/drawings.h"

#include <doctest.h>

#include <map>
#include <set>

#include "files/report/markup.h"
#include "lab/picture/xml.h"
#include "lab/reproduce/fake.h"

using namespace muster;
using muster::testing::Element;
using muster::testing::fakePicture;
using muster::testing::XmlReader;

namespace {

std::vector<FilmFrame> frames(std::size_t count, double height = 300.0) {
    std::vector<FilmFrame> film;
    for (std::size_t i = 0; i < count; ++i)
        film.push_back({static_cast<double>(i) * 1.5, "picture", fakePicture(height, "#1D5FD1")});
    return film;
}

/// Pictures inside the strip.
std::vector<Element> nested(const XmlReader& xml) {
    std::vector<Element> list;
    for (const Element& element : xml.all("svg"))
        if (element.depth == 1) list.push_back(element);
    return list;
}

}  // namespace

TEST_CASE("rows of a strip are equally long") {
    const std::map<std::size_t, int> wanted = {{0, 1}, {1, 1}, {2, 2}, {4, 4}, {5, 3},
                                               {6, 3}, {7, 4}, {9, 3}, {10, 4}};
    for (const auto& [count, columns] : wanted) CHECK(stripColumns(count) == columns);
    CHECK(stripColumns(5, 2) == 2);
    CHECK(stripColumns(5, 0) == 1);
}

TEST_CASE("a strip holds every picture with its time and words, in rows") {
    auto film = testing::fakeRun(20.0, 1, true).film;
    const std::string svg = filmStrip(film);
    const XmlReader xml(svg);
    REQUIRE(xml.error.empty());
    REQUIRE(nested(xml).size() == 4);  // One has no picture.
    CHECK(svg.find(">no picture<") != std::string::npos);
    CHECK(svg.find(">4.2 s<") != std::string::npos);
    CHECK(svg.find("the first &lt;36&gt; of &quot;them&quot; duck") != std::string::npos);
    // Three in the first row, then two; none beyond the strip, none over another.
    const Element root = xml.elements.front();
    const auto pictures = nested(xml);
    CHECK(pictures[0].number("y") == pictures[2].number("y"));
    CHECK(pictures[3].number("y") > pictures[0].number("y") + pictures[0].number("height"));
    for (const Element& picture : pictures) {
        CHECK(picture.number("width") == 440.0);
        CHECK(picture.number("x") + picture.number("width") <= root.number("width"));
        CHECK(picture.number("y") + picture.number("height") <= root.number("height"));
    }
    CHECK(pictures[2].number("height") == 220.0);
    // Words stay within the width of their picture, as far as that is known without a font.
    for (const Element& text : xml.all("text")) {
        CHECK(text.number("y") <= root.number("height"));
        if (text.depth == 1) CHECK(text.text.size() <= 40);
    }
}

TEST_CASE("pictures in one strip keep their ids apart") {
    const std::string svg = filmStrip(frames(3));
    const XmlReader xml(svg);
    REQUIRE(xml.error.empty());
    std::set<std::string> ids;
    for (const Element& element : xml.elements)
        if (!element.attribute("id").empty()) CHECK(ids.insert(element.attribute("id")).second);
    CHECK(ids.size() == 3);
    for (const Element& use : xml.all("use")) CHECK(ids.count(use.attribute("href").substr(1)) == 1);
    for (const std::string& id : ids) CHECK(svg.find("url(#" + id + ")") != std::string::npos);
}

TEST_CASE("no pictures make no strip") {
    CHECK(filmStrip({}).empty());
}

TEST_CASE("letters of a strip of four are at least 7 points high on 180 mm") {
    const XmlReader xml(filmStrip(frames(4)));
    REQUIRE(xml.error.empty());
    const double pointsPerPixel = 180.0 / 25.4 * 72.0 / xml.elements.front().number("width");
    for (const Element& text : xml.all("text"))
        if (text.depth == 1) CHECK(text.number("font-size") * pointsPerPixel >= 7.0);
}

TEST_CASE("pictures are measured and nested whatever stands before them") {
    const std::string picture = "<?xml version=\"1.0\"?>\n" + fakePicture(200, "#000000");
    CHECK(pictureSize(picture).width == 440.0);
    CHECK(pictureSize(picture).height == 200.0);
    CHECK(pictureSize("<svg viewBox=\"0 0 30 40\"></svg>").height == 40.0);
    CHECK(pictureSize("<svg width=\"x\" height=\"-3\"></svg>").width == 0.0);
    CHECK(pictureSize("").width == 0.0);
    const std::string inner = nestedPicture(picture, " x=\"5\" width=\"10\"", "p-");
    const XmlReader xml(inner);
    CHECK(xml.error.empty());
    CHECK(xml.elements.front().number("x") == 5.0);
    CHECK(xml.elements.front().number("width") == 10.0);
    CHECK(xml.elements.front().attribute("height").empty());
    CHECK(xml.elements.front().attribute("viewBox") == "0 0 440 200");
    CHECK(nestedPicture("words", "", "p-").empty());
    CHECK(nestedPicture("<svg", "", "p-").empty());
    CHECK(nestedPicture("<svg width=\"7\" height=\"9\"></svg>", "", "p-").find("viewBox=\"0 0 7 9\"") !=
          std::string::npos);
}
