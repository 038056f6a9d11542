// The window's content as a file.
#pragma once

#include <SDL.h>
#include <muster/status.h>

#include <string>

namespace game {

/// Writes what has been drawn as BMP. Fails with IoError, naming the file.
muster::Status savePicture(SDL_Renderer* renderer, const std::string& path);

}  // namespace game
