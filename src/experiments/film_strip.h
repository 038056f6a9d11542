// Pictures side by side, as one SVG document.
#pragma once

#include <string>
#include <vector>

#include "muster/experiments/samples.h"

namespace muster {

/// A strip of all pictures, each with its time and caption below, in rows of at most `columns`.
std::string filmStrip(const std::vector<FilmFrame>& film, std::int32_t columns = 4);

}  // namespace muster
