// A crowd without a simulation, of any number: everybody runs rounds of their own, at speeds that rise and
// fall.
#pragma once

#include <vector>

#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "muster/motion.h"
#include "people/motion/crowd_view.h"

namespace muster::testing {

/// Characters on circles of 3 to 8 m.
class Parade {
public:
    explicit Parade(std::uint32_t count) : environment_(Environment::create({}).value()) {
        Characters& c = characters_;
        angle_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            c.id.push_back(i + 1);
            angle_[i] = 0.37 * i;
        }
        c.group.assign(count, 0);
        c.position.assign(count, {});
        c.velocity.assign(count, {});
        c.heading.assign(count, {1.0, 0.0});
        c.place.assign(count, -1);
        c.direction.assign(count, {});
        c.cost.assign(count, 0.0);
        c.motion.assign(count, 0);
        c.phase.assign(count, MotionPhase::Steady);
        c.motionTime.assign(count, 0.0);
        c.patch.assign(count, 0);
        c.lastSingle.assign(count, 0);
        step();
    }

    /// A sixtieth of a second.
    void step() {
        constexpr double dt = 1.0 / 60.0;
        time_ += dt;
        for (std::size_t i = 0; i < angle_.size(); ++i) {
            const double radius = 3.0 + static_cast<double>(i % 6), phase = 0.7 * static_cast<double>(i);
            const double speed = std::max(0.0, 1.2 + 1.3 * sine(0.5 * time_ + phase));
            angle_[i] += speed / radius * dt;
            const double c = cosine(angle_[i]), s = sine(angle_[i]);
            characters_.position[i] = {radius * c, radius * s};
            characters_.heading[i] = {-s, c};
            characters_.velocity[i] = characters_.heading[i] * speed;
            characters_.direction[i] = speed > 0.0 ? characters_.heading[i] : Vec2{};
        }
    }

    /// As motion reads it.
    CrowdView view() const { return {.characters = &characters_, .environment = &environment_}; }
    const Characters& characters() const { return characters_; }  ///< Of now.

private:
    Characters characters_;
    Environment environment_;
    std::vector<double> angle_;
    double time_ = 0.0;
};

}  // namespace muster::testing
