#include "files/edits/own_tracks.h"

#include <algorithm>
#include <utility>

#include "files/edits/edited_path.h"

namespace muster {
namespace {

std::vector<std::uint32_t> peopleOf(const std::vector<TakeEdit>& edits, bool (*wanted)(const TakeEdit&)) {
    std::vector<std::uint32_t> people;
    for (const TakeEdit& edit : edits)
        if (wanted(edit)) people.insert(people.end(), edit.people.begin(), edit.people.end());
    std::sort(people.begin(), people.end());
    return people;
}

}  // namespace

void OwnTracks::observe(const World& world) {
    const CharactersView all = world.characters();
    const std::uint32_t step = world.stepCount();
    for (const std::uint32_t id : people_) {
        const auto found = std::lower_bound(all.id.begin(), all.id.end(), id);
        if (found == all.id.end() || *found != id) continue;
        const auto i = static_cast<std::size_t>(found - all.id.begin());
        Track& track = tracks_[id];
        if (track.points.empty()) track.first = step;
        if (step != track.first + track.points.size()) continue;
        track.points.push_back({all.position[i], all.velocity[i], all.heading[i]});
    }
}

bool OwnTracks::at(std::uint32_t id, double step, TrackPoint& point) const {
    const auto found = tracks_.find(id);
    if (found == tracks_.end() || found->second.points.empty()) return false;
    const Track& track = found->second;
    const auto last = static_cast<double>(track.points.size() - 1);
    const double wanted = step - static_cast<double>(track.first);
    const double at = std::clamp(wanted, 0.0, last);
    const auto k = static_cast<std::size_t>(at);
    const TrackPoint& a = track.points[k];
    const TrackPoint& b = track.points[std::min(k + 1, track.points.size() - 1)];
    const double share = at - static_cast<double>(k);
    point.position = a.position + (b.position - a.position) * share;
    point.velocity = a.velocity + (b.velocity - a.velocity) * share;
    point.heading = normalized(a.heading + (b.heading - a.heading) * share, a.heading);
    if (wanted != at) point.velocity = {};  // It waits where it came from or went to.
    return true;
}

std::vector<std::uint32_t> peopleWithClocks(const std::vector<TakeEdit>& edits) {
    return peopleOf(edits, [](const TakeEdit& edit) { return !edit.clock.empty(); });
}

std::vector<std::uint32_t> editedPeople(const std::vector<TakeEdit>& edits) {
    return peopleOf(edits, [](const TakeEdit&) { return true; });
}

Result<OwnTracks> gatherTracks(const Take& take, double until, std::int32_t threads, ReplayFrom from) {
    OwnTracks tracks(peopleWithClocks(take.about.edits));
    if (tracks.people().empty()) return tracks;
    double last = until;  // Of the recording.
    for (const TakeEdit& edit : take.about.edits) last = std::max(last, OwnClock(edit.clock).at(until).time);
    auto start = World::create(take.def, threads);
    if (!start.ok()) return start.status();
    tracks.observe(*start);
    const double step = start->parameters().stepTime;
    const auto report = replayTake(
        take, threads,
        [&](const World& world) {
            tracks.observe(world);
            return world.time() < last + step;
        },
        from);
    if (!report.ok()) return report.status();
    return tracks;
}

}  // namespace muster
