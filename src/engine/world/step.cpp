// The step of a world: a table of all its stages, each of which reads what the stages before it have written.
#include <array>
#include <iterator>

#include "base/stopwatch.h"
#include "engine/systems/commands/apply_commands.h"
#include "engine/systems/mesh/mesh_stages.h"
#include "engine/world/world_engine.h"

namespace muster {
namespace {

/// A row of the table.
struct StageRow {
    StageInfo info;
    void (*run)(WorldEngine&);
    bool everyMove = false;  ///< True if it runs once in every move of the step; such rows stand together.
};

// docs/architecture.md shows this table; a test compares them.
constexpr StageRow kStages[] = {
    {{"commands", "queue of commands", "definitions, ground, parameters, controls, time of the environment",
      "Applies the commands of this step in the order of step, client and sequence."},
     [](WorldEngine& w) { applyCommands(w.state, *w.pool, w.events, w.rejections); }},
    {{"areas", "positions, chosen exits", "characters, groups, events",
      "Takes people out by exits, lets others in by sources, and ends groups that have left."},
     [](WorldEngine& w) { w.areas.run(w.state, *w.pool, w.events); }},
    {{"gatherings", "positions", "poses of groups without places",
      "Keeps the formation of a group without places where its members are."},
     [](WorldEngine& w) { OrderStage::followPeople(w.state, *w.pool); }},
    {{"orders", "queues, routes, ground, lags, other meshes, moving obstacles",
      "poses, formations, queues, when persons set out, events",
      "Begins the orders of groups, moves their meshes along their ways and ends what is done."},
     [](WorldEngine& w) { w.orders.run(w.state, *w.pool, w.events); }},
    {{"controls", "trajectories of fingers, mean lags", "control points",
      "Moves control points along what fingers have drawn; a large lag slows them (opposing force)."},
     [](WorldEngine& w) { advanceControls(w.state); }},
    {{"user mesh", "control points, rest meshes", "Vu",
      "Deforms every mesh as rigidly as possible to its control points."},
     [](WorldEngine& w) { deformUserMeshes(w.state); }},
    {{"final mesh", "Vu, potential field, obstacles", "Vf", "Displaces every mesh by the environment."},
     [](WorldEngine& w) { deformFinalMeshes(w.state); }},
    {{"routes", "ground, radii", "regions and routes",
      "Brings the routes of every class of ground in use up to date."},
     [](WorldEngine& w) { refreshRoutes(w.state); }},
    {{"targets", "Vf", "targets of places", "Reads from the final meshes where places are to be."},
     [](WorldEngine& w) { w.places.readTargets(w.state); }},
    {{"body room", "radii, who holds which place", "targets of places",
      "Moves targets apart where large bodies hold their places."},
     [](WorldEngine& w) { w.places.makeRoom(w.state); }},
    {{"rest", "targets of places, trajectories of fingers", "steps of rest of every group",
      "Counts for how many steps the targets of each group have stood."},
     [](WorldEngine& w) { w.places.watchRest(w.state); }},
    {{"regions", "positions, routes", "region of every group",
      "Finds the region in which most of a group stands."},
     [](WorldEngine& w) { w.places.findRegions(w.state); }},
    {{"places", "targets, routes, regions", "places",
      "Moves places towards their targets over ground that can be reached."},
     [](WorldEngine& w) { w.places.advance(w.state, *w.pool); }},
    {{"density", "positions, velocities", "density and average velocity",
      "Splats the crowd onto the grid (Treuille et al.)."},
     [](WorldEngine& w) { w.cost.splatDensity(w.state); }},
    {{"unit cost", "density, ground, moving obstacles", "unit cost",
      "Updates the unit cost while something has asked for it lately; others ask for it when they need it."},
     [](WorldEngine& w) { w.cost.updateUnitCost(); }},
    {{"background", "plans", "plans", "Waits for the work on plans that went on since the last step."},
     [](WorldEngine& w) { w.plans.endBackgroundWork(*w.pool); }},
    {{"no places", "continuum", "places of characters, plans",
      "Takes the places of members of groups that go without."},
     [](WorldEngine& w) { w.plans.takePlaces(w.state); }},
    {{"passages", "ground, walks, positions, places", "passages, chosen ways",
      "Forgets passages of changed ground and the ways of those who have come through."},
     [](WorldEngine& w) { w.ways.leavePassages(w.state, w.cost, *w.pool); }},
    {{"ways", "passages, walks, places, positions", "passages, chosen ways",
      "Looks for passages where many are behind something, and chooses who goes through which and when."},
     [](WorldEngine& w) { w.ways.chooseWays(w.state, *w.pool); }},
    {{"planned ways", "chosen ways, walks, targets", "costs by way",
      "Prepares the costs of chosen ways for plans and guidance."},
     [](WorldEngine& w) { w.ways.prepareWays(w.state, *w.pool); }},
    {{"members", "positions, places of characters", "arrays by group",
      "Gathers the members of every group for plans and guidance."},
     [](WorldEngine& w) { w.members.gather(w.state); }},
    {{"plans", "members, places, costs, costs by way, own routes", "places of characters, events",
      "Assigns places to characters; groups take turns where plans take several steps."},
     [](WorldEngine& w) { w.plans.run(w.state, w.cost, w.ways, w.members, *w.pool, w.events); }},
    {{"bodies", "bodies, conduct", "radius, speed, mass and firmness", "Resolves what each character is."},
     [](WorldEngine& w) { w.steering.resolveBodies(w.state); }},
    {{"continuum", "unit cost, positions, areas", "direction, cost and goal of characters without places",
      "Chooses exits, and leads characters without places down one cost field per target, exit or area."},
     [](WorldEngine& w) { w.steering.descendFields(w.state, w.cost, *w.pool); }},
    {{"guidance", "members, places, plans, costs", "direction and cost of characters",
      "Evaluates the direction and the cost of each character's path to its place."},
     [](WorldEngine& w) { w.steering.guide(w.state, w.cost, w.members, *w.pool); }},
    {{"passage guidance", "chosen ways, passages", "direction and cost of characters",
      "Directs characters to the passage that they have to go through."},
     [](WorldEngine& w) { w.steering.guideToPassages(w.state, w.ways); }},
    {{"going round", "directions, firm bodies", "direction of characters",
      "Turns directions round clusters of others that hold their ground."},
     [](WorldEngine& w) { w.steering.goRound(w.state); }},
    {{"own routes", "walks, exact ground, firm bodies", "direction and cost of characters, own routes",
      "Gives a character that has camped on one spot, or is barred by others that hold their ground, a route "
      "of its "
      "own by the exact ground."},
     [](WorldEngine& w) { w.steering.followOwnRoutes(w.state); }},
    {{"cohesion", "costs, conduct", "pace of characters", "Slows those ahead in groups that keep together."},
     [](WorldEngine& w) { w.steering.setPaces(w.state); }},
    {{"moving obstacles", "paths", "time of the environment",
      "Moves obstacles on within a step that is divided."},
     [](WorldEngine& w) {
         if (w.move > 0) w.state.environment.setTime(w.state.time() + w.move * w.moveTime());
     },
     true},
    {{"shared places", "places of characters, weights", "room around places",
      "Finds how much room those need who share a place."},
     [](WorldEngine& w) { w.steering.findSharedPlaces(w.state); },
     true},
    {{"steering", "directions, places, neighbours, obstacles, room around places, pace",
      "next velocity, heading and position",
      "Steers towards places: headway, right of way, giving way to moving obstacles."},
     [](WorldEngine& w) { w.steering.steer(w.state, w.moveTime(), *w.pool); },
     true},
    {{"contacts", "next positions, obstacles", "positions, velocities, headings",
      "Moves characters, so that none enters another one or an obstacle."},
     [](WorldEngine& w) { w.contactReport = w.contacts.run(w.state, w.steering, w.moveTime(), *w.pool); },
     true},
    {{"patches", "positions, patches", "motions, phases, events",
      "Changes the motion of who enters or leaves a patch."},
     [](WorldEngine& w) {
         w.patches.run(w.state);
         raiseMotionEvents(w.state, w.patches.events(), w.events);
     }},
    {{"items", "positions", "collected items, events", "Collects the items that a character has come to."},
     [](WorldEngine& w) { collectItems(w.state, w.events); }},
    {{"checkpoints", "positions, poses", "formations, events",
      "Changes the formations of groups that pass a checkpoint."},
     [](WorldEngine& w) { meetCheckpoints(w.state, w.events); }},
    {{"lags", "positions, targets", "mean lag of every group",
      "Measures how far characters are from the targets of their places."},
     [](WorldEngine& w) { measureLags(w.state); }},
    {{"walks", "positions, places, room around places", "progress of walks",
      "Watches how each character gets on with its walk."},
     [](WorldEngine& w) { w.happenings.watchWalks(w.state); }},
    {{"arrivals", "progress of walks, places, regions", "progress of orders, events",
      "Raises which orders have arrived, and who has no way."},
     [](WorldEngine& w) {
         w.happenings.watchOrders(w.state, w.events);
         GoalStage::raiseWays(w.state, w.events);
     }},
    {{"standstill", "progress of walks, neighbours", "events", "Raises who is stuck, twice a second."},
     [](WorldEngine& w) { w.happenings.watchStandstill(w.state, w.events); }},
    {{"gates", "regions near moving obstacles", "progress of orders, events",
      "Raises whose way moving obstacles cut off, and when it is free again."},
     [](WorldEngine& w) { w.happenings.watchGates(w.state, w.events); }},
};
static_assert(std::size(kStages) == kStageCount);

constexpr auto kInfos = [] {
    std::array<StageInfo, kStageCount> infos{};
    for (std::size_t i = 0; i < kStageCount; ++i) infos[i] = kStages[i].info;
    return infos;
}();

// The clock of a browser takes a hundredth of a small world's step: there the stages of every eighth step are
// timed.
#ifdef __EMSCRIPTEN__
constexpr std::uint64_t kTimedEvery = 8;
#else
constexpr std::uint64_t kTimedEvery = 1;
#endif

/// Runs rows of the table, and adds to the times of each.
class StageRunner {
public:
    StageRunner(WorldEngine& engine, bool timed) : engine_(engine), timed_(timed) {
        if (timed) engine.times.milliseconds.fill(0.0);
    }
    void run(std::size_t row) {
        kStages[row].run(engine_);
        if (!timed_) return;
        const double ended = watch_.milliseconds();
        engine_.times.milliseconds[row] += ended - began_;
        began_ = ended;
    }
    void end() { engine_.times.total = watch_.milliseconds(); }

private:
    WorldEngine& engine_;
    Stopwatch watch_;
    double began_ = 0.0;
    bool timed_;
};

}  // namespace

const char* stageName(Stage stage) {
    const auto index = static_cast<std::size_t>(stage);
    return index < kStageCount ? kStages[index].info.name.data() : "";
}

std::span<const StageInfo, kStageCount> stepStages() {
    return kInfos;
}

void WorldEngine::step() {
    StageRunner runner(*this, state.stepCount % kTimedEvery == 0);
    const std::int32_t moves = movesOf(state.parameters.stepTime);
    for (std::size_t row = 0; row < kStageCount;) {
        std::size_t end = row + 1;
        while (kStages[row].everyMove && end < kStageCount && kStages[end].everyMove) ++end;
        for (move = 0; move < (kStages[row].everyMove ? moves : 1); ++move)
            for (std::size_t k = row; k < end; ++k) runner.run(k);
        row = end;
    }
    ++state.stepCount;
    runner.end();
}

}  // namespace muster
