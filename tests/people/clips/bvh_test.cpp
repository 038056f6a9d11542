#include "base/maths.h"
#include "muster/clip.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <random>

#include "base/text_file.h"
#include "people/clips/bvh_scanner.h"
#include "people/clips/bvh_text.h"
#include "people/clips/clip_samples.h"
#include "people/clips/retarget.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::string failureOf(const std::string& text) {
    const auto read = parseBvh(text, "x.bvh");
    REQUIRE_FALSE(read.ok());
    return read.status().message();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    return text.replace(at, what.size(), with);
}

void checkSame(const BvhMotion& a, const BvhMotion& b, float most) {
    REQUIRE(a.joints.size() == b.joints.size());
    REQUIRE(a.frames == b.frames);
    for (std::size_t j = 0; j < a.joints.size(); ++j)
        CHECK(distance(a.joints[j].offset, b.joints[j].offset) < most);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        REQUIRE(distance(a.values[i].translation, b.values[i].translation) < most);
        REQUIRE(angleBetween(a.values[i].rotation, b.values[i].rotation) < 1e-3);
    }
}

}  // namespace

TEST_CASE("a clip written as BVH comes back") {
    for (const bool cyclic : {true, false}) {
        const Clip clip = wavingClip(cyclic);
        const auto file = parseBvh(bvhText(clip), "wave.bvh");
        REQUIRE_MESSAGE(file.ok(), file.status().message());
        CHECK(file->unit == 0.01);
        CHECK(file->rate == 60.0);
        CHECK(file->frames == clip.poses.size() + (cyclic ? 1 : 0));
        CHECK(isOwnSkeleton(*file));
        const auto again = retarget(*file, {"wave", "run", cyclic});
        REQUIRE(again.ok());
        REQUIRE(again->poses.size() == clip.poses.size());
        REQUIRE(again->travel.size() == clip.travel.size());
        const ClipDifference most = differenceOf(clip, *again);
        CHECK(most.place < 1e-5);
        CHECK(most.turn < 2e-3);  // Of single precision near no turn.
    }
}

TEST_CASE("angles written for neighbouring frames do not jump") {
    // A full turn about each axis, also through where x is at a right angle.
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, normalized(Vec3{1, 2, -1})}) {
        BvhFrameWriter writer;
        std::vector<double> before;
        for (int f = 0; f <= 720; ++f) {
            BodyPose pose = restPose();
            pose.rotation[7] = axisAngle(axis, 0.01 * f);
            std::string line;
            writer.append({}, pose, line);
            BvhScanner numbers(line, "line");
            std::vector<double> now(12 + 3 * (kJointCount - 1));
            for (double& number : now) REQUIRE(numbers.number(number));
            if (axis.z == 0.0f || axis.y == 0.0f)
                for (std::size_t i = 0; i < before.size(); ++i) REQUIRE(std::fabs(now[i] - before[i]) < 5.0);
            before = now;
        }
    }
}

TEST_CASE("any order of channels is the product of turns in that order") {
    rc::check("orders", [] {
        const auto order = *rc::gen::element<std::string>("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX", "XY",
                                                          "Z");
        HandMade made;
        std::string text = made.text();
        std::string channels = "CHANNELS 3 Zrotation Xrotation Yrotation",
                    mine = "CHANNELS " + std::to_string(order.size());
        for (const char axis : order) mine += std::string(" ") + axis + "rotation";
        const std::size_t spine = text.find(channels);
        text.replace(spine, channels.size(), mine);
        std::string frames = "Frames: 1\nFrame Time: 0.1\n0 0.95 0 0 0 0";
        // In the file's axes by matrices, row by row: the second algorithm.
        std::array<std::array<double, 3>, 3> m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        for (const char axis : order) {
            const int degrees = *rc::gen::inRange(-180, 181);
            frames += " " + std::to_string(degrees) + ".0e0";
            const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
            const std::size_t a = (axis - 'X' + 1) % 3, b = (axis - 'X' + 2) % 3;
            for (auto& row : m)
                row = [&] {
                    auto r = row;
                    r[a] = row[a] * c + row[b] * s;
                    r[b] = row[b] * c - row[a] * s;
                    return r;
                }();
        }
        for (int j = 0; j < 7; ++j) frames += " 0 0 0";
        const auto read = parseBvh(text.substr(0, text.find("Frames:")) + frames, "x.bvh");
        RC_ASSERT(read.ok());
        for (std::size_t k = 0; k < 3; ++k) {
            // The file's unit vector k is ours: X left, Y up, Z ahead.
            const Vec3 ours[3] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
            const Vec3 turned = rotate(read->values[1].rotation, ours[k]);
            RC_ASSERT(std::fabs(turned.y - m[0][k]) < 1e-5);
            RC_ASSERT(std::fabs(turned.z - m[1][k]) < 1e-5);
            RC_ASSERT(std::fabs(turned.x - m[2][k]) < 1e-5);
        }
    });
}

