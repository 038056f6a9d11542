// Directing a crowd with fingers.
#pragma once

#include <cstdint>
#include <vector>

#include "studio/gestures/control_scheme.h"
#include "studio/gestures/mesh_hands.h"
#include "studio/gestures/sender.h"

namespace muster {

/// Fingers on formations move, bend, widen and divide them; strokes on free ground cut and join them; two
/// taps where nobody stands call whoever is nearest.
class TouchScheme final : public ControlScheme {
public:
    TouchScheme(const SchemeDef& def, std::uint32_t client)
        : def_(def), hands_({client, def.oneFinger, def.shapes, def.splits}) {}

    void input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) override;
    void beforeStep(const World& world, std::vector<CommandBody>& commands) override;
    const SchemeMarks& marks() const override { return marks_; }
    bool busy() const override { return hands_.any() || strokeBy_ != 0 || sender_.busy(); }

private:
    /// A finger that has just come down and not moved.
    struct Press {
        std::uint32_t pointer = 0;
        Vec2 screen;
        double time = 0.0;
        GroupId group;
        Vec2 ground;
        bool waits = false;  ///< It has not taken hold of its formation yet.
    };

    /// A finger that has come down and up again; no group where nobody stands.
    struct Tap {
        GroupId group;
        Vec2 screen;
        double time = -1e9;
    };

    void down(const PointerEvent& event, Vec2 ground, const World& world, std::vector<CommandBody>& commands);
    void takeHold(const Press& press, double time, const World& world, std::vector<CommandBody>& commands);
    void up(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands);
    void tapped(const PointerEvent& event, GroupId group, const World& world,
                std::vector<CommandBody>& commands);
    void squareAgain(GroupId group, const World& world, std::vector<CommandBody>& commands) const;
    void call(Vec2 screen, const World& world, std::vector<CommandBody>& commands);

    SchemeDef def_;
    MeshHands hands_;
    SchemeMarks marks_;
    GroundView view_;
    std::uint32_t strokeBy_ = 0;  // Pointer that draws on free ground, and 1; 0 for none.
    std::vector<Press> presses_;
    Tap lastTap_;
    Sender sender_{SchemeMovement::Free};
};

}  // namespace muster
