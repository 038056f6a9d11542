// The crowd's state in whole numbers, as frames hold it. It is the same for all clients.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// The largest crowd with fine headings and phases. Larger crowds have coarse ones and a larger quantum.
inline constexpr std::size_t kFineCrowd = 1000;

/// Maps positions to 16-bit whole numbers: multiples of a power of two from a corner. When the crowd walks
/// on, the corner moves by whole quanta, so that a standing character keeps its exact position.
class PlaceLattice {
public:
    /// Changes the lattice only where it cannot represent all these positions well.
    void cover(std::span<const Vec2> positions);

    double quantum() const { return quantum_; }  ///< Size of one unit [m].
    Vec2 corner() const { return corner_; }      ///< The position where both numbers are 0 [m].
    std::uint16_t x(Vec2 p) const;               ///< The number for the x coordinate.
    std::uint16_t y(Vec2 p) const;               ///< The number for the y coordinate.

private:
    double quantum_ = 0.0;  // 0 before the first cover().
    Vec2 corner_;
};

/// The state of all characters as a frame shows it.
struct CrowdPicture {
    PlaceLattice lattice;
    std::vector<std::uint16_t> x;  ///< Positions as numbers of the lattice.
    std::vector<std::uint16_t> y;
    std::vector<std::uint16_t> heading;  ///< Headings in 65536ths of a full turn.
    std::vector<std::uint8_t> clip;      ///< Indices into the clip library.
    std::vector<std::uint16_t> phase;    ///< Times within the clips in 65536ths of the clip.
    bool longClips = false;              ///< True where a clip is too long for coarse phases.
    std::vector<std::uint32_t> near;     ///< Indices of the characters with whole poses, ascending.
    /// x, y [m] and heading [rad] of each character with a whole pose.
    std::vector<float> nearPlaces;
    std::vector<std::int16_t> nearPoses;  ///< Their poses, in the layout of CrowdFrame::nearPoses.

    std::size_t size() const { return x.size(); }  ///< Number of characters.
    /// Resizes all lists. New characters face along x in the first pose.
    void resize(std::size_t count);
    /// Copies all positions; resizes the lists where the count differs.
    void place(std::span<const Vec2> positions);
};

}  // namespace muster
