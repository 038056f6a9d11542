#include "lab/picture/pose_strip.h"

#include <doctest.h>

#include "lab/picture/xml.h"

using namespace muster;

namespace {

Clip standing(bool cyclic) {
    Clip clip{.name = "stand & stay", .motion = "run", .cyclic = cyclic};
    clip.poses.assign(30, restPose());
    clip.travel.assign(cyclic ? 31 : 30, {});
    clip.contacts.push_back({Limb::LeftFoot, 0.0, 0.2, {0.0f, 0.09f, 0.08f}});
    return clip;
}

std::size_t countOf(const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE("a strip has the requested number of bodies in each row") {
    PoseStripDef def{.poses = 3};
    const std::string one = poseStrip(standing(true), def, false);
    def.front = def.oblique = false;
    const std::string side = poseStrip(standing(true), def, false);
    def.poses = 6;
    const std::string twice = poseStrip(standing(true), def, false);
    CHECK(one.find("<svg") != std::string::npos);
    CHECK(one.find("stand &amp; stay") != std::string::npos);
    CHECK(countOf(one, "<path") > 2 * countOf(side, "<path"));
    // All shapes except the discs that mark contacts double with the columns.
    CHECK(countOf(twice, "<path") >= 2 * countOf(side, "<path") - 12);
}

TEST_CASE("a PNG strip has the proportions of the SVG strip") {
    PoseStripDef def{.poses = 2, .pixelsPerMetre = 40};
    const std::string png = poseStrip(standing(false), def, true);
    REQUIRE(png.size() > 100);
    CHECK(png.substr(1, 3) == "PNG");
    const auto number = [&](std::size_t at) {
        return (static_cast<unsigned char>(png[at + 2]) << 8) + static_cast<unsigned char>(png[at + 3]);
    };
    CHECK(number(16) == static_cast<int>(2 * def.columnWidth * 40));
    CHECK(number(20) > 3 * 2 * 40);
}

TEST_CASE("walls, hurdles and water are drawn where a clip has them") {
    PoseStripDef def{.poses = 2};
    Clip clip = standing(false);
    const std::size_t plain = countOf(poseStrip(clip, def, false), "<path");
    clip.obstacle = {0.5f, 0.2f};
    const std::size_t hurdle = countOf(poseStrip(clip, def, false), "<path");
    clip.obstacle = {};
    clip.motion = "swim";
    const std::size_t water = countOf(poseStrip(clip, def, false), "<path");
    CHECK(hurdle > plain);
    CHECK(water > plain);
}
