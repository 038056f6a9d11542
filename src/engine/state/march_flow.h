// How the places of a group flow from where they stand to where an order wants them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/orders/asked_tiles.h"
#include "engine/orders/held_spot.h"
#include "engine/orders/march_plans.h"
#include "muster/vec2.h"

namespace muster {

/// How far a flowing march is.
enum class FlowPhase : std::uint8_t {
    None,      ///< The mesh says where places are.
    Planning,  ///< Places stand until the march is planned.
    Flowing,   ///< They are on their way.
    Standing,  ///< They have come to where they are to stand.
};

/// The march of one group. While it is not None it says where the places of the group are.
struct MarchFlow {
    FlowPhase phase = FlowPhase::None;
    double q = 0.0;             ///< How much of it is done, [0, 1].
    double speed = 0.0;         ///< Of the fastest of nine in ten places [m/s].
    double rate = 0.0;          ///< How much q grew lately while the march went a metre; 0 at first.
    std::uint32_t version = 0;  ///< Of the formation for which it was planned.
    std::uint32_t ground = 0;   ///< Version of the ground for which it was planned.
    std::int64_t spent = 0;     ///< Operations of the plan.
    Pose from, to;              ///< Of the formation, before and after.
    bool drawn = false;         ///< The way is kept to.
    double spacing = 1.0;       ///< Of the formation [m].
    double radius = 0.25;       ///< Of bodies [m].
    double closest = 1.0;       ///< As near as places may come to each other [m].
    /// What it was planned from: of each place the offset in its formation, and where it starts and ends [m].
    std::vector<Vec2> offsets, starts, ends;
    std::vector<Vec2> way;       ///< [m]
    std::vector<Pose> poses;     ///< That it goes through in one piece; none where it may flow.
    std::vector<HeldSpot> held;  ///< Those on the way who hold their ground.
    std::vector<Vec2> places;    ///< Where they are now [m].
    /// Of each place of the group, which of them it is; none where all are, in this order. Where some have
    /// fallen, the march goes on with their places empty.
    std::vector<std::int32_t> kept;
    AskedTiles asked;  ///< Where the plan has looked; once it is made.
    MarchPlans plans;  ///< The plan; a cache, made again from the above where it is missing.

    /// True while it says where places are.
    bool leads() const { return phase != FlowPhase::None; }
    /// True while they are on their way, or about to be.
    bool moves() const { return phase == FlowPhase::Planning || phase == FlowPhase::Flowing; }
    /// True where places stand where people were ordered to stop, whatever the formation is.
    bool isStop() const { return phase == FlowPhase::Standing && offsets.empty(); }
    /// The mesh leads again.
    void end() {
        phase = FlowPhase::None;
        kept.clear();
    }
    /// Appends to `list` those of points of all its places that are of places of the group.
    void select(const std::vector<Vec2>& points, std::vector<Vec2>& list) const {
        if (kept.empty()) list.insert(list.end(), points.begin(), points.end());
        for (const std::int32_t place : kept) list.push_back(points[place]);
    }
    /// The group goes on with some of its places, in this order.
    void keep(const std::vector<std::int32_t>& these) {
        std::vector<std::int32_t> now;
        for (const std::int32_t place : these) now.push_back(kept.empty() ? place : kept[place]);
        kept = std::move(now);
    }
    /// The places stand at their ends.
    void standAtEnds() {
        places = ends;
        q = 1.0;
        phase = FlowPhase::Standing;
    }
    /// What it is planned from.
    StreamDef def() const { return {offsets, starts, ends, way, spacing, radius, closest, drawn, poses}; }

    /// Lets an archive read or write everything but the cache.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, q, speed, rate, version, ground, spent, from, to, drawn, spacing, radius, closest,
                offsets, starts, ends, way, poses, held, places, kept, asked);
        if constexpr (Archive::kReading) plans = {};
    }
};

}  // namespace muster
