#include <algorithm>

#include "people/generator/crawl.h"
#include "people/generator/key_poses.h"
#include "people/generator/transitions.h"

namespace muster::generator {
namespace {

constexpr int kCrawlFrames = 60;
constexpr double kCrawlEnd = kCrawlFrames / kFrameRate;  // Duration of the clip [s].
constexpr double kContactTime = CrawlTrack::kContact * CrawlTrack::kCycle;

/// Adds the contact of a knee or hand, shifted by the distance that the clip has travelled.
void addStay(ClipDef& plan, Limb limb, Vec3 anchor, double shift, double begin, double end) {
    anchor.x += static_cast<float>(shift);
    plan.contacts.push_back({limb, begin, std::min(kCrawlEnd, end), anchor});
}

/// From running to crawling: the right foot lunges, then the left knee lands first.
namespace down {

constexpr double kKnee = 0.56;      // Time at which the left knee lands, in phase with the crawl [s].
constexpr double kLow = 0.60;       // Time from which on the body crawls [s].
constexpr double kRightLow = 0.92;  // Time from which on the right leg crawls [s].
constexpr double kLunge = 0.30;     // Time at which the right foot lands [s].
constexpr double kLift = 0.66;      // Time at which the right foot lifts off [s].

Course courseOf(const GaitTrack& jog, const CrawlTrack& crawl) {
    Course course;
    course.travel = straight(changingSpeed(jog.gait().speed, CrawlTrack::kSpeed, 0.0, kLow));
    course.body = [=](double time) {
        ChannelValues body = blend(jog.body(time), crawl.figure(time).body, rise(0.0, kLow, time));
        body[Channel::HeadPitch] -= degrees(10) * hump(0.1, 0.8, time);
        return body;
    };
    return course;
}

Step pushStep(const GaitTrack& jog) {
    Step step = jog.step(0, 0, jog.course());
    step.end = 0.34;
    step.swing = {};
    return step;
}

Step lungeStep(const GaitTrack& jog, const Course& course) {
    Step step = jog.step(1, 0, jog.course());
    step.begin = kLunge;
    step.end = kLift;
    step.anchor.x = static_cast<float>(course.travel(kLunge).x) + 0.13f;
    step.anchor.y = -0.11f;
    step.push = degrees(60);
    step.rise = 0.3;
    step.swing = {};
    return step;
}

void addContactsTo(ClipDef& plan, const Step& push, const Step& lunge, const Course& course,
                   const CrawlTrack& crawl) {
    addContacts(plan.contacts, 0, {push}, kCrawlEnd, false);
    addContacts(plan.contacts, 1, {lunge}, kCrawlEnd, false);
    const double shift = course.travel(kCrawlEnd).x - crawl.travel(kCrawlEnd).x;
    addStay(plan, Limb::LeftKnee, crawl.kneeAnchor(0, 0), shift, kLow,
            crawl.kneeLanding(0, 0) + kContactTime);
    addStay(plan, Limb::RightHand, crawl.handAnchor(1, 0), shift, kLow,
            crawl.handLanding(1, 0) + kContactTime);
    addStay(plan, Limb::LeftHand, crawl.handAnchor(0, -1), shift, kLow,
            crawl.handLanding(0, -1) + kContactTime);
}

Clip clip() {
    const GaitTrack jog(gaitOf(GaitKind::Jog));
    const CrawlTrack crawl(kKnee);
    const auto crawling = [&](double time) { return crawl.figure(time); };
    const Course course = courseOf(jog, crawl);
    const Step push = pushStep(jog), lunge = lungeStep(jog, course),
               last = stepOutside(push, kCrawlEnd + 0.5);
    const LegTrack left(0, {jog.step(0, -1, jog.course()), push, last}, course, {},
                        joinOf(crawling, 0, kLow));
    const LegTrack right(1, {jog.step(1, -1, jog.course()), lunge, last}, course, jog.leg(1).join(0.0),
                         joinOf(crawling, 1, kRightLow));
    ClipDef plan;
    plan.name = "crawl-enter";
    plan.motion = "crawl";
    plan.frames = kCrawlFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        Figure figure = crawl.figure(time);
        figure.body = course.body(time);
        for (Reach& reach : figure.reach) {
            reach.weight = rise(0.16, kLow - 0.02, time);
            reach.follow = 1.0 - rise(0.20, 0.44, time);
            reach.wrist.z += static_cast<float>(0.10 * (1.0 - rise(0.36, kLow - 0.02, time)));
        }
        if (time < kLow) figure.legs[0] = left.at(time);
        if (time < kRightLow) figure.legs[1] = right.at(time);
        return figure;
    };
    addContactsTo(plan, push, lunge, course, crawl);
    plan.entryPhase = (kCrawlEnd - kKnee) / CrawlTrack::kCycle;
    return makeClip(std::move(plan));
}

}  // namespace down

/// From crawling to running: the right foot steps forward, the left leg swings through.
namespace up {

constexpr double kPhase = 0.08;    // Phase of the crawl at the beginning of the clip.
constexpr double kRightUp = 0.04;  // Time at which the right leg leaves the crawl [s].
constexpr double kFoot = 0.36;     // Time at which the right foot stands [s].
constexpr double kUp = 0.38;       // Time at which the left leg and the body leave the crawl [s].
constexpr double kStrike = 0.80;   // Time at which the left foot lands [s].

Course courseOf(const GaitTrack& jog, const CrawlTrack& crawl) {
    Course course;
    course.travel = straight(changingSpeed(CrawlTrack::kSpeed, jog.gait().speed, 0.25, kCrawlEnd));
    course.body = [=](double time) {
        ChannelValues body = blend(crawl.figure(time).body, jog.body(time),
                                   rise(kUp - 0.02, kCrawlEnd, time));
        body[Channel::ChestPitch] += degrees(6) * hump(kUp, kCrawlEnd, time);
        return body;
    };
    return course;
}

Step footStep(const GaitTrack& jog, const Course& course) {
    Step step = jog.step(1, -1, course);
    step.begin = kFoot;
    step.end = 0.73;
    step.anchor.x = static_cast<float>(course.travel(kFoot).x) - 0.02f;
    step.anchor.y = -0.10f;
    step.push = degrees(58);
    step.rise = 0.3;
    return step;
}

Clip clip() {
    const GaitTrack jog(gaitOf(GaitKind::Jog), kStrike);
    const CrawlTrack crawl(-kPhase * CrawlTrack::kCycle);
    const auto crawling = [&](double time) { return crawl.figure(time); };
    const Course course = courseOf(jog, crawl);
    const Step foot = footStep(jog, course), strike = jog.step(0, 0, course),
               first = stepOutside(strike, -1.0);
    const LegTrack left(0, {first, strike, jog.step(0, 1, course)}, course, joinOf(crawling, 0, kUp));
    const LegTrack right(1, {first, foot, jog.step(1, 0, course)}, course, joinOf(crawling, 1, kRightUp),
                         jog.leg(1).join(kCrawlEnd));
    ClipDef plan;
    plan.name = "crawl-exit";
    plan.motion = "crawl";
    plan.frames = kCrawlFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        Figure figure = crawl.figure(time);
        figure.body = course.body(time);
        for (Reach& reach : figure.reach) {
            reach.weight = 1.0 - rise(0.40, 0.80, time);
            reach.follow = rise(0.44, 0.66, time);
            reach.wrist.z += static_cast<float>(0.12 * rise(0.38, 0.60, time));
        }
        if (time >= kUp) figure.legs[0] = left.at(time);
        if (time >= kRightUp) figure.legs[1] = right.at(time);
        return figure;
    };
    addContacts(plan.contacts, 0, {strike}, kCrawlEnd, false);
    addContacts(plan.contacts, 1, {foot}, kCrawlEnd, false);
    const double shift = -crawl.travel(0.0).x;
    addStay(plan, Limb::LeftKnee, crawl.kneeAnchor(0, 0), shift, 0.0, 0.25);
    addStay(plan, Limb::RightHand, crawl.handAnchor(1, 0), shift, 0.0, 0.25);
    plan.entryPhase = (kCrawlEnd - kStrike) / jog.gait().cycle;
    plan.exitPhase = kPhase;
    return makeClip(std::move(plan));
}

}  // namespace up
}  // namespace

void addCrawlTransitions(std::vector<Clip>& clips) {
    clips.push_back(down::clip());
    clips.push_back(up::clip());
}

}  // namespace muster::generator
