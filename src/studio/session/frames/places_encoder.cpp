#include "studio/session/frames/places_encoder.h"
#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/world/inspect.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::size_t kPerFrame = 1000;  // A frame updates at most so many changed places,
constexpr std::size_t kShare = 16;       // or one in so many of a larger group.

std::int16_t centimetres(double metres) {
    return static_cast<std::int16_t>(std::clamp(std::floor(metres * 100.0 + 0.5), -32767.0, 32767.0));
}

}  // namespace

void PlacesPicture::take(const World& world, std::size_t group) {
    const std::vector<Vec2>& positions = inspect::places(world, group).positions();
    const std::vector<std::uint8_t>& fit = inspect::places(world, group).fit();
    const FormationMesh& mesh = inspect::mesh(world, group);
    const Formation& formation = mesh.formation();
    const std::size_t count = std::min(positions.size(), formation.places.size());
    offsets.resize(2 * count);
    unfit.assign((count + 7) / 8, 0);
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2 from = formation.places[k].position(formation.mesh.triangles, mesh.finalMesh());
        offsets[2 * k] = centimetres(positions[k].x - from.x);
        offsets[2 * k + 1] = centimetres(positions[k].y - from.y);
        if (k < fit.size() && fit[k] == 0)
            unfit[k / 8] = static_cast<std::uint8_t>(unfit[k / 8] | (1u << (k % 8)));
    }
}

void PlacesEncoder::encode(const PlacesPicture& picture, protocol::GroupFrame& frame) {
    const std::size_t count = picture.offsets.size() / 2;
    offsets_.resize(2 * count, 0);
    unfit_.resize(picture.unfit.size(), 0);
    frame.moved.clear();
    frame.offsets.clear();
    frame.unfit.clear();
    const std::size_t most = std::max(kPerFrame, count / kShare);
    std::size_t looked = 0;
    for (; looked < count && frame.moved.size() < most; ++looked) {
        const std::size_t k = (next_ + looked) % count;
        if (offsets_[2 * k] == picture.offsets[2 * k] && offsets_[2 * k + 1] == picture.offsets[2 * k + 1])
            continue;
        frame.moved.push_back(static_cast<std::uint32_t>(k));
        for (const std::size_t n : {2 * k, 2 * k + 1}) {
            offsets_[n] = picture.offsets[n];
            frame.offsets.push_back(picture.offsets[n]);
        }
    }
    if (count > 0) next_ = (next_ + looked) % count;
    if (unfit_ == picture.unfit) return;
    unfit_ = picture.unfit;
    frame.unfit = picture.unfit;
}

}  // namespace muster