TEST_CASE("spelling does not matter") {
    const HandMade made;
    const std::string plain = made.text();
    const auto expected = parseBvh(plain, "plain.bvh");
    REQUIRE_MESSAGE(expected.ok(), expected.status().message());
    std::string windows;
    for (const char c : plain) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    std::string shouted = plain;
    for (char& c : shouted) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    std::string small = plain;
    for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const std::string& text :
         {windows, shouted, small, "\xEF\xBB\xBF" + plain, plain.substr(0, plain.find_last_not_of('\n') + 1),
          replaced(plain, "Frames: 3\nFrame Time: 0.05", "Frames:3\nFrame Time:\t5e-2"),
          replaced(plain, "Frames: 3\nFrame Time: 0.05", "Frames : 3\nFrameTime : +.05"),
          replaced(plain, "End Site", "EndSite"), replaced(plain, "End Site {", "End Site {")}) {
        const auto read = parseBvh(text, "x.bvh");
        REQUIRE_MESSAGE(read.ok(), read.status().message());
        checkSame(*expected, *read, 1e-6f);
    }
}

TEST_CASE("every usual unit is recognised, and may be given") {
    for (const double unit : {1.0, 0.01, 0.001, 0.0254, 0.3048, 0.0254 / 0.45}) {
        HandMade made{.scale = 1.0 / unit};
        const auto read = parseBvh(made.text(), "x.bvh");
        REQUIRE(read.ok());
        CHECK(read->unit == unit);
        CHECK(read->values.back().translation.z == doctest::Approx(-0.41).epsilon(1e-4));
        CHECK(read->frame(2)[0].translation.x == doctest::Approx(2.0).epsilon(1e-4));
        const auto given = parseBvh(made.text(), "x.bvh", {0.5});
        REQUIRE(given.ok());
        CHECK(given->frame(2)[0].translation.x == doctest::Approx(1.0 / unit).epsilon(1e-4));
    }
    HandMade giant{.scale = 1e5};
    CHECK(failureOf(giant.text()).find("name the unit") != std::string::npos);
    CHECK_FALSE(parseBvh(giant.text(), "x.bvh", {-1.0}).ok());
}

TEST_CASE("Y or Z up and any quarter turn give the same motion") {
    HandMade made;
    const auto expected = parseBvh(made.text(), "y.bvh");
    REQUIRE(expected.ok());
    CHECK(expected->frame(1)[0].translation == Vec3{1.0f, 0.0f, 0.95f});
    made.zUp = true;
    const auto z = parseBvh(made.text(), "z.bvh");
    REQUIRE(z.ok());
    checkSame(*expected, *z, 1e-5f);
    // Facing +X: left is -Z.
    for (const auto& name : mocapNames()) {
        if (name != "run_dm") continue;
        const auto run = readBvh(mocapFolder() + "/run_dm.bvh");
        REQUIRE(run.ok());
        CHECK(run->frame(24)[0].translation.x == doctest::Approx(2.8454));
    }
}

TEST_CASE("positions of joints below the root stand for the offset or add to it, as the file means it") {
    const HandMade made;
    const std::string joint = "JOINT Spine { OFFSET 0 0.1 0 CHANNELS 3 ",
                      six = "JOINT Spine { OFFSET 0 0.1 0 CHANNELS 6 Xposition Yposition Zposition ";
    for (const char* channels : {"0 0.1 0", "0 0 0", "0.001 0.099 0"}) {
        std::string text = replaced(made.text(), joint, six);
        text = replaced(text, "Frames: 3", "Frames: 1");
        text = text.substr(0, text.find("0.05\n") + 5) + "0 0.95 0 0 0 0 " + channels;
        for (int j = 0; j < 8; ++j) text += " 0 0 0";
        const auto read = parseBvh(text, "x.bvh");
        REQUIRE_MESSAGE(read.ok(), read.status().message());
        CHECK(read->values[1].translation.z == doctest::Approx(0.1).epsilon(0.02));
    }
}

TEST_CASE("frame times are rounded decimals of whole rates") {
    for (const auto& [time, rate] : {std::pair{"0.0333333", 30.0},
                                     {"0.033332", 30.0},
                                     {"0.0083333", 120.0},
                                     {"0.0166667", 60.0},
                                     {"0.04", 25.0}}) {
        const auto read = parseBvh(replaced(HandMade{}.text(), "Time: 0.05", std::string("Time: ") + time),
                                   "x.bvh");
        REQUIRE(read.ok());
        CHECK(read->rate == rate);
    }
    CHECK(parseBvh(replaced(HandMade{}.text(), "Time: 0.05", "Time: 0.0421"), "x.bvh")->rate ==
          doctest::Approx(1 / 0.0421));
}

