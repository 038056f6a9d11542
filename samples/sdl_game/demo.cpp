#include "demo.h"

#include <SDL.h>

#include <array>

namespace game {
namespace {

/// A stroke of a button from frame to frame, or a key where there is no button.
struct Act {
    std::int32_t from, to;
    Uint8 button;
    Vec2 begin, end;  // [m]
    SDL_Keycode key = 0;
};

constexpr auto kActs = std::to_array<Act>({
    // The northern fifty draw up a front before the tower's hill.
    {10, 25, SDL_BUTTON_LEFT, {-23.0, 1.0}, {-13.0, 9.0}},
    {30, 60, SDL_BUTTON_RIGHT, {3.5, 8.5}, {3.5, -1.0}},
    // The southern fifty are cut in two; one half goes round the house.
    {80, 95, SDL_BUTTON_LEFT, {-23.0, -9.0}, {-13.0, -1.0}},
    {100, 100, 0, {}, {}, SDLK_s},
    {130, 145, SDL_BUTTON_LEFT, {-23.0, -9.5}, {-12.0, -5.0}},
    {150, 150, SDL_BUTTON_RIGHT, {8.0, -7.0}, {8.0, -7.0}},
    {170, 185, SDL_BUTTON_LEFT, {-23.0, -5.0}, {-12.0, 0.0}},
    {190, 190, SDL_BUTTON_RIGHT, {-7.5, -2.0}, {-7.5, -2.0}},
    // Three of the last fall by a key.
    {330, 340, SDL_BUTTON_LEFT, {-9.0, -1.2}, {-6.0, -0.4}},
    {345, 345, 0, {}, {}, SDLK_k},
    // The front goes on against the tower; it is selected and the next line is being drawn.
    {900, 920, SDL_BUTTON_LEFT, {0.0, -2.0}, {6.5, 10.0}},
    {930, 990, SDL_BUTTON_RIGHT, {8.5, 12.5}, {10.8, 2.5}},
});

void push(Uint32 type, Uint8 button, Vec2 p, SDL_Keycode key) {
    SDL_Event event{};
    event.type = type;
    const int x = static_cast<int>(p.x + 0.5), y = static_cast<int>(p.y + 0.5);
    if (type == SDL_KEYDOWN) {
        event.key.keysym.sym = key;
    } else if (type == SDL_MOUSEMOTION) {
        event.motion.x = x;
        event.motion.y = y;
    } else {
        event.button.button = button;
        event.button.x = x;
        event.button.y = y;
    }
    SDL_PushEvent(&event);
}

}  // namespace

void playDemo(std::int32_t frame, const Camera& camera) {
    for (const Act& act : kActs) {
        if (frame < act.from || frame > act.to) continue;
        const double share = act.to > act.from ? static_cast<double>(frame - act.from) / (act.to - act.from)
                                               : 1.0;
        const Vec2 p = camera.toWindow(muster::lerp(act.begin, act.end, share));
        if (act.key != 0) {
            push(SDL_KEYDOWN, 0, p, act.key);
            continue;
        }
        if (frame == act.from) push(SDL_MOUSEBUTTONDOWN, act.button, p, 0);
        push(SDL_MOUSEMOTION, 0, p, 0);
        if (frame == act.to) push(SDL_MOUSEBUTTONUP, act.button, p, 0);
    }
}

}  // namespace game
