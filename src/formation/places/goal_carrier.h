// Goals of places from step to step: carried along by their targets, seated anew where there is no room.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "formation/places/place_goals.h"
#include "formation/places/seat_list.h"

namespace muster {

/// Working memory of a GoalCarrier: nothing in it but the list of seats outlives a step, and that can be made
/// again.
struct CarryMemory {
    SeatList seats;
    std::vector<Vec2> carried;  ///< Where each would be if it went with its target [m].
    /// Where it goes: nearer to its target if it can, until it gives way [m].
    std::vector<Vec2> next;
    std::vector<std::uint8_t> level;   ///< Which of these it does.
    std::vector<std::uint8_t> exact;   ///< 1 for those on their targets.
    std::vector<std::uint8_t> losing;  ///< 1 for those that are to give way.
    std::vector<std::int32_t> losers;
    std::vector<std::int32_t> lowered;
    std::vector<std::int32_t> seekers;  ///< Places without the best seat, in the order of their turns.
    std::vector<std::int32_t> taken;    ///< Places seated anew in this step.
};

/// What goals are known by.
struct GoalState {
    std::vector<Vec2>& goal;         ///< Seats of the last step, to be those of this [m].
    std::vector<Vec2>& target;       ///< Targets of the last step, to be those of this [m].
    std::vector<std::uint8_t>& fit;  ///< 1 where a place has a seat.
    std::uint32_t& turn;             ///< Place whose turn it is to look for a seat.
};

/// Carries seats along. Who sits on its target goes with it; others are carried by the way of theirs and
/// drawn to it. Where two would come too near, one gives up first being drawn, then being carried; where all
/// stay nobody is too near. Who has no seat, or not the best, looks for one in turns.
class GoalCarrier {
public:
    /// Seats are kept `apart` [m]; being drawn takes them up to `pull` [m] in a step.
    GoalCarrier(const PlaceGround& ground, double apart, double pull, const GoalState& state,
                CarryMemory& memory)
        : ground_(ground), apart_(apart), pull_(pull), s_(state), m_(memory) {}

    /// One step. False, with nothing changed, where so many targets leapt that all had better be sought anew.
    bool run(std::span<const Vec2> targets, ThreadPool* pool);

private:
    enum Level : std::uint8_t { Stays, Carried, Drawn, Leapt };

    void carry(std::size_t place, Vec2 target);
    void approach(std::size_t place, Vec2 target, Vec2 carried, bool free);
    bool settle(Vec2& spot, Vec2 from) const;
    void giveWay();
    bool tooNear(std::size_t a, std::size_t b) const;
    void part(std::size_t a, std::size_t b);
    void lower(std::size_t place);
    void seatInTurns(std::span<const Vec2> targets);
    void listSeekers(std::span<const Vec2> targets, std::size_t first);
    bool seat(std::size_t place, Vec2 target, std::int32_t& left);
    bool offer(std::size_t place, Vec2 spot);

    const PlaceGround& ground_;
    double apart_;
    double pull_;
    GoalState s_;
    CarryMemory& m_;
};

}  // namespace muster
