// X6 (paper fig. 7c): an obstacle course for a hundred.
#include <algorithm>
#include <array>
#include <cmath>

#include "lab/reproduce/experiments/encounter_watch.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/experiments/experiment_trial.h"
#include "lab/reproduce/experiments/ground_watch.h"

namespace muster {
namespace {

constexpr MotionId kCourseCrawl = 3, kCourseSwim = 4, kCourseJump = 5, kClimb = 6;
constexpr std::array kTerrains{kClimb, kCourseJump, kCourseCrawl, kCourseSwim};
constexpr double kFinish = 23.5;  // Position along x behind the pool [m].
// Distance of starts from their places, large enough to matter for more than a moment [m].
constexpr double kCourseJitter = 1.0;
constexpr double kCourseHand = 0.4;      // Greatest shift of the hand [m].
constexpr double kCourseLongest = 60.0;  // Longest time after the last gesture [s].

class CourseExperiment final : public Experiment {
public:
    ExperimentText text() const override {
        return {
            "X6",
            "Obstacle course",
            "Figure 7c: a larger crowd goes through an obstacle course with narrow corridors, walls to climb "
            "or to jump over, a net to crawl under and a pool to swim through, and has no difficulty.",
            "A hundred climb a brick wall, go through two corridors of 3 m, take a wide formation at a "
            "checkpoint behind them, jump a hedge, crawl under a net, swim a pool and become a square again "
            "at a second checkpoint. Two fingers side by side carry the mesh all the way. Encounters with "
            "wall and hedge are counted from positions and polygons and compared with the events that tell "
            "of "
            "jumps and climbs, step by step. By the seed starts are moved by up to 1 m and the hand draws up "
            "to 0.4 m aside.",
            "x06-course",
            "The hand draws over the wall at the pace of climbing, 0.6 m/s, and quicker than the crowd "
            "elsewhere: the opposing force makes the mesh wait at net and pool. Drawn over the wall at 1.3 "
            "m/s the ranks crowd before it, and in 4 of 10 seeds one of the hundred was pushed off its edge "
            "again for more than half a second and then began to climb a second time: one climb for each "
            "encounter still, but not for each crossing. The paper gives no numbers here; the limits are "
            "ours."};
    }
    std::vector<Arm> arms() const override {
        return {{"course", "The course"}, {"course", "The course", "paper"}};
    }
    std::vector<FigureInfo> figures() const override {
        return {
            {"finished", "characters behind the pool", "", 0},
            {"time", "last one behind the pool", "s", 1},
            {"climbs", "climbs (events)", "", 0},
            {"wallMet", "encounters with the wall (positions)", "", 0},
            {"jumps", "jumps (events)", "", 0},
            {"hedgeMet", "encounters with the hedge (positions)", "", 0},
            {"mismatches", "encounters without exactly one event, and events without an encounter", "", 0},
            {"once", "characters that climb once and jump once", "", 0},
            {"allMotions", "characters seen climbing, jumping, crawling and swimming", "", 0},
            {"transitions", "characters seen going into and out of crawling and swimming", "", 0},
            {"changes", "changes of formation", "", 0},
            {"crawlSpeed", "mean speed under the net", "m/s", 3},
            {"swimSpeed", "mean speed in the pool", "m/s", 3},
            {"stuck", "stuck", "", 0},
            {"swaps", "changes of place per character and second", "1/s", 3}};
    }
    Result<RunSample> run(const RunRequest& request) const override;
    void judge(const Samples& samples, Judge& judge) const override;

private:
    static void judgePreset(const char* preset, const Samples& samples, Judge& judge);
};

/// The motions and phases that each character had.
class MotionsSeen {
public:
    void observe(const World& world) {
        const CharactersView characters = world.characters();
        seen_.resize(characters.size(), 0);
        into_.resize(characters.size(), 0);
        outOf_.resize(characters.size(), 0);
        for (std::size_t i = 0; i < characters.size(); ++i) {
            const std::uint32_t bit = 1u << characters.motion[i];
            seen_[i] |= bit;
            if (characters.phase[i] == MotionPhase::Entering) into_[i] |= bit;
            if (characters.phase[i] == MotionPhase::Leaving) outOf_[i] |= bit;
        }
        for (const Event& event : world.events())
            changes_ += event.kind == EventKind::FormationChange ? 1 : 0;
    }
    std::int32_t everyMotion() const {
        std::uint32_t all = 0;
        for (const MotionId motion : kTerrains) all |= 1u << motion;
        return static_cast<std::int32_t>(
            std::count_if(seen_.begin(), seen_.end(), [all](std::uint32_t s) { return (s & all) == all; }));
    }
    std::int32_t everyTransition() const {
        constexpr std::uint32_t kBoth = 1u << kCourseCrawl | 1u << kCourseSwim;
        std::int32_t count = 0;
        for (std::size_t i = 0; i < into_.size(); ++i)
            count += (into_[i] & outOf_[i] & kBoth) == kBoth ? 1 : 0;
        return count;
    }
    std::int32_t changes() const { return changes_; }

private:
    std::vector<std::uint32_t> seen_, into_, outOf_;
    std::int32_t changes_ = 0;
};

/// The moment of a picture: the mean position of the crowd reaches this point.
struct Moment {
    double x;
    const char* caption;
};
constexpr std::array<Moment, 6> kMoments{{{-19.5, "over the brick wall"},
                                          {-10.5, "through two corridors"},
                                          {0.5, "in the wide formation, over the hedge"},
                                          {10.0, "under the net"},
                                          {19.5, "through the pool"},
                                          {1e9, "all there, a square again"}}};

double middle(const World& world) {
    double sum = 0.0;
    for (const Vec2 p : world.characters().position) sum += p.x;
    return sum / static_cast<double>(world.characters().size());
}

/// All measurements of a run.
struct Watch {
    explicit Watch(const World& world) : ground(world), wall(world, kClimb), hedge(world, kCourseJump) {}

