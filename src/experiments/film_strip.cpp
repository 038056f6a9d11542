#include "experiments/film_strip.h"

namespace muster {

std::string filmStrip(const std::vector<FilmFrame>& film, std::int32_t) {
    return film.empty() ? std::string() : film.front().svg;
}

}  // namespace muster
