#include "lab/reproduce/experiments/experiment_trial.h"

#include <algorithm>

#include "base/random.h"

namespace muster {
namespace {

constexpr double kShiftTime = 2.0;  // Time over which the shift grows to its full length [s].

}  // namespace

void jitterHand(std::vector<Command>& commands, std::uint64_t seed, double amount) {
    Random random(seed);
    const double x = random.uniform(-amount, amount);
    const double y = random.uniform(-amount, amount);
    const Vec2 shift{x, y};
    double begins = -1.0;
    for (Command& command : commands) {
        if (const auto* down = touchOf(command.body, TouchPhase::Down); down != nullptr && begins < 0.0)
            begins = down->time;
        auto* move = touchOf(command.body, TouchPhase::Move);
        if (move == nullptr || begins < 0.0) continue;
        move->position += shift * std::clamp((move->time - begins) / kShiftTime, 0.0, 1.0);
    }
}

}  // namespace muster
