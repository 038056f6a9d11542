// Pictures side by side, as one SVG document.
#pragma once

#include <string>
#include <vector>

#include "reproduce/experiments/samples.h"

namespace muster {

/// Pictures in a row where there are `frames`, so that rows are equally long: 5 of at most 4 stand as 3
/// and 2.
std::int32_t stripColumns(std::size_t frames, std::int32_t most = 4);

/// A strip of all pictures, each with its time and caption below, in rows of at most `columns`. Letters are
/// large enough for a strip of four on a page 180 mm wide. Empty for no pictures.
std::string filmStrip(const std::vector<FilmFrame>& film, std::int32_t columns = 4);

}  // namespace muster
