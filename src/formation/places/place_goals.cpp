#include "formation/places/place_goals.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "formation/places/place_spacing.h"

namespace muster {
namespace {

constexpr std::int32_t kMostSpots = 60000;  // Looked at for goals without room when all are sought anew.
constexpr std::int32_t kRings = 8;          // Round a goal, one diameter wide each.
constexpr double kBeyond = 1e-3;            // Distances are asked for so much farther than they matter [m].

}  // namespace

bool PlaceGround::roomyExactly(Vec2 p, double distance) const {
    return environment_.distanceToObstacle(p, distance + kBeyond) >= distance;
}

bool PlaceGround::inRegion(Vec2 p) const {
    if (region_ < 0) return true;
    const std::int32_t label = environment_.region(p, def_.radius);
    if (label >= 0) return label == region_;
    const Grid& grid = environment_.grid();
    const Cell cell = grid.nearestCell(p);
    for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y) {
        for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
            if (!grid.contains({x, y})) continue;
            const Vec2 centre = grid.centre({x, y});
            if (environment_.region(centre, def_.radius) == region_ &&
                environment_.clearLine(p, centre, lineRadius(def_)))
                return true;
        }
    }
    return false;
}

bool PlaceGround::standableByRegion(Vec2 p) const {
    // In an undivided world the raster has been asked in vain.
    const bool room = undivided_ ? inner_.contains(p) && roomyExactly(p, clearRadius())
                                 : roomy(p, clearRadius());
    return room && inRegion(p);
}

Vec2 PlaceGround::reachable(Vec2 p) const {
    if (standable(p)) return p;
    const Vec2 pushed = environment_.projectToFreeSpace(p, clearRadius());
    if (inRegion(pushed)) return pushed;
    const Vec2 inside = environment_.nearestInRegion(p, def_.radius, region_);
    // The cell's centre may lack the clearance; it is kept where gaining that would leave the region.
    const Vec2 clear = environment_.projectToFreeSpace(inside, clearRadius());
    return inRegion(clear) ? clear : inside;
}

namespace {

// Tries the spots round a goal, from the inside out; counts them off `left`.
bool seatOne(const PlaceGround& ground, double apart, const std::vector<std::uint8_t>& fit,
             NearSearch& search, std::vector<Vec2>& goals, std::size_t goal, std::int32_t& left) {
    const Vec2 middle = goals[goal];
    for (std::int32_t ring = 1; ring <= kRings; ++ring) {
        const std::int32_t spots = 6 * ring;
        for (std::int32_t s = 0; s < spots; ++s, --left) {
            const double angle = 2.0 * kPi * (s + 0.5 * (ring % 2)) / spots;
            const Vec2 spot = middle + Vec2{cosine(angle), sine(angle)} * (1.01 * apart * ring);
            if (search.occupied(spot, fit, goals) || !ground.standable(spot)) continue;
            search.take(spot);
            goals[goal] = spot;
            return true;
        }
    }
    return false;
}

}  // namespace

void seatUnfit(const PlaceGround& ground, double apart, std::vector<Vec2>& goals,
               std::vector<std::uint8_t>& fit, SpacingMemory& memory) {
    if (std::find(fit.begin(), fit.end(), std::uint8_t{0}) == fit.end()) return;
    NearSearch search(goals, apart, memory);
    std::int32_t left = kMostSpots;
    for (std::size_t k = 0; k < goals.size() && left > 0; ++k) {
        // Marked 1 only at the end: goals in hand are found by their old cells.
        if (fit[k] == 0 && seatOne(ground, apart, fit, search, goals, k, left)) fit[k] = 2;
    }
    for (std::uint8_t& f : fit) f = f != 0 ? 1 : 0;
}

}  // namespace muster