TEST_CASE("what is wrong is said with its line") {
    const std::string good = HandMade{}.text();
    const auto has = [](const std::string& message, std::initializer_list<const char*> parts) {
        for (const char* part : parts) CHECK_MESSAGE(message.find(part) != std::string::npos, message);
    };
    has(failureOf(""), {"x.bvh:1:", "the end of the file", "HIERARCHY"});
    has(failureOf("{\"json\": 1}"), {"x.bvh:1:", "HIERARCHY"});
    has(failureOf(replaced(good, "OFFSET 0 0 0", "OFFSET 0 zero 0")), {"x.bvh:4:", "\"zero\"", "coordinate"});
    has(failureOf(replaced(good, "CHANNELS 6", "CHANNELS 7")), {"x.bvh:5:", "\"7\"", "0 to 6"});
    has(failureOf(replaced(good, "Yposition", "Xposition")), {"x.bvh:5:", "different channels"});
    has(failureOf(replaced(good, "Yposition", "Yscale")), {"\"Yscale\""});
    has(failureOf(replaced(good, "JOINT Spine {", "JOINT Spine CHANNELS")), {"\"{\""});
    has(failureOf(replaced(good, "Frames: 3", "Frames: 0")), {"\"0\"", "frames > 0"});
    has(failureOf(replaced(good, "Frames: 3", "Frames: 2.5")), {"\"2.5\""});
    has(failureOf(good.substr(0, good.size() - 3)), {"x.bvh:23:", "the end of the file", "a number"});
    has(failureOf(replaced(good, "Frames: 3", "Frames: 2")), {"expected the end of the file"});
    has(failureOf(replaced(good, "Frames: 3", "Frames: 900000")), {"too short"});
    has(failureOf(replaced(good, "Frames: 3", "Frames: 999999999")), {"found 999999999 frames"});
    has(failureOf(replaced(good, "Time: 0.05", "Time: 0")), {"frame time"});
    has(failureOf(replaced(good, "Time: 0.05", "Time: -1")), {"frame time"});
    has(failureOf(replaced(good, "0 0.95 0", "0 nan 0")), {"\"nan\"", "a number"});
    has(failureOf(replaced(good, "0 0.95 0", "0 1e400 0")), {"a number"});
    has(failureOf(replaced(good, "MOTION", "}")), {"MOTION"});
    CHECK(readBvh("/nowhere/x.bvh").status().code() == StatusCode::IoError);
    std::string deep = "HIERARCHY\nROOT a\n{\n";
    for (int i = 0; i < 100000; ++i) deep += "JOINT j {\n";
    CHECK(parseBvh(deep, "deep.bvh").status().code() == StatusCode::LimitExceeded);
}

TEST_CASE("numbers are what the C library reads") {
    rc::check("numbers", [] {
        const auto digits = *rc::gen::container<std::string>(
            rc::gen::inRange('0', static_cast<char>('9' + 1)));
        const auto point = *rc::gen::inRange<std::size_t>(0, digits.size() + 1);
        const auto exponent = *rc::gen::inRange(-40, 9);
        std::string text = *rc::gen::element<std::string>("", "-", "+");
        text += digits.substr(0, point) + "." + digits.substr(point);
        if (exponent % 3 != 0) text += "e" + std::to_string(exponent);
        BvhScanner scanner(text, "x");
        double found = 0.0;
        const double expected = std::strtod(text.c_str(), nullptr);
        RC_ASSERT(scanner.number(found) == (!digits.empty() && std::fabs(expected) <= 1e9));
        if (!digits.empty()) RC_ASSERT(found == expected);
    });
}

TEST_CASE("damaged files never do worse than fail") {
    std::vector<std::string> sources{HandMade{}.text(), bvhText(wavingClip(true, 4))};
    for (const std::string& name : mocapNames())
        if (name == "run_dm" || name == "sneak_walk_dm")
            sources.push_back(*readTextFile(mocapFolder() + "/" + name + ".bvh"));
    std::mt19937 random(7);
    const std::string spice = "{}\n 0.-e:9ROTJEndMFrames\t";
    std::size_t read = 0, refused = 0;
    for (const std::string& source : sources) {
        for (int trial = 0; trial < 400; ++trial) {
            std::string text = source;
            for (int change = 0; change < 1 + trial % 4; ++change) {
                const std::size_t at = random() % text.size(), many = random() % 20;
                switch (random() % 4) {
                    case 0:
                        text[at] = spice[random() % spice.size()];
                        break;
                    case 1:
                        text.erase(at, many);
                        break;
                    case 2:
                        text.insert(at, text.substr(random() % text.size(), many));
                        break;
                    default:
                        text.resize(std::max<std::size_t>(1, at));
                        break;
                }
            }
            const auto motion = parseBvh(text, "x.bvh");
            if (!motion.ok()) {
                CHECK(motion.status().message().substr(0, 5) == "x.bvh");
                ++refused;
                continue;
            }
            ++read;
            const auto clip = retarget(*motion);
            if (clip.ok()) CHECK(validate(*clip).ok());
        }
    }
    CHECK(read > 20);
    CHECK(refused > 100);
}
