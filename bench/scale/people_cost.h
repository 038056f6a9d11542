// What a step costs by the law of people beside that of units: the same crowd on the same ring.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster::scale {

/// What is to be measured.
struct PeopleCostDef {
    std::vector<std::int32_t> counts;  ///< Sizes of crowds; empty for 1,000, 10,000 and 100,000.
    std::vector<double> densities;     ///< [1/m^2]; empty for 0.5 and 4.
    std::int32_t rounds = 5;           ///< Turns of each law, which take turns.
};

/// One crowd by both laws.
struct PeopleRow {
    std::int32_t count = 0;   ///< Characters.
    double density = 0.0;     ///< [1/m^2]
    double units = 0.0;       ///< Median time of a step by the preset `units` [ms].
    double people = 0.0;      ///< The same by `people`.
    double unitsSpeed = 0.0;  ///< Mean speed at the end [m/s].
    double peopleSpeed = 0.0;

    double ratio() const { return units > 0.0 ? people / units : 0.0; }  ///< People to units.
};

/// Measures all crowds.
Result<std::vector<PeopleRow>> measurePeople(const PeopleCostDef& def);
/// A table for people.
std::string peopleText(const std::vector<PeopleRow>& rows);

}  // namespace muster::scale
