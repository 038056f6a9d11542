#include "lab/study/models/model_trial.h"

#include <vector>

#include "studio/gestures/scheme_driver.h"
#include "studio/study/trial/trial_environment.h"

namespace muster {
namespace {

constexpr double kTimedLength = 20.0;   // Length of the walk that is timed [m].
constexpr double kSentDistance = 25.0;  // Distance of the point to which the crowd is sent [m].
constexpr double kLongestWalk = 60.0;   // Longest time of the walk [s].

Vec2 middleOf(const World& world) {
    Vec2 sum;
    for (const Vec2 p : world.characters().position) sum += p;
    return sum / static_cast<double>(world.characters().size());
}

// One order, given within one step: a stroke, or a box and a click.
class OneOrder {
public:
    OneOrder(const SchemeDef& def, World& world)
        : def_(def), world_(world), driver_(def), view_(studyView()) {
        (void)driver_.input(view_, world_);
    }

    void give(Vec2 from, Vec2 to) {
        const bool draws = def_.kind == SchemeKind::Touch || def_.kind == SchemeKind::MouseMesh;
        if (draws) return drag(from, to, PointerButton::Left);
        const bool paper = def_.kind == SchemeKind::MousePaper;
        drag({-19.5, 11.0}, {from.x + 10.0, -11.0}, paper ? PointerButton::Right : PointerButton::Left);
        const PointerButton button = paper ? PointerButton::Left : PointerButton::Right;
        event(PointerPhase::Down, to, button);
        event(PointerPhase::Up, to, button);
    }
    void step() {
        driver_.take(world_, commands_);
        for (const Command& command : commands_) (void)world_.submit(command);
        world_.step();
    }

private:
    void drag(Vec2 from, Vec2 to, PointerButton button) {
        event(PointerPhase::Down, from, button);
        for (int i = 1; i <= 50; ++i) event(PointerPhase::Move, lerp(from, to, i / 50.0), button);
        event(PointerPhase::Up, to, button);
    }
    void event(PointerPhase phase, Vec2 ground, PointerButton button) {
        PointerEvent event;
        event.phase = phase;
        event.device = def_.kind == SchemeKind::Touch ? PointerDevice::Touch : PointerDevice::Mouse;
        event.button = button;
        event.screen = view_.screenOf(ground).value_or(Vec2{});
        event.time = world_.time();
        (void)driver_.input(event, world_);
    }

    SchemeDef def_;
    World& world_;
    SchemeDriver driver_;
    GroundView view_;
    std::vector<Command> commands_;
};

}  // namespace

Result<double> equalWalkSeconds(const std::string& scheme, std::int32_t crowd) {
    const auto named = namedScheme(scheme);
    if (!named.ok()) return named.status();
    StudyEnvironment open = studyEnvironments()[0];
    open.blocks.clear();
    auto def = studyWorld(open, crowd, 1, false);
    if (!def.ok()) return def.status();
    def.value().items.clear();
    auto made = World::create(def.value(), 1);
    if (!made.ok()) return made.status();
    World world = std::move(made).value();
    OneOrder order(named.value().def, world);
    const Vec2 start = middleOf(world);
    order.give(start, start + Vec2{kSentDistance, 0.0});
    while (world.time() < kLongestWalk) {
        order.step();
        if (middleOf(world).x >= start.x + kTimedLength) return world.time();
    }
    return Status{StatusCode::NotFound, "the crowd did not walk 20 m by '" + scheme + "' within a minute"};
}

}  // namespace muster
