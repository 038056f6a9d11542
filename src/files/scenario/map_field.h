// The `map` of a scenario: a MovingAI file or its rows.
#pragma once

#include <optional>
#include <string>

#include "files/scenario/fields.h"
#include "muster/world_def.h"

namespace muster {

/// The box that the map covers.
Box mapBox(const MapGround& map);

/// Each returns true where a map was read or written.
bool describeMap(FieldReader& v, std::optional<MapGround>& map, const std::string& folder);
bool describeMap(FieldWriter& v, std::optional<MapGround>& map, const std::string& folder);
bool describeMap(FieldSchema& v, std::optional<MapGround>& map, const std::string& folder);

}  // namespace muster
