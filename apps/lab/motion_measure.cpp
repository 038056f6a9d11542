// muster motion --measure
#include "motion_parts.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "lab_commands.h"
#include "muster/scenario.h"
#include "people/clips/clip_files.h"
#include "people/motion/body_overlap.h"
#include "people/motion/clips_for.h"
#include "people/motion/motion_report.h"
#include "report.h"

namespace muster {
namespace {

constexpr double kLongestAfterTouch = 60.0;  // Longest simulated time after the last touch [s].

/// The measures of one scenario.
struct Measured {
    std::string scenario;
    std::int32_t characters = 0;
    double seconds = 0.0;
    MotionFigures figures;
    std::vector<MotionOverlap> overlaps;
};

Result<World> worldFor(WorldDef& def, const std::string& path, double& lastTouch) {
    const auto touches = loadScenarioGestures(path, def);
    if (!touches.ok()) return touches.status();
    auto world = World::create(def);
    if (!world.ok()) return world.status().within(path);
    for (const Command& command : *touches) {
        if (Status s = world->submit(command); !s.ok()) return s.within(path);
        lastTouch = std::max(lastTouch, command.step * def.parameters.stepTime);
    }
    return world;
}

Result<Measured> measure(const std::string& path, const MeasureOptions& options) {
    auto def = loadScenario(path);
    if (!def.ok()) return def.status();
    if (options.count > 0 && !def->groups.empty()) {
        def->groups[0].count = options.count;
        def->groups[0].starts.clear();
    }
    const auto clips = options.clips.empty()
                           ? clipsFor(def->clips, std::filesystem::path(path).parent_path().string())
                           : loadClips(options.clips);
    if (!clips.ok()) return clips.status().within(path);
    double lastTouch = 0.0;
    auto world = worldFor(*def, path, lastTouch);
    if (!world.ok()) return world.status();
    RunMetrics metrics(*world);
    CrowdMotion motion(*clips);
    MotionReport report;
    BodyOverlapReport overlaps;
    Progress progress("measuring " + path);
    const double end = options.seconds > 0.0 ? options.seconds : lastTouch + kLongestAfterTouch;
    while (world->time() < end - 1e-9) {
        world->step();
        metrics.observe(*world);
        motion.update(*world);
        report.observe(*world, motion);
        overlaps.observe(*world, motion);
        progress.show(world->time() / end);
        const bool due = options.seconds <= 0.0 && world->time() > lastTouch + 1.0 &&
                         world->stepCount() % 30 == 0;
        if (due && metrics.settled(*world)) break;
    }
    return Measured{path, static_cast<std::int32_t>(world->characters().size()), world->time(),
                    report.figures(), overlaps.motions()};
}

Json jsonOf(const MotionOverlap& o) {
    return {{"motion", o.motion},
            {"deepest_cm", 100.0 * o.deepest},
            {"with", o.otherMotion},
            {"time", o.time},
            {"characters", std::to_string(o.first) + ", " + std::to_string(o.second)},
            {"pair_steps", o.pairSteps},
            {"deeper_than_10_cm", o.deepSteps}};
}

Json jsonOf(const Measured& m) {
    const MotionFigures& f = m.figures;
    auto overlaps = Json::array();
    for (const MotionOverlap& o : m.overlaps) overlaps.push(jsonOf(o));
    return {{"scenario", m.scenario},
            {"characters", m.characters},
            {"seconds", m.seconds},
            {"contacts", f.contacts},
            {"slide_median_cm", 100.0 * f.slideMedian},
            {"slide_p95_cm", 100.0 * f.slide95},
            {"slide_max_cm", 100.0 * f.slideMax},
            {"low_soles_over_0.5_mps", f.lowFast},
            {"low_soles_p95_mps", f.lowSpeed95},
            {"knee_max_radps", f.kneeMax},
            {"knee_p999_radps", f.knee999},
            {"penetration_max_cm", 100.0 * f.penetration},
            {"penetration_p999_cm", 100.0 * f.penetration999},
            {"acceleration_max_mps2", f.accelerationMax},
            {"acceleration_p999_mps2", f.acceleration999},
            {"rate_least", f.rateLeast},
            {"rate_most", f.rateMost},
            {"switches", f.switches},
            {"single_steps_asked", f.singleSteps},
            {"single_steps_played", f.actions},
            {"overlaps", overlaps}};
}

void printTable(const std::vector<Measured>& all) {
    std::printf("%-34s %5s %8s %17s %9s %15s %15s %11s %9s\n", "scenario", "count", "contacts",
                "slide 50/95/max cm", "low fast", "knee p999/max", "deep p999/max cm", "rates", "steps");
    for (const Measured& m : all) {
        const MotionFigures& f = m.figures;
        std::printf(
            "%-34s %5d %8llu %5.2f %5.2f %6.2f %8.2f%% %7.1f %7.1f %7.2f %8.2f %5.2f %5.2f %4llu/%llu\n",
            m.scenario.c_str(), m.characters, static_cast<unsigned long long>(f.contacts),
            100.0 * f.slideMedian, 100.0 * f.slide95, 100.0 * f.slideMax, 100.0 * f.lowFast, f.knee999,
            f.kneeMax, 100.0 * f.penetration999, 100.0 * f.penetration, f.rateLeast, f.rateMost,
            static_cast<unsigned long long>(f.actions), static_cast<unsigned long long>(f.singleSteps));
    }
    std::printf("\nDeepest overlap of two bodies at torso and head, by motion:\n");
    for (const Measured& m : all) {
        std::printf("%s\n", m.scenario.c_str());
        for (const MotionOverlap& o : m.overlaps)
            std::printf("  %-8s %6.1f cm with %-8s at %6.2f s (%u, %u)  deeper than 10 cm: %llu of %llu\n",
                        o.motion.c_str(), 100.0 * o.deepest, o.otherMotion.c_str(), o.time, o.first, o.second,
                        static_cast<unsigned long long>(o.deepSteps),
                        static_cast<unsigned long long>(o.pairSteps));
    }
}

}  // namespace

int measureMotion(const MeasureOptions& options) {
    std::vector<Measured> all;
    for (const std::string& path : options.scenarios) {
        auto measured = measure(path, options);
        if (!measured.ok()) return reportFailure(measured.status());
        all.push_back(std::move(measured).value());
    }
    if (options.json) {
        auto list = Json::array();
        for (const Measured& m : all) list.push(jsonOf(m));
        printJsonValue(list);
    } else {
        printTable(all);
    }
    return kExitOk;
}

}  // namespace muster
