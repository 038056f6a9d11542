#include "mouse.h"

namespace game {
namespace {

constexpr double kClick = 1.0;  // A shorter stroke of the right button is a click [m].

}  // namespace

void Mouse::handle(const SDL_Event& event, const Camera& camera, Battle& battle) {
    const auto ground = [&](int x, int y) {
        return camera.toGround({static_cast<double>(x), static_cast<double>(y)});
    };
    switch (event.type) {
        case SDL_MOUSEBUTTONDOWN: {
            const Vec2 p = ground(event.button.x, event.button.y);
            if (event.button.button == SDL_BUTTON_LEFT) box_ = Stroke{p, p};
            if (event.button.button == SDL_BUTTON_RIGHT) front_ = Stroke{p, p};
            break;
        }
        case SDL_MOUSEMOTION: {
            const Vec2 p = ground(event.motion.x, event.motion.y);
            if (box_) box_->to = p;
            if (front_) front_->to = p;
            break;
        }
        case SDL_MOUSEBUTTONUP:
            release(event.button.button, battle);
            break;
        case SDL_KEYDOWN:
            key(event.key.keysym.sym, battle);
            break;
        default:
            break;
    }
}

void Mouse::release(Uint8 button, Battle& battle) {
    if (button == SDL_BUTTON_LEFT && box_) {
        selected_ = battle.unitsIn(box_->from, box_->to);
        box_.reset();
    }
    if (button == SDL_BUTTON_RIGHT && front_) {
        const Stroke stroke = *front_;
        const bool click = muster::distance(stroke.from, stroke.to) < kClick;
        battle.order(selected_, click ? muster::Order::move(stroke.to)
                                      : muster::Order::moveToLine(stroke.from, stroke.to));
        front_.reset();
    }
}

void Mouse::key(SDL_Keycode code, Battle& battle) {
    switch (code) {
        case SDLK_s:
            battle.split(selected_);
            break;
        case SDLK_k:
            battle.fall(selected_);
            break;
        case SDLK_a:
            selected_ = battle.unitsIn({-1e3, -1e3}, {1e3, 1e3});
            break;
        case SDLK_ESCAPE:
            selected_.clear();
            break;
        default:
            break;
    }
}

}  // namespace game
