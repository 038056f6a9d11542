// Motion in frames: clips for all characters, whole poses near the points that clients look at.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "muster/own_clips.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr std::size_t kNumbersPerPose = 3 + 3 * kJointCount;

/// The ids nearest to a point, found by sorting all characters.
std::vector<std::uint32_t> nearest(const PageFrame& page, Vec2 spot, std::size_t count) {
    std::vector<std::pair<double, std::uint32_t>> all;
    for (std::size_t i = 0; i < page.ids.size(); ++i)
        all.emplace_back(lengthSquared(Vec2{page.x[i], page.y[i]} - spot), page.ids[i]);
    std::sort(all.begin(), all.end());
    std::vector<std::uint32_t> result;
    for (std::size_t k = 0; k < count; ++k) result.push_back(all[k].second);
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<std::uint32_t> idsOf(const protocol::Frame& frame, const std::vector<std::uint32_t>& ids) {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t index : frame.crowd.near) result.push_back(ids.at(index));
    return result;
}

void attend(FakeClient& client, float x, float y, std::uint32_t count) {
    protocol::Attend message{.x = x, .y = y, .count = count};
    client.send(message);
}

}  // namespace

TEST_CASE("motions come once, before the first frame, with skeleton and clips") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.5, {&client});
    REQUIRE(client.motions.size() == 1);
    CHECK(client.framesBeforeMotions == 0);
    const protocol::Motions& motions = client.motions.front();
    REQUIRE(motions.joints.size() == kJointCount);
    CHECK(motions.joints[0].parent == 0);
    CHECK(motions.joints[index(JointRole::LeftForeArm)].name == "LeftForeArm");
    CHECK(motions.joints[index(JointRole::LeftForeArm)].parent == index(JointRole::LeftArm));
    REQUIRE(motions.clips.size() == ownClips().clips.size());
    REQUIRE(!motions.clips.empty());
    for (std::size_t c = 0; c < motions.clips.size(); ++c) {
        const protocol::ClipFrames& sent = motions.clips[c];
        const Clip& own = ownClips().clips[c];
        CHECK(sent.name == own.name);
        REQUIRE(sent.poses == own.poses.size());
        REQUIRE(sent.hips.size() == 3 * own.poses.size());
        REQUIRE(sent.rotations.size() == 4 * kJointCount * own.poses.size());
        const Quat last = own.poses.back().rotation[kJointCount - 1];
        CHECK(sent.rotations.back() / 32767.0f == doctest::Approx(last.w).epsilon(1e-4));
    }
}

TEST_CASE("every character has a clip; none has a whole pose until a client looks") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.3, {&client});
    const protocol::Frame& frame = client.frames.back();
    CHECK(client.page.clip.size() == 16);
    for (const std::uint8_t clip : client.page.clip) CHECK(clip < ownClips().clips.size());
    REQUIRE(client.page.phase.size() == 16);
    CHECK(std::any_of(client.page.phase.begin(), client.page.phase.end(),
                      [](double phase) { return phase > 0.0; }));
    CHECK(frame.crowd.near.empty());
    CHECK(frame.crowd.nearPoses.empty());
}

TEST_CASE("the characters nearest to where a client looks have whole poses") {
    Session session = startedSession();
    FakeClient client(session);
    run(session, 0.1, {&client});
    const std::vector<std::uint32_t> ids = client.frames.front().ids;
    REQUIRE(ids.size() == 16);
    attend(client, 9.0f, 7.0f, 5);
    run(session, 0.1, {&client});
    const protocol::Frame& frame = client.frames.back();
    REQUIRE(frame.crowd.near.size() == 5);
    CHECK(std::is_sorted(frame.crowd.near.begin(), frame.crowd.near.end()));
    CHECK(idsOf(frame, ids) == nearest(client.page, {9.0, 7.0}, 5));
    REQUIRE(frame.crowd.nearPoses.size() == 5 * kNumbersPerPose);
    for (std::size_t k = 0; k < 5; ++k) {
        const std::int16_t* pose = frame.crowd.nearPoses.data() + k * kNumbersPerPose;
        CHECK(pose[2] > 700);  // The character stands: height of the hips above the ground [mm].
        CHECK(pose[2] < 1100);
        for (const Quat& q : PageDecoder::turns(pose))
            CHECK(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w == doctest::Approx(1.0).epsilon(1e-5));
        // The head of a standing character is level: the rotations from the hips on nearly cancel.
        const Quat hips = PageDecoder::turns(pose).front();
        CHECK(std::fabs(hips.w) > 0.9);
        const std::size_t who = frame.crowd.near[k];
        CHECK(std::fabs(frame.crowd.nearPlaces[3 * k] - client.page.x[who]) < 0.001);
        CHECK(std::fabs(std::remainder(frame.crowd.nearPlaces[3 * k + 2] - client.page.heading[who],
                                       6.283185307179586)) < 2e-4);
    }
    attend(client, 0.0f, 0.0f, 0);
    run(session, 0.1, {&client});
    CHECK(client.frames.back().crowd.near.empty());
}

