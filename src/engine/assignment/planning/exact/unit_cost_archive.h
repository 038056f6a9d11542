// Run-length encoding of unit costs in snapshots.
#pragma once

#include "base/archive.h"
#include "engine/fields/cost/unit_cost.h"

namespace muster {

/// Writes a unit cost as runs of equal cells: open ground and walls take next to nothing.
void saveUnitCost(Writer& archive, const UnitCost& cost);
/// Reads the data of saveUnitCost(); false where it does not fit or a value is implausible.
bool loadUnitCost(Reader& archive, UnitCost& cost);

}  // namespace muster
