#include "studio/gestures/mouse_mesh.h"

#include <algorithm>

#include "studio/gestures/ground_strokes.h"
#include "studio/gestures/group_lookup.h"
#include "studio/gestures/reaches.h"

namespace muster {
namespace {

constexpr double kNear = 3.0;            // A line may begin so near the mesh [m].
constexpr double kShortestLine = 0.5;    // [m]
constexpr std::size_t kAreaCorners = 6;  // Of an area, spread evenly over its loop.
constexpr std::uint8_t kDelete = 127;

}  // namespace

void MouseMesh::input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) {
    if (const auto* view = std::get_if<GroundView>(&event)) view_ = *view;
    if (const auto* key = std::get_if<KeyEvent>(&event)) this->key(*key, world, commands);
    const auto* pointer = std::get_if<PointerEvent>(&event);
    if (pointer == nullptr) return;
    const auto ground = view_.groundAt(pointer->screen);
    if (pointer->phase == PointerPhase::Down) {
        if (ground && mode_ == Mode::None && pointer->button == PointerButton::Left)
            down(*pointer, *ground, world, commands);
    } else if (mode_ != Mode::None && pointer->pointer == pointer_) {
        if (pointer->phase == PointerPhase::Move) {
            if (ground) move(*pointer, *ground, world, commands);
        } else {
            up(*pointer, world, commands);
        }
    }
}

void MouseMesh::down(const PointerEvent& event, Vec2 ground, const World& world,
                     std::vector<CommandBody>& commands) {
    pointer_ = event.pointer;
    last_ = ground;
    marks_.notice.clear();
    const double reach = std::max(0.3, metresFor(view_, event.screen, kMouseTip));
    if (event.modifiers.shift || event.modifiers.control) {
        if (!def_.shapes) return;
        group_ = groupAt(world, ground, kNear);
        if (!group_) return;
        letGo(event.time, commands);
        mode_ = event.modifiers.control ? Mode::Lasso : Mode::Band;
        marks_.stroke.assign(1, ground);
        return;
    }
    for (std::size_t i = 0; i < held_.size(); ++i) {
        if (distance(held_[i].at, ground) > 2.0 * reach) continue;
        handle_ = i;
        mode_ = Mode::Handle;
        return;
    }
    group_ = groupAt(world, ground, reach);
    if (group_) {
        letGo(event.time, commands);
        if (hands_.down(event.pointer, group_, ground, event.time, world, commands)) mode_ = Mode::Point;
    } else if (def_.splits) {
        mode_ = Mode::Stroke;
        marks_.stroke.assign(1, ground);
    }
}

void MouseMesh::move(const PointerEvent& event, Vec2 ground, const World& world,
                     std::vector<CommandBody>& commands) {
    if (mode_ == Mode::Point) hands_.move(pointer_, ground, event.time, world, commands);
    if (mode_ == Mode::Handle) {
        // With Alt the whole control goes along.
        const Vec2 step = ground - last_;
        for (std::size_t i = 0; i < held_.size(); ++i) {
            if (i != handle_ && !event.modifiers.alt) continue;
            held_[i].at += step;
            commands.emplace_back(Touch{TouchPhase::Move, held_[i].touch, held_[i].at, event.time, {}});
        }
    }
    if (mode_ == Mode::Band) marks_.stroke = {marks_.stroke.front(), ground};
    if (mode_ == Mode::Lasso || mode_ == Mode::Stroke) marks_.stroke.push_back(ground);
    last_ = ground;
}

void MouseMesh::up(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands) {
    const bool cancelled = event.phase == PointerPhase::Cancel;
    if (mode_ == Mode::Point) hands_.up(pointer_, event.time, cancelled, commands);
    std::vector<Vec2> stroke = std::move(marks_.stroke);
    marks_.stroke.clear();
    if (!cancelled && mode_ == Mode::Stroke) marks_.notice = finishStroke(world, stroke, commands);
    if (!cancelled && mode_ == Mode::Band && stroke.size() == 2 &&
        distance(stroke[0], stroke[1]) >= kShortestLine)
        make(ControlKind::Line, std::move(stroke), event.time, commands);
    else if (!cancelled && mode_ == Mode::Lasso && stroke.size() >= kAreaCorners) {
        std::vector<Vec2> corners;
        for (std::size_t i = 0; i < kAreaCorners; ++i)
            corners.push_back(stroke[i * stroke.size() / kAreaCorners]);
        make(ControlKind::Area, std::move(corners), event.time, commands);
    }
    mode_ = Mode::None;
}

void MouseMesh::make(ControlKind kind, std::vector<Vec2> points, double time,
                     std::vector<CommandBody>& commands) {
    AddControl add;
    add.group = group_;
    add.kind = kind;
    add.time = time;
    for (const Vec2 p : points) {
        held_.push_back({++lastTouch_, group_, p});
        add.touches.push_back(lastTouch_);
    }
    add.positions = std::move(points);
    commands.emplace_back(std::move(add));
}

void MouseMesh::letGo(double time, std::vector<CommandBody>& commands) {
    for (const Held& held : held_) commands.emplace_back(Touch{TouchPhase::Up, held.touch, {}, time, {}});
    held_.clear();
}

void MouseMesh::key(const KeyEvent& event, const World& world, std::vector<CommandBody>& commands) {
    if (event.key == kEscapeKey) letGo(event.time, commands);
    if (event.key != 'P' && event.key != kDelete) return;
    // The newest control of the formation that was edited last.
    const std::int32_t index = groupIndex(world, group_);
    if (index < 0) return;
    const auto controls = world.group(static_cast<std::size_t>(index)).controls;
    if (controls.empty()) return;
    if (event.key == 'P')
        commands.emplace_back(EditControl{group_, controls.back().id,
                                          !controls.back().pinned ? ControlEdit::Pin : ControlEdit::Release});
    else
        commands.emplace_back(EditControl{group_, controls.back().id, ControlEdit::Remove});
    if (event.key == kDelete) held_.clear();
}

// Forgets what the world has ended.
void MouseMesh::beforeStep(const World& world, std::vector<CommandBody>& commands) {
    hands_.beforeStep(world, commands);
    if (!held_.empty() && groupIndex(world, held_.front().group) < 0) held_.clear();
}

}  // namespace muster
