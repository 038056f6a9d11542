#include "engine/systems/goals/herds.h"

namespace muster {

void Herds::clear(const Box& box, std::size_t exits) {
    grid_ = Grid::covering(box, kCell);
    exits_ = exits;
    count_.assign(static_cast<std::size_t>(grid_.count()) * exits, 0);
    all_.assign(grid_.count(), 0);
}

void Herds::add(Vec2 p, std::size_t exit) {
    const std::int32_t cell = grid_.index(grid_.nearestCell(p));
    ++count_[static_cast<std::size_t>(cell) * exits_ + exit];
    ++all_[cell];
}

Herds::Sight::Sight(const Herds& herds, const StaticGround& ground, Vec2 p, std::int32_t own)
    : herds_(herds), own_(own) {
    const Grid& grid = herds.grid_;
    const Cell middle = grid.nearestCell(p);
    for (std::int32_t y = middle.y - kReach; y <= middle.y + kReach; ++y)
        for (std::int32_t x = middle.x - kReach; x <= middle.x + kReach; ++x) {
            if (!grid.contains({x, y}) || herds.all_[grid.index({x, y})] == 0) continue;
            const Vec2 centre = grid.centre({x, y});
            const bool home = Cell{x, y} == middle;
            if (distance(centre, p) > kNearby || !(home || ground.collisionFree(p, centre))) continue;
            cells_[count_++] = grid.index({x, y});
            all_ += herds.all_[grid.index({x, y})];
        }
    if (own >= 0) all_ -= 1.0;
}

double Herds::Sight::share(std::size_t exit) const {
    if (!(all_ > 0.0)) return 0.0;
    double sum = own_ >= 0 && static_cast<std::size_t>(own_) == exit ? -1.0 : 0.0;
    for (std::size_t k = 0; k < count_; ++k)
        sum += herds_.count_[static_cast<std::size_t>(cells_[k]) * herds_.exits_ + exit];
    return sum > 0.0 ? sum / all_ : 0.0;
}

}  // namespace muster
