// A game in SDL: a hundred units at the engine's own tick, drawn as often as the screen can show them.
#include <SDL.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "demo.h"
#include "game_battle.h"
#include "game_options.h"
#include "game_picture.h"
#include "game_scene.h"
#include "jobs.h"
#include "mouse.h"

namespace {

using namespace game;

constexpr int kWidth = 1280, kHeight = 800;
constexpr Vec2 kField{48.0, 30.0};         // [m]
constexpr double kDemoFrame = 1.0 / 75.0;  // Of a frame without a screen: no multiple of a step [s].
constexpr double kMostBehind = 0.25;       // Time that cannot be caught up with is dropped [s].

template <auto Destroy>
struct Destroyer {
    template <class Thing>
    void operator()(Thing* thing) const {
        Destroy(thing);
    }
};
using Window = std::unique_ptr<SDL_Window, Destroyer<SDL_DestroyWindow>>;
using Texture = std::unique_ptr<SDL_Texture, Destroyer<SDL_DestroyTexture>>;
using Renderer = std::unique_ptr<SDL_Renderer, Destroyer<SDL_DestroyRenderer>>;

int complain(const char* what) {
    std::fprintf(stderr, "sdl_game: %s\n", what);
    return 1;
}

/// The engine's steps that are due; returns the share of a step that is left.
double advance(Battle& battle, double& behind) {
    for (; behind >= battle.stepTime(); behind -= battle.stepTime()) battle.step();
    return behind / battle.stepTime();
}

/// Draws at twice the window's size and halves it, which makes all edges smooth.
void draw(SDL_Renderer* renderer, SDL_Texture* twice, const Battle& battle, const Mouse& mouse,
          double share) {
    SDL_SetRenderTarget(renderer, twice);
    SDL_SetRenderDrawColor(renderer, 0xaf, 0xc0, 0x8e, 0xff);
    SDL_RenderClear(renderer);
    Painter painter(renderer);
    drawScene(painter, Camera(kField, 2 * kWidth, 2 * kHeight), battle, mouse, share);
    SDL_SetRenderTarget(renderer, nullptr);
    SDL_RenderCopy(renderer, twice, nullptr, nullptr);
}

/// Frame by frame, until the player leaves or the demo ends.
void play(const Options& options, SDL_Renderer* renderer, SDL_Texture* twice, Battle& battle) {
    const Camera camera(kField, kWidth, kHeight);
    Mouse mouse;
    double behind = 0.0;
    Uint64 last = SDL_GetPerformanceCounter();
    for (std::int32_t frame = 0; options.frames == 0 || frame < options.frames; ++frame) {
        if (options.frames > 0) playDemo(frame, camera);
        for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
            if (event.type == SDL_QUIT) return;
            mouse.handle(event, camera, battle);
        }
        const Uint64 now = SDL_GetPerformanceCounter();
        const double passed = static_cast<double>(now - last) /
                              static_cast<double>(SDL_GetPerformanceFrequency());
        last = now;
        behind += options.frames > 0 ? kDemoFrame : std::min(passed, kMostBehind);
        const double share = advance(battle, behind);
        if (options.frames > 0 && frame + 1 < options.frames) continue;  // Nobody sees it.
        draw(renderer, twice, battle, mouse, share);
        if (options.frames == 0) SDL_RenderPresent(renderer);  // Waits for the screen.
    }
}

int run(const Options& options) {
    const bool demo = options.frames > 0;
    Window window(SDL_CreateWindow(
        "Muster: drag left to select, right to move or draw a front, S split, K kill", SDL_WINDOWPOS_CENTERED,
        SDL_WINDOWPOS_CENTERED, kWidth, kHeight, demo ? SDL_WINDOW_HIDDEN : SDL_WINDOW_SHOWN));
    if (!window) return complain(SDL_GetError());
    Renderer renderer(
        SDL_CreateRenderer(window.get(), -1, demo ? SDL_RENDERER_SOFTWARE : SDL_RENDERER_PRESENTVSYNC));
    if (!renderer) return complain(SDL_GetError());
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
    const Texture twice(SDL_CreateTexture(renderer.get(), SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_TARGET,
                                          2 * kWidth, 2 * kHeight));
    if (!twice) return complain(SDL_GetError());
    Jobs jobs(2);  // They end after the battle.
    muster::Result<Battle> battle = Battle::create(jobs.runner());
    if (!battle.ok()) return complain(battle.status().message().c_str());
    play(options, renderer.get(), twice.get(), *battle);
    if (!options.picture.empty())
        if (const muster::Status saved = savePicture(renderer.get(), options.picture); !saved.ok())
            return complain(saved.message().c_str());
    std::printf(
        "%u steps; %zu units in %zu groups, %zu have fallen; the game's threads did %llu rounds and %llu "
        "pieces in the background\n",
        battle->world().stepCount(), battle->world().characters().size(), battle->world().groupCount(),
        battle->fallen().size(), static_cast<unsigned long long>(jobs.rounds()),
        static_cast<unsigned long long>(jobs.launches()));
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    const muster::Result<Options> options = readOptions(count, arguments);
    if (!options.ok()) return complain(options.status().message().c_str());
    if (options->frames > 0) SDL_setenv("SDL_VIDEODRIVER", "dummy", 1);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return complain(SDL_GetError());
    const int outcome = run(*options);
    SDL_Quit();
    return outcome;
}