    void observe(const World& world) {
        ground.observe(world);
        wall.observe(world);
        hedge.observe(world);
        motions.observe(world);
        const std::span<const Vec2> positions = world.characters().position;
        finished = static_cast<std::int32_t>(
            std::count_if(positions.begin(), positions.end(), [](Vec2 p) { return p.x > kFinish; }));
        if (last < 0.0 && finished == static_cast<std::int32_t>(positions.size())) last = world.time();
    }
    void report(RunSample& sample) const {
        std::int32_t once = 0;
        for (std::size_t i = 0; i < wall.byCharacter().size(); ++i)
            once += wall.byCharacter()[i] == 1 && hedge.byCharacter()[i] == 1 ? 1 : 0;
        std::map<std::string, double>& figures = sample.figures;
        figures["finished"] = finished;
        figures["time"] = last < 0.0 ? std::nan("") : last;
        figures["climbs"] = wall.events();
        figures["wallMet"] = wall.encounters();
        figures["jumps"] = hedge.events();
        figures["hedgeMet"] = hedge.encounters();
        figures["mismatches"] = wall.mismatches() + hedge.mismatches();
        figures["once"] = once;
        figures["allMotions"] = motions.everyMotion();
        figures["transitions"] = motions.everyTransition();
        figures["changes"] = motions.changes();
        figures["crawlSpeed"] = ground.speed(kCourseCrawl);
        figures["swimSpeed"] = ground.speed(kCourseSwim);
    }

    GroundWatch ground;
    EncounterWatch wall;
    EncounterWatch hedge;
    MotionsSeen motions;
    std::int32_t finished = 0;
    double last = -1.0;
};

Result<RunSample> CourseExperiment::run(const RunRequest& request) const {
    auto trial = ExperimentTrial::open(request, {.scenario = "x06-course", .jitter = kCourseJitter});
    if (!trial.ok()) return trial.status();
    jitterHand(trial->commands(), request.seed, kCourseHand);
    if (Status s = trial->start(); !s.ok()) return s;
    Watch watch(trial->world());
    std::size_t next = 0;
    const auto shoot = [&](double x) {
        trial->picture().view = Box{{x - 11.0, -8.5}, {x + 11.0, 8.5}};
        trial->shoot(kMoments[next++].caption);
    };
    const auto observe = [&] {
        watch.observe(trial->world());
        const double x = middle(trial->world());
        if (next + 1 < kMoments.size() && x > kMoments[next].x) shoot(x);
    };
    trial->runUntilSettled(kCourseLongest, observe);
    while (next + 1 < kMoments.size()) shoot(middle(trial->world()));
    shoot(25.0);
    RunSample sample;
    trial->report(sample);
    watch.report(sample);
    return sample;
}

void CourseExperiment::judge(const Samples& samples, Judge& judge) const {
    for (const char* const preset : {"muster", "paper"}) judgePreset(preset, samples, judge);
}

void CourseExperiment::judgePreset(const char* preset, const Samples& samples, Judge& judge) {
    const auto all = [&](const char* criterion, const char* figure) {
        judge.require(criterion, preset, samples.values("course", preset, figure), Aggregate::Lowest,
                      Comparison::AtLeast, 100.0);
    };
    const auto none = [&](const char* criterion, const char* figure) {
        judge.require(criterion, preset, samples.values("course", preset, figure), Aggregate::Highest,
                      Comparison::AtMost, 0.0);
    };
    all("100 of 100 through the course in every seed", "finished");
    all("100 of 100 are seen climbing, jumping, crawling and swimming in every seed", "allMotions");
    all("100 of 100 climb the wall once and jump the hedge once in every seed", "once");
    none("each encounter by positions has exactly one climb or jump in the same step, in every seed",
         "mismatches");
    all("100 of 100 are seen going into and out of crawling and swimming in every seed", "transitions");
    judge.require("changes of formation on the way in every seed", preset,
                  samples.values("course", preset, "changes"), Aggregate::Lowest, Comparison::AtLeast, 1.0);
    none("nobody is stuck in any seed", "stuck");
}

}  // namespace

std::unique_ptr<Experiment> makeCourseExperiment() {
    return std::make_unique<CourseExperiment>();
}

}  // namespace muster
