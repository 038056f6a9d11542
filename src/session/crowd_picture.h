// The crowd in whole numbers, as frames tell of it: the same for all clients.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// Crowds up to this size are told of in fine headings and phases; larger ones in coarse ones and wider
/// quanta.
inline constexpr std::size_t kFineCrowd = 1000;

/// Whole numbers of 16 bits for places: multiples of a power of two from one corner. Where the crowd walks
/// on, the corner moves by whole quanta, so that who stands still keeps its place to the bit.
class PlaceLattice {
public:
    /// Makes sure that all these have numbers; keeps what it has as long as that serves.
    void cover(std::span<const Vec2> positions);

    double quantum() const { return quantum_; }  ///< [m]
    Vec2 corner() const { return corner_; }      ///< Where both numbers are 0 [m].
    std::uint16_t x(Vec2 p) const;               ///< Its first number.
    std::uint16_t y(Vec2 p) const;               ///< Its second number.

private:
    double quantum_ = 0.0;  // 0: none yet.
    Vec2 corner_;
};

/// Everybody as a frame shows them.
struct CrowdPicture {
    PlaceLattice lattice;
    std::vector<std::uint16_t> x;  ///< By the lattice.
    std::vector<std::uint16_t> y;
    std::vector<std::uint16_t> heading;   ///< 65536ths of a turn.
    std::vector<std::uint8_t> clip;       ///< Index into the library.
    std::vector<std::uint16_t> phase;     ///< 65536ths of the clip.
    bool longClips = false;               ///< Some clip is too long for coarse phases.
    std::vector<std::uint32_t> near;      ///< Indices of those with whole poses, ascending.
    std::vector<float> nearPlaces;        ///< Per such x, y [m], heading [rad].
    std::vector<std::int16_t> nearPoses;  ///< Per such as CrowdFrame has it.

    std::size_t size() const { return x.size(); }  ///< Number of characters.
    void resize(std::size_t count);                ///< Makes room; new ones face along x, in the first pose.
    void place(std::span<const Vec2> positions);   ///< Takes everybody's positions; resizes.
};

}  // namespace muster