TEST_CASE("two clients look at two points") {
    Session session = startedSession();
    FakeClient one(session), two(session);
    run(session, 0.1, {&one, &two});
    attend(one, 9.0f, 9.0f, 1);
    attend(two, -9.0f, -9.0f, 2);
    run(session, 0.2, {&one, &two});
    CHECK(one.frames.back().crowd.near.size() == 3);
    CHECK(one.frames.back().crowd.near == two.frames.back().crowd.near);
}

TEST_CASE("a request for too many poses or without a position is refused and changes nothing") {
    Session session = startedSession();
    FakeClient client(session);
    attend(client, 0.0f, 0.0f, 500);
    run(session, 0.2, {&client});
    CHECK(client.frames.back().crowd.near.size() == 16);
    attend(client, 0.0f, 0.0f, 501);
    run(session, 0.2, {&client});
    CHECK(client.noticed("Attend").find("501") != std::string::npos);
    CHECK(client.frames.back().crowd.near.size() == 16);
    attend(client, std::numeric_limits<float>::quiet_NaN(), 0.0f, 3);
    run(session, 0.2, {&client});
    CHECK(client.noticed("Attend").find("not finite") != std::string::npos);
    CHECK(client.frames.back().crowd.near.size() == 16);
}

TEST_CASE("looking changes nothing in the world") {
    Session watched = startedSession(), alone = startedSession();
    FakeClient client(watched);
    attend(client, 1.0f, 1.0f, 16);
    run(watched, 1.0, {&client});
    run(alone, 1.0);
    CHECK(watched.world()->stepCount() == alone.world()->stepCount());
    CHECK(watched.world()->hash() == alone.world()->hash());
}

TEST_CASE("clips that cannot be read give a notice, and people move by Muster's own") {
    SessionDef def = sessionDef();
    def.loadClips = [](const std::string&, const WorldDef&) -> Result<ClipLibrary> {
        return Status(StatusCode::NotFound, "hop.bvh: there is no such file");
    };
    Session session(std::move(def));
    FakeClient client(session);
    REQUIRE(session.load("small", smallFloor()).ok());
    run(session, 0.2, {&client});
    CHECK(client.noticed("clips").find("hop.bvh") != std::string::npos);
    REQUIRE(client.motions.size() == 1);
    CHECK(client.motions.front().clips.size() == ownClips().clips.size());
    FakeClient late(session);
    run(session, 0.1, {&late});
    CHECK(late.noticed("clips").find("hop.bvh") != std::string::npos);
}

