#include "studio/session/takes/player_edits.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace muster {

void PlayerEdits::set(const std::vector<TakeEdit>& edits, const ClipLibrary& library) {
    crowd_ = EditedCrowd(edits, library);
    std::vector<std::uint32_t> all;
    std::set_union(touched_.begin(), touched_.end(), crowd_.people().begin(), crowd_.people().end(),
                   std::back_inserter(all));
    touched_ = std::move(all);
    const std::vector<std::uint32_t> wanted = peopleWithClocks(edits);
    const auto has = [&](const OwnTracks& tracks) {
        return std::includes(tracks.people().begin(), tracks.people().end(), wanted.begin(), wanted.end());
    };
    if (tracks_ && has(*tracks_))
        gatherer_.reset();
    else if (!wanted.empty() && !(gatherer_ && has(gatherer_->tracks)))
        beginGathering(wanted);
    crowd_.setTracks(tracks_);
}

void PlayerEdits::beginGathering(std::vector<std::uint32_t> people) {
    auto world = World::create(take_->def, 1);
    if (!world.ok()) return;
    gatherer_ = std::make_unique<Gatherer>(Gatherer{std::move(world).value(),
                                                    stored_ ? Replayer::stored(*take_) : Replayer(*take_),
                                                    OwnTracks(std::move(people))});
    gatherer_->tracks.observe(gatherer_->world);
}

bool PlayerEdits::gather() {
    if (!gatherer_) return false;
    Gatherer& g = *gatherer_;
    Status status;
    if (!g.replayer.atEnd(g.world)) {
        status = g.replayer.submit(g.world);
        g.world.step();
        g.tracks.observe(g.world);
        if (status.ok()) status = g.replayer.compare(g.world);
    }
    // Where it differs, playing tells so; what is known until then is used.
    if (status.ok() && !g.replayer.atEnd(g.world)) return false;
    tracks_ = std::make_shared<const OwnTracks>(std::move(g.tracks));
    gatherer_.reset();
    crowd_.setTracks(tracks_);
    return true;
}

}  // namespace muster
