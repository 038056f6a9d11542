// Which class stands where in a formation (SPEC B13).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/formation/shapes/make_formation.h"
#include "muster/people.h"

namespace muster {

/// Members of a group by class.
using ClassCounts = std::array<std::int32_t, 256>;

/// Gives the places of a formation classes by its roles. Roles choose in their order: each takes as many
/// usable places as there are characters of its class, the first ones of its area on the rest shape (of two
/// roles of one class each takes half of them). The other places have class 0. All follows from the
/// arguments; the orders of places are kept as long as formation and roles stay.
class PlaceClasses {
public:
    /// Writes the class of each place; empty without roles. `usable` is per place, 0 where nobody can stand.
    void find(const Formation& formation, std::span<const RoleDef> roles, const ClassCounts& counts,
              std::span<const std::uint8_t> usable, std::vector<std::uint8_t>& classes);

private:
    void sortPlaces(const Formation& formation, std::span<const RoleDef> roles);

    std::vector<RoleDef> roles_;                    // For which these were sorted:
    std::vector<std::vector<std::int32_t>> order_;  // Per role: places, the first ones first.
    std::vector<Vec2> rest_;                        // Places on the rest shape [m].
    std::vector<std::int64_t> key_;                 // Per place.
    std::vector<Vec2> now_;                         // Working memory.
};

/// Who has no role counts as class 0.
std::uint8_t roleClass(std::span<const RoleDef> roles, std::uint8_t unitClass);

}  // namespace muster
