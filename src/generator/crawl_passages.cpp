#include "generator/crawl.h"
#include "generator/keyed.h"
#include "generator/low_passages.h"
#include "generator/passages.h"

namespace muster::generator {
namespace {

constexpr int kFrames = 60;
constexpr double kEnd = kFrames / kFrameRate;  // [s]

/// Down from running: the right foot lunges, the left knee comes down first.
Clip enterClip() {
    constexpr double kKnee = 0.56, kLow = 0.60, kLunge = 0.30, kLift = 0.66;
    const GaitTrack jog(jogGait());
    const CrawlTrack crawl(kKnee);
    Course course;
    const auto way = changingSpeed(jog.gait().speed, CrawlTrack::kSpeed, 0.0, kLow);
    course.travel = straight(way);
    course.body = [=](double time) {
        Body body = blend(jog.body(time), crawl.figure(time).body, rise(0.0, kLow, time));
        body[Channel::HeadPitch] -= degrees(10) * hump(0.1, 0.8, time);
        return body;
    };
    const auto crawling = [&](double time) { return crawl.figure(time); };
    Step left = jog.step(0, 0, jog.course()), never = left, lunge = jog.step(1, 0, jog.course());
    left.end = 0.34;
    left.swing = {};
    never.begin = kEnd + 0.5;
    never.end = kEnd + 1.0;
    lunge.begin = kLunge;
    lunge.end = kLift;
    lunge.anchor.x = static_cast<float>(way(kLunge)) + 0.13f;
    lunge.anchor.y = -0.11f;
    lunge.push = degrees(60);
    lunge.rise = 0.3;
    lunge.swing = {};
    const LegTrack legs[2] = {
        LegTrack(0, {jog.step(0, -1, jog.course()), left, never}, course, {}, joinOf(crawling, 0, kLow)),
        LegTrack(1, {jog.step(1, -1, jog.course()), lunge, never}, course, jog.leg(1).join(0.0), joinOf(crawling, 1, 0.92))};
    ClipPlan plan;
    plan.name = "crawl-enter";
    plan.motion = "crawl";
    plan.frames = kFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        Figure figure{course.body(time), {}, {}};
        const Figure low = crawl.figure(time);
        figure.reach = low.reach;
        for (Reach& reach : figure.reach) reach.weight = rise(0.22, kLow - 0.02, time);
        figure.legs = {time < kLow ? legs[0].at(time) : low.legs[0], time < 0.92 ? legs[1].at(time) : low.legs[1]};
        return figure;
    };
    addContacts(plan.contacts, 0, {left}, kEnd, false);
    addContacts(plan.contacts, 1, {lunge}, kEnd, false);
    const double stay = CrawlTrack::kContact * CrawlTrack::kCycle;
    const auto onGround = [&](Limb limb, Vec3 anchor, double begin, double end) {
        anchor.x += static_cast<float>(way(kEnd) - crawl.travel(kEnd).x);
        plan.contacts.push_back({limb, begin, std::min(kEnd, end), anchor});
    };
    onGround(Limb::LeftKnee, crawl.kneeAnchor(0, 0), kLow, crawl.kneeLanding(0, 0) + stay);
    onGround(Limb::RightHand, crawl.handAnchor(1, 0), kLow, crawl.handLanding(1, 0) + stay);
    onGround(Limb::LeftHand, crawl.handAnchor(0, -1), kLow, crawl.handLanding(0, -1) + stay);
    plan.entryPhase = (kEnd - kKnee) / CrawlTrack::kCycle;
    plan.exitPhase = 0.0;
    return makeClip(std::move(plan));
}

/// Up to running: the right foot steps forward, the left leg swings through.
Clip exitClip() {
    constexpr double kPhase = 0.08, kFoot = 0.36, kUp = 0.38, kStrike = 0.80;
    const Gait gait = jogGait();
    const GaitTrack jog(gait, kStrike);
    const CrawlTrack crawl(-kPhase * CrawlTrack::kCycle);
    const auto way = changingSpeed(CrawlTrack::kSpeed, gait.speed, 0.25, kEnd);
    Course course;
    course.travel = straight(way);
    course.body = [=](double time) {
        Body body = blend(crawl.figure(time).body, jog.body(time), rise(kUp - 0.02, kEnd, time));
        body[Channel::ChestPitch] += degrees(6) * hump(kUp, kEnd, time);
        return body;
    };
    const auto crawling = [&](double time) { return crawl.figure(time); };
    Step never = jog.step(0, -2, course), planted = jog.step(1, -1, course);
    never.begin = -1.0;
    never.end = -0.5;
    never.swing = {};
    planted.begin = kFoot;
    planted.end = 0.73;
    planted.anchor.x = static_cast<float>(way(kFoot)) - 0.02f;
    planted.anchor.y = -0.10f;
    planted.push = degrees(58);
    planted.rise = 0.3;
    const LegTrack legs[2] = {
        LegTrack(0, {never, jog.step(0, 0, course), jog.step(0, 1, course)}, course, joinOf(crawling, 0, kUp)),
        LegTrack(1, {never, planted, jog.step(1, 0, course)}, course, joinOf(crawling, 1, 0.04), jog.leg(1).join(kEnd))};
    ClipPlan plan;
    plan.name = "crawl-exit";
    plan.motion = "crawl";
    plan.frames = kFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        Figure figure{course.body(time), {}, {}};
        const Figure low = crawl.figure(time);
        figure.reach = low.reach;
        for (Reach& reach : figure.reach) reach.weight = 1.0 - rise(0.40, 0.72, time);
        figure.legs = {time < kUp ? low.legs[0] : legs[0].at(time), time < 0.04 ? low.legs[1] : legs[1].at(time)};
        return figure;
    };
    addContacts(plan.contacts, 0, {jog.step(0, 0, course)}, kEnd, false);
    addContacts(plan.contacts, 1, {planted}, kEnd, false);
    const double first = crawl.travel(0.0).x;
    const auto onGround = [&](Limb limb, Vec3 anchor, double end) {
        anchor.x -= static_cast<float>(first);
        plan.contacts.push_back({limb, 0.0, end, anchor});
    };
    onGround(Limb::LeftKnee, crawl.kneeAnchor(0, 0), kUp - 0.13);
    onGround(Limb::RightHand, crawl.handAnchor(1, 0), 0.25);
    plan.entryPhase = (kEnd - kStrike) / gait.cycle;
    plan.exitPhase = kPhase;
    return makeClip(std::move(plan));
}

}  // namespace

void addCrawlPassages(std::vector<Clip>& clips) {
    clips.push_back(enterClip());
    clips.push_back(exitClip());
}

}  // namespace muster::generator
