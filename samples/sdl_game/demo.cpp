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
    // The northern fifty draw up a front between house and tree.
    {10, 25, SDL_BUTTON_LEFT, {-23.0, 0.1}, {-13.0, 10.5}},
    {30, 60, SDL_BUTTON_RIGHT, {3.5, 9.0}, {3.5, -0.5}},
    // The southern fifty are cut in two: one half goes behind the southern house, the other stays before it.
    {80, 95, SDL_BUTTON_LEFT, {-23.0, -10.5}, {-13.0, -0.1}},
    {100, 100, 0, {}, {}, SDLK_s},
    {130, 145, SDL_BUTTON_LEFT, {-23.0, -10.5}, {-11.0, -5.1}},
    {150, 150, SDL_BUTTON_RIGHT, {5.5, -9.0}, {5.5, -9.0}},
    {170, 185, SDL_BUTTON_LEFT, {-23.0, -4.9}, {-11.0, 0.0}},
    {190, 190, SDL_BUTTON_RIGHT, {-10.0, -4.0}, {-10.0, -4.0}},
    // Some of them fall by a key.
    {700, 710, SDL_BUTTON_LEFT, {-13.0, -3.4}, {-10.4, -2.6}},
    {715, 715, 0, {}, {}, SDLK_k},
    // The front goes on against the tower, and others with it.
    {1900, 1915, SDL_BUTTON_LEFT, {-6.0, -3.0}, {6.5, 10.5}},
    {1920, 1960, SDL_BUTTON_RIGHT, {8.5, 12.0}, {9.5, 2.0}},
    {2550, 2565, SDL_BUTTON_LEFT, {-14.0, -8.0}, {-6.5, -0.5}},
    {2590, 2590, SDL_BUTTON_RIGHT, {4.0, 3.5}, {4.0, 3.5}},
    {2700, 2715, SDL_BUTTON_LEFT, {1.0, -13.5}, {9.0, -4.0}},
    {2720, 2790, SDL_BUTTON_RIGHT, {13.0, 0.0}, {20.0, 1.5}},
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
