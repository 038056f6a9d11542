#include "people/clips/motion_facts.h"

#include <doctest.h>

#include <nlohmann/json.hpp>

#include "base/text_file.h"
#include "people/clips/clip_samples.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("speeds agree with the analysis of the recordings within 2 %") {
    const auto text = readTextFile(mocapFolder() + "/analysis.json");
    if (!text.ok() || mocapNames().empty()) return;
    const auto analysis = nlohmann::json::parse(*text);
    std::size_t compared = 0;
    for (const std::string& name : mocapNames()) {
        const auto motion = readBvh(mocapFolder() + "/" + name + ".bvh");
        REQUIRE(motion.ok());
        const MotionFacts facts = factsOf(*motion);
        const std::size_t loop = name.find("_loop");
        const auto& known = analysis[name.substr(0, loop)];
        const bool whole = loop == std::string::npos;
        const double speed = whole ? known["v_net"] : known["loop"]["v"],
                     length = whole ? known["net_m"] : known["loop"]["stride_m"];
        const double duration = whole ? known["T"] : known["loop"]["dur"];
        // The analysis is rounded to millimetres: what stands has hardly a speed.
        CHECK_MESSAGE(std::fabs(facts.speed - speed) <= 0.02 * speed + 0.0005, name, ": ", facts.speed);
        CHECK_MESSAGE(std::fabs(facts.length - length) <= 0.02 * length + 0.0005, name, ": ", facts.length);
        CHECK_MESSAGE(facts.duration == doctest::Approx(duration).epsilon(0.002), name);
        ++compared;
    }
    CHECK(compared == 16);
}

TEST_CASE("figures of a clip are those of its file") {
    for (const bool cyclic : {true, false}) {
        const Clip clip = wavingClip(cyclic);
        const MotionFacts ours = factsOf(clip), file = factsOf(*parseBvh(bvhText(clip), "x.bvh"));
        CHECK(file.frames == ours.frames);
        CHECK(file.duration == doctest::Approx(ours.duration));
        CHECK(file.length == doctest::Approx(ours.length).epsilon(1e-5));
        CHECK(file.speed == doctest::Approx(ours.speed).epsilon(1e-5));
    }
}

TEST_CASE("the root is the first joint that moves") {
    // Above the hips a joint that stays where it is, turned and shifted.
    std::string text = HandMade{}.text();
    text.replace(text.find("ROOT Hips"), 9,
                 "ROOT World\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
                 "Yrotation\nJOINT Hips");
    text.replace(text.find("}\nMOTION"), 1, "}}");
    for (int f = 0; f < 3; ++f) {
        const std::string hips = "\n0 0.95 " + std::to_string(f);
        text.replace(text.find(hips), 1, "\n5 0 7 0 0 90 ");
    }
    const auto motion = parseBvh(text, "x.bvh");
    REQUIRE_MESSAGE(motion.ok(), motion.status().message());
    const RootPath path = rootPath(*motion);
    CHECK(path.length == doctest::Approx(2.0));
    CHECK(path.duration == doctest::Approx(0.1));
    const auto end = factsOf(*motion);
    CHECK(end.speed == doctest::Approx(20.0));
}

TEST_CASE("nothing is slower than the least ratio") {
    CHECK(speedRatio(0.0, 2.6) == kLeastRatio);
    CHECK(speedRatio(1.3, 2.6) == doctest::Approx(0.5));
    CHECK(speedRatio(1.0, 0.0) == kLeastRatio);
}
