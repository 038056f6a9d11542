// Film strip: pictures in rows, as one SVG document.
#pragma once

#include <string>
#include <vector>

#include "lab/reproduce/experiments/samples.h"

namespace muster {

/// Number of pictures in a row such that rows are about equally long: 5 pictures with at most 4 in a row
/// become 3 and 2.
std::int32_t stripColumns(std::size_t frames, std::int32_t most = 4);

/// A strip of all pictures, each with its time and caption below, in rows of at most `columns`. Letters are
/// large enough for a strip of four on a page 180 mm wide. Empty for no pictures.
std::string filmStrip(const std::vector<FilmFrame>& film, std::int32_t columns = 4);

}  // namespace muster
