#include "engine/orders/march_plans.h"

#include <algorithm>
#include <utility>

namespace muster {

// Takes the kept plan with the same input as the present one, or begins a new one.
void MarchPlans::start(const StreamDef& def, std::span<const HeldSpot> held, GroundVersion ground,
                       const Grid& cells) {
    wanted_.offsets.assign(def.offsets.begin(), def.offsets.end());
    wanted_.starts.assign(def.starts.begin(), def.starts.end());
    wanted_.ends.assign(def.ends.begin(), def.ends.end());
    wanted_.way.assign(def.way.begin(), def.way.end());
    wanted_.held.assign(held.begin(), held.end());
    wanted_.spacing = def.spacing;
    wanted_.radius = def.radius;
    wanted_.closest = def.closest;
    wanted_.drawn = def.drawn;
    wanted_.poses.assign(def.poses.begin(), def.poses.end());
    wanted_.ground = ground;
    begun_ = true;
    spent_ = 0;
    for (std::size_t k = 0; k < kept_.size(); ++k)
        if (kept_[k].ways.places() > 0 && kept_[k].input == wanted_) {
            now_ = k;
            return;
        }
    if (rewinds_) now_ = 1 - now_;
    Kept& plan = kept_[now_];
    std::swap(plan.input, wanted_);
    plan.turns.clear();
    plan.asked.reset(cells);
    plan.ways.start(plan.input.def());
}

StreamStatus MarchPlans::Kept::advance(StreamGround room, std::int64_t operations) {
    const auto ask = [&](Vec2 p) {
        asked.add(p);
        return room(p);
    };
    const auto speed = [&](Vec2 p) {
        asked.add(p);
        return room.speed(p);
    };
    return ways.advance(room.uneven() ? StreamGround(ask, speed) : StreamGround(ask), operations);
}

void MarchPlans::resume(const StreamDef& def, std::span<const HeldSpot> held, GroundVersion ground,
                        const Grid& cells, StreamGround room, std::int64_t spent) {
    start(def, held, ground, cells);
    spent_ = spent;
    Kept& plan = kept_[now_];
    if (plan.ways.operations() < spent) plan.advance(room, spent - plan.ways.operations());
}

StreamStatus MarchPlans::advance(StreamGround room, std::int64_t operations) {
    Kept& plan = kept_[now_];
    if (spent_ < plan.ways.operations()) {
        const auto known = std::find_if(plan.turns.begin(), plan.turns.end(), [&](const Turn& turn) {
            return turn.from == spent_ && turn.operations == operations;
        });
        if (known != plan.turns.end()) {
            spent_ = known->to;
            return spent_ < plan.ways.operations() ? StreamStatus::Planning : plan.ways.status();
        }
        // The budget differs from that of the earlier run.
        std::erase_if(plan.turns, [&](const Turn& turn) { return turn.from >= spent_; });
        plan.ways.start(plan.input.def());
        if (spent_ > 0) plan.advance(room, spent_);
    }
    const StreamStatus status = plan.advance(room, operations);
    plan.turns.push_back({spent_, operations, plan.ways.operations()});
    spent_ = plan.ways.operations();
    return status;
}

void MarchPlans::keep(MarchPlans& before) {
    *this = std::move(before);
    begun_ = false;
    rewinds_ = true;
}

}  // namespace muster
