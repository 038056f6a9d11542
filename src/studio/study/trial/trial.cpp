#include "studio/study/trial/trial.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kStandingSpeed = 0.2;    // Who is slower stands [m/s].
constexpr std::size_t kMovingShare = 10;  // The crowd is idle where fewer than one in so many move.

bool isIdle(const World& world) {
    const CharactersView view = world.characters();
    const auto moves = [](Vec2 v) { return v.x * v.x + v.y * v.y > kStandingSpeed * kStandingSpeed; };
    const auto moving = std::count_if(view.velocity.begin(), view.velocity.end(), moves);
    return static_cast<std::size_t>(moving) * kMovingShare < view.size();
}

}  // namespace

Trial::Trial(TrialDef def, const SchemeDef& scheme, World world)
    : def_(std::move(def)), world_(std::move(world)), driver_(scheme), view_(studyView()) {
    result_.items = static_cast<std::int32_t>(world_.items().size());
}

Result<Trial> Trial::create(const TrialDef& def) {
    const auto environment = studyEnvironment(def.environment);
    if (!environment.ok()) return environment.status();
    const auto scheme = namedScheme(def.scheme);
    if (!scheme.ok()) return scheme.status();
    const auto worldDef = studyWorld(environment.value(), def.crowd, def.seed, def.mirrored);
    if (!worldDef.ok()) return worldDef.status();
    auto world = World::create(worldDef.value(), 1);
    if (!world.ok()) return world.status();
    Trial trial(def, scheme.value().def, std::move(world).value());
    if (const Status status = trial.input(trial.view_); !status.ok()) return status;
    return trial;
}

Status Trial::input(const InputEvent& event) {
    if (Status status = driver_.input(event, world_); !status.ok()) return status;
    inputs_.push_back({world_.stepCount(), event});
    const auto* pointer = std::get_if<PointerEvent>(&event);
    const bool begins = pointer != nullptr && pointer->phase == PointerPhase::Down;
    if (begins || std::holds_alternative<KeyEvent>(event)) ++result_.gestures;
    return {};
}

void Trial::step() {
    driver_.take(world_, stepCommands_);
    for (const Command& command : stepCommands_) {
        // What the world refuses changes nothing; a scheme's commands are well formed.
        if (!world_.submit(command).ok()) continue;
        commands_.push_back(command);
        if (!(touchOf(command.body, TouchPhase::Move) != nullptr)) ++result_.commands;
    }
    world_.step();
    if (isIdle(world_)) result_.idleSeconds += world_.parameters().stepTime;
    const std::span<const std::uint8_t> collected = world_.collected();
    result_.collected = static_cast<std::int32_t>(std::count(collected.begin(), collected.end(), 1));
    result_.done = result_.collected == result_.items;
}

bool Trial::over() const {
    return result_.done || world_.time() >= studyRules().limit;
}

TrialResult Trial::result() const {
    TrialResult result = result_;
    result.steps = world_.stepCount();
    result.seconds = world_.time();
    result.hash = world_.hash();
    return result;
}

Result<Trial> replayTrial(const TrialDef& def, std::span<const StampedInput> inputs) {
    auto made = Trial::create(def);
    if (!made.ok()) return made.status();
    Trial trial = std::move(made).value();
    std::size_t next = 0;
    while (!trial.over()) {
        for (; next < inputs.size() && inputs[next].step <= trial.world().stepCount(); ++next) {
            // A new trial begins with its view.
            if (next == 0 && std::holds_alternative<GroundView>(inputs[0].event) &&
                std::get<GroundView>(inputs[0].event) == trial.view())
                continue;
            if (const Status status = trial.input(inputs[next].event); !status.ok()) return status;
        }
        trial.step();
    }
    return trial;
}

}  // namespace muster
