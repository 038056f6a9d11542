#include "engine/world/departures.h"

#include <algorithm>
#include <cmath>

#include "engine/world/inspect.h"

namespace muster {
namespace {

/// The figures of an area; they are added if there are none yet.
template <class Figures>
Figures& of(std::vector<Figures>& all, std::uint32_t id) {
    const auto isBefore = [](const Figures& one, std::uint32_t other) { return one.id.value < other; };
    const auto at = std::lower_bound(all.begin(), all.end(), id, isBefore);
    if (at != all.end() && at->id.value == id) return *at;
    Figures added;
    added.id = AreaId{id};
    return *all.insert(at, std::move(added));
}

}  // namespace

// Names stay known when an area is removed.
void DepartureWatch::listAreas(const World& world) {
    for (std::size_t k = 0; k < world.areaCount(); ++k) {
        const AreaView area = world.area(k);
        if (area.def.kind == AreaKind::Exit) of(exits_, area.id.value).name = area.def.name;
        if (area.def.kind == AreaKind::Source) of(sources_, area.id.value).name = area.def.name;
    }
}

void DepartureWatch::observe(const World& world) {
    // Only commands change areas; the commands of the last step have the number that the world had before it.
    if (!listed_ || world.lastCommandStep() + 1 == world.stepCount()) listAreas(world);
    listed_ = true;
    for (const Event& event : world.events()) {
        if (event.kind == EventKind::Entered) ++of(sources_, event.value).entered;
        if (event.kind != EventKind::Exited) continue;
        ExitFigures& exit = of(exits_, event.value);
        if (exit.left++ == 0) exit.first = world.time();
        exit.last = world.time();
        leftAt_.push_back(world.stepCount());
    }
}

bool DepartureWatch::moreMayCome(const World& world) {
    for (std::size_t k = 0; k < world.areaCount(); ++k)
        if (inspect::maySend(world, k)) return true;
    return false;
}

DepartureFigures DepartureWatch::figures(const World& world) const {
    DepartureFigures figures;
    figures.left = static_cast<std::uint32_t>(leftAt_.size());
    figures.exits = exits_;
    for (ExitFigures& exit : figures.exits)
        if (exit.last > exit.first) exit.flow = (exit.left - 1.0) / (exit.last - exit.first);
    figures.sources = sources_;
    std::size_t all = leftAt_.size() + world.characters().size();
    for (std::size_t k = 0; k < world.areaCount(); ++k) {
        const AreaView area = world.area(k);
        if (area.def.kind != AreaKind::Source) continue;
        of(figures.sources, area.id.value).waiting = area.count.waiting;
        all += area.count.waiting;
    }
    if (leftAt_.empty()) return figures;
    const double stepTime = world.parameters().stepTime;
    figures.first = leftAt_.front() * stepTime;
    figures.last = leftAt_.back() * stepTime;
    if (moreMayCome(world)) return figures;
    const auto when = [&](double share) {
        const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(all) - 1e-9));
        return rank <= leftAt_.size() ? leftAt_[std::max<std::size_t>(rank, 1) - 1] * stepTime : -1.0;
    };
    figures.left50 = when(0.5);
    figures.left95 = when(0.95);
    return figures;
}

}  // namespace muster
