// Selecting characters and sending them to points with a mouse: the paper's figure 12, and what strategy
// players expect.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "studio/gestures/control_scheme.h"
#include "studio/gestures/sender.h"

namespace muster {

/// Both mouse schemes without a mesh.
class MouseStrategy final : public ControlScheme {
public:
    explicit MouseStrategy(const SchemeDef& def) : def_(def), sender_(def.movement) {}

    void input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) override;
    void beforeStep(const World& world, std::vector<CommandBody>& commands) override;
    const SchemeMarks& marks() const override { return marks_; }
    bool busy() const override { return down_ || sender_.busy(); }

private:
    void pointer(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands);
    void key(const KeyEvent& event, const World& world, std::vector<CommandBody>& commands);
    void released(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands);
    void clicked(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands);
    void pick(const PointerEvent& event, const World& world);
    void choose(std::vector<std::uint32_t> ids, const Modifiers& modifiers);
    void send(const PointerEvent& event, const World& world, bool add, std::vector<CommandBody>& commands);
    bool paper() const { return def_.kind == SchemeKind::MousePaper; }
    PointerButton boxButton() const { return paper() ? PointerButton::Right : PointerButton::Left; }

    SchemeDef def_;
    Sender sender_;
    SchemeMarks marks_;
    GroundView view_;
    bool down_ = false;
    bool drags_ = false;                               // It has moved farther than a click.
    PointerEvent from_;                                // Where the button went down.
    double lastClick_ = -1e9;                          // Time of the last click on a character [s]...
    Vec2 lastClickAt_;                                 // ...and where it was [px].
    std::array<std::vector<std::uint32_t>, 10> kept_;  // Control groups.
};

}  // namespace muster
