#include "lab/measures/trajectories.h"

#include <algorithm>
#include <string>
#include <utility>

namespace muster {
namespace {

constexpr std::int64_t kMostFrames = 100'000'000;

bool earlier(const Sighting& a, const Sighting& b) {
    return a.frame != b.frame ? a.frame < b.frame : a.id < b.id;
}

Status check(double frameRate, const std::vector<Sighting>& sorted) {
    if (!(frameRate > 0.0) || !std::isfinite(frameRate))
        return invalidArgument("frame rate: found " + std::to_string(frameRate) + ", expected above 0");
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const Sighting& s = sorted[i];
        const std::string who = "person " + std::to_string(s.id) + " in frame " + std::to_string(s.frame);
        if (!isFinite(s.position)) return invalidArgument(who + ": found a position that is not finite");
        if (i > 0 && !earlier(sorted[i - 1], s)) return invalidArgument(who + ": found twice");
    }
    if (!sorted.empty() && std::int64_t{sorted.back().frame} - sorted.front().frame >= kMostFrames)
        return invalidArgument("frames: found more than 100,000,000");
    return {};
}

}  // namespace

Result<Trajectories> Trajectories::create(double frameRate, std::vector<Sighting> sightings) {
    std::sort(sightings.begin(), sightings.end(), earlier);
    if (Status s = check(frameRate, sightings); !s.ok()) return s;
    Trajectories made;
    made.frameRate_ = frameRate;
    made.sightings_ = std::move(sightings);
    const auto& all = made.sightings_;
    if (!all.empty()) made.frameEnd_.assign(all.back().frame - all.front().frame + 1, 0);
    std::vector<std::pair<std::uint32_t, std::int32_t>> order;
    order.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        made.frameEnd_[all[i].frame - all.front().frame] = static_cast<std::int32_t>(i + 1);
        order.emplace_back(all[i].id, static_cast<std::int32_t>(i));
    }
    for (std::size_t f = 1; f < made.frameEnd_.size(); ++f)
        made.frameEnd_[f] = std::max(made.frameEnd_[f], made.frameEnd_[f - 1]);
    std::sort(order.begin(), order.end());
    for (const auto& [id, row] : order) {
        if (made.persons_.empty() || made.persons_.back() != id) {
            made.persons_.push_back(id);
            made.personEnd_.push_back(0);
        }
        made.byPerson_.push_back(row);
        made.personEnd_.back() = static_cast<std::int32_t>(made.byPerson_.size());
    }
    return made;
}

std::int32_t Trajectories::frameCount() const {
    return static_cast<std::int32_t>(frameEnd_.size());
}

std::span<const Sighting> Trajectories::frame(std::int32_t index) const {
    const std::int32_t begin = index > 0 ? frameEnd_[index - 1] : 0;
    return std::span(sightings_).subspan(begin, frameEnd_[index] - begin);
}

std::span<const std::int32_t> Trajectories::ofPerson(std::size_t person) const {
    const std::int32_t begin = person > 0 ? personEnd_[person - 1] : 0;
    return std::span(byPerson_).subspan(begin, personEnd_[person] - begin);
}

Result<Trajectories> withImages(const Trajectories& ring, double left, double period, double reach,
                                std::uint32_t imageId) {
    std::vector<Sighting> all(ring.all().begin(), ring.all().end());
    for (const Sighting& s : ring.all()) {
        const auto image = [&](double by, std::uint32_t which) {
            all.push_back({s.frame, s.id + which * imageId, s.position + Vec2{by, 0.0}});
        };
        if (s.position.x < left + reach) image(period, 1);
        if (s.position.x > left + period - reach) image(-period, 2);
    }
    return Trajectories::create(ring.frameRate(), std::move(all));
}

}  // namespace muster