TEST_CASE("clips that frames cannot represent are refused by name, and people move by Muster's own") {
    const auto refused = [](const std::function<void(ClipLibrary&)>& change) {
        SessionDef def = sessionDef();
        def.loadClips = [&change](const std::string&, const WorldDef&) -> Result<ClipLibrary> {
            ClipLibrary library = ownClips();
            change(library);
            return library;
        };
        Session session(std::move(def));
        FakeClient client(session);
        REQUIRE(session.load("small", smallFloor()).ok());
        run(session, 0.1, {&client});
        CHECK(client.motions.front().clips.size() == ownClips().clips.size());
        return client.noticed("clips");
    };
    const auto slowed = [](double rate) {
        return [rate](ClipLibrary& library) { library.clips[1].rate = rate; };
    };
    const double frames = static_cast<double>(ownClips().clips[1].poses.size());
    CHECK(refused(slowed(frames / 70.0)).find("motion \"walk\" in seconds: found 70, expected at most 65") !=
          std::string::npos);
    CHECK(refused(slowed(frames / 60.0)).empty());
    const std::string many = refused(
        [](ClipLibrary& library) { library.clips.resize(257, library.clips.front()); });
    CHECK(many.find("motions: found 257, expected at most 256") != std::string::npos);
    const std::string long_ = refused([](ClipLibrary& library) {
        Clip& clip = library.clips[0];
        clip.rate = 2000.0;
        clip.poses.resize(50'001, clip.poses.front());
        clip.travel.resize(50'002);
    });
    CHECK(long_.find("frames of all motions: found ") != std::string::npos);
}

TEST_CASE("another library is sent again, the same one is not") {
    SessionDef def = sessionDef();
    bool two = false;
    def.loadClips = [&two](const std::string&, const WorldDef&) -> Result<ClipLibrary> {
        ClipLibrary library = ownClips();
        if (two) library.clips.back().name = "hop";
        return library;
    };
    Session session(std::move(def));
    FakeClient client(session);
    REQUIRE(session.load("small", smallFloor()).ok());
    run(session, 0.1, {&client});
    REQUIRE(session.load("small", smallFloor()).ok());
    run(session, 0.1, {&client});
    CHECK(client.motions.size() == 1);
    two = true;
    REQUIRE(session.load("small", smallFloor()).ok());
    run(session, 0.1, {&client});
    REQUIRE(client.motions.size() == 2);
    CHECK(client.motions.back().clips.back().name == "hop");
}

TEST_CASE("whole poses follow the crowd as it grows, shrinks and restarts") {
    Session session = startedSession();
    FakeClient client(session);
    attend(client, 0.0f, 0.0f, 500);
    run(session, 0.2, {&client});
    const auto group = static_cast<std::uint32_t>(client.meshes.front().group);
    for (const std::uint32_t count : {40u, 3u, 25u}) {
        client.send(commandsOf(ChangeGroup{.group = GroupId{group}, .count = count}));
        run(session, 0.3, {&client});
        const protocol::Frame& frame = client.frames.back();
        CHECK(frame.crowd.count == count);
        CHECK(client.page.clip.size() == count);
        REQUIRE(frame.crowd.near.size() == count);
        CHECK(frame.crowd.near.back() == count - 1);
        CHECK(frame.crowd.nearPoses.size() == count * kNumbersPerPose);
    }
    client.send(protocol::Playback{protocol::PlaybackAction::Restart});
    run(session, 0.3, {&client});
    CHECK(client.frames.back().crowd.near.size() == 16);
    CHECK(client.motions.size() == 1);
}

TEST_CASE("while paused nothing moves; a single step advances motion by a sixtieth of a second") {
    Session session = startedSession();
    FakeClient client(session);
    attend(client, 0.0f, 0.0f, 4);
    run(session, 0.5, {&client});
    client.send(protocol::Playback{protocol::PlaybackAction::Pause});
    run(session, 0.2, {&client});
    const std::vector<double> before = client.page.phase;
    const std::vector<std::uint8_t> clips = client.page.clip;
    run(session, 0.5, {&client});
    CHECK(client.page.phase == before);
    client.send(protocol::Playback{protocol::PlaybackAction::SingleStep});
    run(session, 0.2, {&client});
    const std::vector<double>& after = client.page.phase;
    REQUIRE(after.size() == before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
        // An idle character has its own cadence; a clip may also wrap into its next cycle.
        const double moved = 1000.0 * (after[i] - before[i]) * ownClips().clips[clips[i]].duration();
        CHECK_MESSAGE(((moved >= 11 && moved <= 23) || moved < 0), moved);
    }
}

TEST_CASE("a replay shows the recorded motion") {
    Session session = startedSession();
    FakeClient client(session);
    attend(client, 0.0f, 0.0f, 16);
    run(session, 0.1, {&client});
    client.touchAt(TouchPhase::Down, {0.0, 0.0}, 1.0);
    client.touchAt(TouchPhase::Move, {4.0, 1.0}, 1.1);
    run(session, 1.5, {&client});
    const protocol::Frame seen = client.frames.back();
    const PageFrame seenPage = client.page;
    const auto take = session.take();
    REQUIRE(take.ok());
    Session again{sessionDef()};
    REQUIRE(again.openTake(*take, "seen.take").ok());
    FakeClient viewer(again);
    attend(viewer, 0.0f, 0.0f, 16);
    for (int look = 0; look < 600 && (viewer.frames.empty() || viewer.frames.back().step < seen.step); ++look)
        run(again, 1.0 / 60.0, {&viewer});
    const protocol::Frame& shown = viewer.frames.back();
    REQUIRE(shown.step == seen.step);
    CHECK(viewer.page.clip == seenPage.clip);
    CHECK(viewer.page.phase == seenPage.phase);
    CHECK(viewer.page.heading == seenPage.heading);
    CHECK(shown.crowd.near == seen.crowd.near);
}
