// The mesh by one mouse and keys (SPEC U7).
#pragma once

#include <cstdint>
#include <vector>

#include "studio/gestures/control_scheme.h"
#include "studio/gestures/mesh_hands.h"

namespace muster {

/// A drag moves a point; with Shift it draws a line, with Ctrl the loop of an area; both can be dragged then.
/// A drag on free ground cuts or joins. P pins, Delete removes, Escape lets all go.
class MouseMesh final : public ControlScheme {
public:
    MouseMesh(const SchemeDef& def, std::uint32_t client) : def_(def), hands_({client, true, false, false}) {}

    void input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) override;
    void beforeStep(const World& world, std::vector<CommandBody>& commands) override;
    const SchemeMarks& marks() const override { return marks_; }
    bool busy() const override { return mode_ != Mode::None; }

private:
    /// What the button that is down does.
    enum class Mode : std::uint8_t { None, Point, Handle, Band, Lasso, Stroke };
    /// A finger of a control that was drawn whole.
    struct Held {
        std::uint32_t touch = 0;
        GroupId group;
        Vec2 at;
    };

    void down(const PointerEvent& event, Vec2 ground, const World& world, std::vector<CommandBody>& commands);
    void move(const PointerEvent& event, Vec2 ground, const World& world, std::vector<CommandBody>& commands);
    void up(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands);
    void key(const KeyEvent& event, const World& world, std::vector<CommandBody>& commands);
    void make(ControlKind kind, std::vector<Vec2> points, double time, std::vector<CommandBody>& commands);
    void letGo(double time, std::vector<CommandBody>& commands);

    SchemeDef def_;
    MeshHands hands_;
    SchemeMarks marks_;
    GroundView view_;
    Mode mode_ = Mode::None;
    std::uint32_t pointer_ = 0;
    GroupId group_;           // That is being edited.
    Vec2 last_;               // Where the mouse was [m].
    std::size_t handle_ = 0;  // Of `held_`, that is dragged.
    std::vector<Held> held_;
    std::uint32_t lastTouch_ = 1u << 20;  // Beyond the touches of `hands_`.
};

}  // namespace muster
