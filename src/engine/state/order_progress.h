// How far a group has come with its order, and which events it has raised.
#pragma once

#include <cstdint>

namespace muster {

/// Whether an arrival is to be raised.
enum class ArrivalWatch : std::uint8_t {
    Raised,   ///< The order is carried out.
    Idle,     ///< There is no order, but somebody may have to walk, since the ground or the group is new.
    Awaited,  ///< An order is carried out, or somebody was out of reach of their place.
};

/// What a group was ordered last, and what was raised about it. An order is a pose, a formation, a count or a
/// drawn way.
struct OrderProgress {
    ArrivalWatch arrival = ArrivalWatch::Idle;
    bool fresh = true;              ///< Nothing was raised yet about the ways of this order.
    std::uint32_t step = 0;         ///< Step of the order, or the last in which its way was still drawn.
    bool judged = false;            ///< Ways were judged for this order and version of the ground.
    std::uint32_t ground = 0;       ///< Version of the ground for which they were.
    std::int32_t withoutWay = 0;    ///< Places or characters without a way at the last judgement.
    std::int32_t behindMoving = 0;  ///< Characters reported to be cut off by moving obstacles; 0 for none.
    std::uint32_t movingSince = 0;  ///< Last step in which what was reported of these was still true.

    /// Begins a new order.
    void begin(std::uint32_t now) {
        arrival = ArrivalWatch::Awaited;
        fresh = true;
        step = now;
        judged = false;
        behindMoving = 0;
        movingSince = now;
    }

    /// Lets an archive read or write the progress.
    template <class Archive>
    void visit(Archive& archive) {
        archive(arrival, fresh, step, judged, ground, withoutWay, behindMoving, movingSince);
    }
};

}  // namespace muster
