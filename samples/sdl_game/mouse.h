// From mouse and keys to what the player wants.
#pragma once

#include <SDL.h>

#include <optional>

#include "camera.h"
#include "game_battle.h"

namespace game {

/// A stroke that is being drawn [m].
struct Stroke {
    Vec2 from, to;
};

/// Left: a click or a box selects. Right: a click moves there, a drag draws the front, from its left end to
/// its right. Keys: S splits, K kills, A selects all, Esc selects none.
class Mouse {
public:
    void handle(const SDL_Event& event, const Camera& camera, Battle& battle);

    const Ids& selected() const { return selected_; }
    std::optional<Stroke> box() const { return box_; }
    std::optional<Stroke> front() const { return front_; }

private:
    void key(SDL_Keycode code, Battle& battle);
    void release(Uint8 button, Battle& battle);

    Ids selected_;
    std::optional<Stroke> box_, front_;
};

}  // namespace game
