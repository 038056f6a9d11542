#include "game_picture.h"

namespace game {

muster::Status savePicture(SDL_Renderer* renderer, const std::string& path) {
    int width = 0, height = 0;
    SDL_GetRendererOutputSize(renderer, &width, &height);
    SDL_Surface* surface = SDL_CreateRGBSurfaceWithFormat(0, width, height, 24, SDL_PIXELFORMAT_BGR24);
    const bool saved = surface != nullptr &&
                       SDL_RenderReadPixels(renderer, nullptr, SDL_PIXELFORMAT_BGR24, surface->pixels,
                                            surface->pitch) == 0 &&
                       SDL_SaveBMP(surface, path.c_str()) == 0;
    SDL_FreeSurface(surface);
    if (saved) return {};
    return {muster::StatusCode::IoError, path + " cannot be written: " + SDL_GetError()};
}

}  // namespace game
