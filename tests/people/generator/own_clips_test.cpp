#include <set>
#include <string>

#include "base/maths.h"
#include "people/generator/measure.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("every clip is there, by its name, and valid") {
    const char* names[] = {"idle",
                           "walk",
                           "jog",
                           "run",
                           "sprint",
                           "duck",
                           "crawl",
                           "swim",
                           "walk-left",
                           "walk-right",
                           "jog-left",
                           "jog-right",
                           "run-left",
                           "run-right",
                           "turn-left",
                           "turn-right",
                           "start",
                           "start-walk",
                           "stop",
                           "stop-walk",
                           "duck-enter",
                           "duck-exit",
                           "crawl-enter",
                           "crawl-exit",
                           "swim-enter",
                           "swim-exit",
                           "jump",
                           "jump-over",
                           "climb",
                           "march-walk",
                           "march-walk-left",
                           "march-walk-right",
                           "march-jog",
                           "weary-walk",
                           "weary-walk-left",
                           "weary-walk-right",
                           "weary-jog"};
    for (const char* name : names) clipNamed(name);
    CHECK(ownClips().clips.size() == std::size(names));
    std::set<std::string> seen;
    for (const Clip& clip : ownClips().clips) {
        const Status status = validate(clip);
        CHECK_MESSAGE(status.ok(), status.message());
        CHECK_MESSAGE(seen.insert(clip.name).second, clip.name);
        CHECK(clip.rate == 60.0);
        CHECK(clip.travel.front().x == 0.0f);
        CHECK(clip.travel.front().yaw == 0.0f);
        CHECK(clip.entryPhase >= 0.0);
        CHECK(clip.entryPhase < 1.0);
        CHECK(clip.exitPhase >= 0.0);
        CHECK(clip.exitPhase < 1.0);
    }
}

TEST_CASE("motions and cycles are as named") {
    const std::set<std::string> cyclic{"idle",     "walk",      "jog",      "run",       "sprint",
                                       "duck",     "crawl",     "swim",     "walk-left", "walk-right",
                                       "jog-left", "jog-right", "run-left", "run-right"};
    for (const Clip& clip : ownClips().clips) {
        CHECK_MESSAGE(clip.cyclic == (cyclic.count(clip.name) == 1 || clip.set), clip.name);
        const std::string head = clip.name.substr(0, clip.name.find('-'));
        const bool special = head == "duck" || head == "crawl" || head == "swim" || head == "jump" ||
                             head == "climb";
        CHECK_MESSAGE(clip.motion == (special ? head : "run"), clip.name);
    }
}

TEST_CASE("speeds and lengths are the nominal ones") {
    const auto speed = [](const char* name) { return clipNamed(name).speed(); };
    CHECK(speed("idle") == 0.0);
    CHECK(speed("walk") == doctest::Approx(1.25).epsilon(1e-4));
    CHECK(speed("jog") == doctest::Approx(1.95).epsilon(1e-4));
    CHECK(speed("run") == doctest::Approx(2.6).epsilon(1e-4));
    CHECK(speed("sprint") == doctest::Approx(3.8).epsilon(1e-4));
    CHECK(speed("duck") == doctest::Approx(0.4 * 2.6).epsilon(1e-4));
    CHECK(speed("crawl") == doctest::Approx(0.2 * 2.6).epsilon(1e-4));
    CHECK(speed("swim") == doctest::Approx(0.3 * 2.6).epsilon(1e-4));
    CHECK(speed("jump") == doctest::Approx(0.8 * 2.6).epsilon(1e-3));
    CHECK(speed("jump-over") == doctest::Approx(0.8 * 2.6).epsilon(1e-3));
    CHECK(speed("climb") == doctest::Approx(0.15 * 2.6).epsilon(1e-3));
    CHECK(clipNamed("jump").length() == doctest::Approx(2.1).epsilon(0.01));
    CHECK(clipNamed("climb").length() == doctest::Approx(1.2).epsilon(0.01));
    CHECK(clipNamed("climb").duration() == doctest::Approx(1.2 / 0.39).epsilon(0.01));
    CHECK(clipNamed("duck-enter").duration() == doctest::Approx(0.4));
    CHECK(clipNamed("crawl-exit").duration() == doctest::Approx(1.0));
    CHECK(clipNamed("swim-enter").duration() == doctest::Approx(0.8));
    CHECK(clipNamed("climb").obstacle.height == 1.3f);
    CHECK(clipNamed("climb").obstacle.thickness == 0.4f);
    CHECK(clipNamed("jump-over").obstacle.height == 0.5f);
}

TEST_CASE("manners differ from plain walking as their words say") {
    // Mean lean of the trunk, from hips to head, and highest knee over a cycle.
    const auto posture = [](const char* name) {
        const Clip& clip = clipNamed(name);
        double lean = 0.0, knee = 0.0;
        for (std::size_t f = 0; f < clip.poses.size(); ++f) {
            JointTransforms joints;
            jointTransforms(clip.poses[f], {}, joints);
            const Vec3 trunk = joints[index(JointRole::Head)].translation - joints[0].translation;
            lean += static_cast<double>(trunk.x / trunk.z) / static_cast<double>(clip.poses.size());
            knee = std::max(knee, static_cast<double>(joints[index(JointRole::LeftLeg)].translation.z));
        }
        return std::pair(lean, knee);
    };
    const auto [plain, plainKnee] = posture("walk");
    const auto [march, marchKnee] = posture("march-walk");
    const auto [weary, wearyKnee] = posture("weary-walk");
    CHECK(march < plain);
    CHECK(march > -0.05);
    CHECK(weary > plain + 0.15);
    CHECK(marchKnee > plainKnee + 0.03);
    CHECK(wearyKnee < marchKnee);
}

TEST_CASE("bends go round circles, turns turn by a quarter") {
    const auto radius = [](const char* name) {
        const Travel last = clipNamed(name).travel.back();
        return (last.x * last.x + last.y * last.y) / (2.0 * last.y);
    };
    CHECK(radius("walk-left") == doctest::Approx(2.0).epsilon(1e-3));
    CHECK(radius("walk-right") == doctest::Approx(-2.0).epsilon(1e-3));
    CHECK(radius("jog-left") == doctest::Approx(2.5).epsilon(1e-3));
    CHECK(radius("run-right") == doctest::Approx(-3.0).epsilon(1e-3));
    CHECK(clipNamed("run-left").travel.back().yaw == doctest::Approx(1.95 / 3.0).epsilon(1e-3));
    CHECK(clipNamed("turn-left").travel.back().yaw == doctest::Approx(0.5 * kPi).epsilon(1e-5));
    CHECK(clipNamed("turn-right").travel.back().yaw == doctest::Approx(-0.5 * kPi).epsilon(1e-5));
}

TEST_CASE("made twice, the library is the same object") {
    CHECK(&ownClips() == &ownClips());
}
