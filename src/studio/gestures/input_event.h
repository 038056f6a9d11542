// What a person does with fingers, mouse and keys, as raw events: the input of control schemes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "muster/vec2.h"

namespace muster {

/// What happens to a finger, a pen or a mouse button.
enum class PointerPhase : std::uint8_t { Down, Move, Up, Cancel };

/// What points.
enum class PointerDevice : std::uint8_t { Touch, Pen, Mouse };

/// Buttons of a mouse; fingers and pens have the left one.
enum class PointerButton : std::uint8_t { Left, Middle, Right };

/// Keys that are held meanwhile, as bits.
struct Modifiers {
    bool shift = false;    ///< Shift.
    bool control = false;  ///< Ctrl, or the command key.
    bool alt = false;      ///< Alt.

    /// Lets an archive read or write them.
    template <class Archive>
    void visit(Archive& archive) {
        archive(shift, control, alt);
    }
    friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

/// One raw event of a pointer. A mouse that moves without a button sends none.
struct PointerEvent {
    PointerPhase phase = PointerPhase::Down;      ///< What happens.
    PointerDevice device = PointerDevice::Touch;  ///< What points.
    PointerButton button = PointerButton::Left;   ///< The button that went down.
    std::uint32_t pointer = 0;                    ///< Number of the finger; the same from Down to Up.
    Vec2 screen;                                  ///< From the upper left corner of the view [px].
    double time = 0.0;                            ///< World time stamp [s].
    Modifiers modifiers;                          ///< Keys held.

    /// Lets an archive read or write the event.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, device, button, pointer, screen, time, modifiers);
    }
    friend bool operator==(const PointerEvent&, const PointerEvent&) = default;
};

/// The key Escape, as KeyEvent::key.
inline constexpr std::uint8_t kEscapeKey = 27;

/// A key goes down.
struct KeyEvent {
    /// The character on it: '0' to '9', 'A' to 'Z', 27 for Escape, 127 for Delete.
    std::uint8_t key = 0;
    double time = 0.0;    ///< World time stamp [s].
    Modifiers modifiers;  ///< Keys held.

    /// Lets an archive read or write the event.
    template <class Archive>
    void visit(Archive& archive) {
        archive(key, time, modifiers);
    }
    friend bool operator==(const KeyEvent&, const KeyEvent&) = default;
};

/// How the ground is seen: a plane seen by any camera without distortion.
struct GroundView {
    /// Row-major matrix from (x, y, 1) on the ground [m] to homogeneous pixels, invertible.
    std::array<double, 9> toScreen{1, 0, 0, 0, 1, 0, 0, 0, 1};
    double width = 1920.0;       ///< Of the view [px].
    double height = 1080.0;      ///< Of the view [px].
    double mmPerPixel = 0.2767;  ///< Of the display; that of a 24-inch display with 1920 pixels a row.

    /// A view from straight above: `middle` [m] in the middle, y upwards.
    static GroundView fromAbove(Vec2 middle, double pixelsPerMetre, double width, double height,
                                double mmPerPixel);
    /// Where a point of the ground is seen [px]; none where the camera does not see it.
    std::optional<Vec2> screenOf(Vec2 ground) const;
    /// Which point of the ground is seen there [m]; none above the horizon.
    std::optional<Vec2> groundAt(Vec2 screen) const;
    /// Whether all numbers are finite and the matrix can be inverted.
    bool valid() const;

    /// Lets an archive read or write the view.
    template <class Archive>
    void visit(Archive& archive) {
        archive(toScreen, width, height, mmPerPixel);
    }
    friend bool operator==(const GroundView&, const GroundView&) = default;
};

/// One raw input. The order of alternatives is part of the format of recorded inputs: append only.
using InputEvent = std::variant<PointerEvent, KeyEvent, GroundView>;

}  // namespace muster
