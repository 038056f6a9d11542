#include "studio/gestures/mesh_hands.h"

#include <algorithm>
#include <cmath>

#include "studio/gestures/group_lookup.h"

namespace muster {
namespace {

constexpr double kTearStretch = 1.6;      // Of the distance at which both fingers came down.
constexpr double kTearSpacings = 2.0;     // More than that distance, in spacings.
constexpr double kWidenTime = 0.15;       // Between two changes of a formation's width [s].
constexpr double kWidenReach = 3.0;       // The middle of the fingers is so near the people's [m].
constexpr double kFilesHysteresis = 0.7;  // The number of files changes once it is wrong by so much.

// Perpendicular bisector of two points.
std::vector<Vec2> bisector(Vec2 a, Vec2 b) {
    const Vec2 middle = (a + b) * 0.5;
    const Vec2 across = perpendicular(normalized(b - a, {1.0, 0.0}));
    return {middle - across, middle + across};
}

// How many files a formation should have for two fingers that are `span` apart and came down `first` apart
// [m]; 0 for as many as it has.
std::int32_t filesFor(const GroupDef& def, const Pose& pose, Vec2 span, Vec2 first) {
    const double fit = 1.0 + length(span) / def.formation.spacing;
    const double n = def.count;
    const double now = def.formation.files > 0 ? def.formation.files : std::ceil(std::sqrt(n));
    // Fingers beside each other set the files; fingers behind each other the ranks.
    const Vec2 local = pose.rotation.applyInverse(first);
    const bool abreast = std::abs(local.y) >= std::abs(local.x);
    const double held = abreast ? now : std::ceil(n / now);
    if (std::abs(std::clamp(fit, 1.0, n) - held) < kFilesHysteresis) return 0;
    const double wanted = std::clamp(std::floor(fit + 0.5), 1.0, n);
    const auto files = static_cast<std::int32_t>(abreast ? wanted : std::ceil(n / wanted));
    return files == static_cast<std::int32_t>(now) ? 0 : files;
}

}  // namespace

MeshHands::Finger* MeshHands::find(std::uint32_t pointer) {
    const auto found = std::find_if(fingers_.begin(), fingers_.end(),
                                    [&](const Finger& f) { return f.pointer == pointer; });
    return found == fingers_.end() ? nullptr : &*found;
}

bool MeshHands::has(std::uint32_t pointer) const {
    return std::any_of(fingers_.begin(), fingers_.end(),
                       [&](const Finger& f) { return f.pointer == pointer; });
}

std::size_t MeshHands::count(GroupId group) const {
    return static_cast<std::size_t>(
        std::count_if(fingers_.begin(), fingers_.end(), [&](const Finger& f) { return f.group == group; }));
}

// A new finger takes a formation over: ways that were drawn before are no longer followed.
void MeshHands::endOldWays(GroupId group, const World& world, std::vector<CommandBody>& commands) const {
    const std::int32_t index = groupIndex(world, group);
    if (index < 0) return;
    for (const Control& control : world.group(static_cast<std::size_t>(index)).controls) {
        const bool lifted = std::none_of(control.points.begin(), control.points.end(),
                                         [](const ControlPoint& p) { return p.down; });
        if (control.client == def_.client && lifted && !control.pinned)
            commands.emplace_back(EditControl{group, control.id, ControlEdit::Remove});
    }
}

bool MeshHands::down(std::uint32_t pointer, GroupId group, Vec2 ground, double time, const World& world,
                     std::vector<CommandBody>& commands) {
    if (def_.oneFinger && !fingers_.empty()) return false;
    const double window = world.parameters().input.window;
    Finger finger{pointer, ++lastTouch_, group, ground, ground, time, false};
    bool alone = true;
    for (Finger& other : fingers_) {
        if (other.group != group) continue;
        alone = false;
        if (time - other.time > window) continue;
        if (!def_.shapes) return false;
        other.paired = finger.paired = true;
    }
    if (alone) {
        endOldWays(group, world, commands);
        const std::int32_t index = groupIndex(world, group);
        if (index >= 0 && !world.group(static_cast<std::size_t>(index)).orders.empty())
            commands.emplace_back(EditQueue{group, QueueEdit::Stop, 0});
    }
    commands.emplace_back(Touch{TouchPhase::Down, finger.touch, ground, time, group});
    fingers_.push_back(finger);
    return true;
}

void MeshHands::move(std::uint32_t pointer, Vec2 ground, double time, const World& world,
                     std::vector<CommandBody>& commands) {
    Finger* finger = find(pointer);
    if (finger == nullptr) return;
    finger->at = ground;
    if (finger->held) commands.emplace_back(Touch{TouchPhase::Move, finger->touch, ground, time, {}});
    if (def_.shapes && finger->paired) spread(*finger, world, commands);
    if (def_.splits && !finger->paired) tear(*finger, world, commands);
}

void MeshHands::up(std::uint32_t pointer, double time, bool cancelled, std::vector<CommandBody>& commands) {
    const Finger* finger = find(pointer);
    if (finger == nullptr) return;
    if (finger->held && cancelled)
        commands.emplace_back(Touch{TouchPhase::Cancel, finger->touch, {}, 0.0, {}});
    else if (finger->held)
        commands.emplace_back(Touch{TouchPhase::Up, finger->touch, {}, time, {}});
    fingers_.erase(fingers_.begin() + (finger - fingers_.data()));
}

// The front gets as many files as fit between two fingers, so that people keep their distance from each
// other.
void MeshHands::spread(const Finger& moved, const World& world, std::vector<CommandBody>& commands) {
    if (count(moved.group) != 2 || !moved.held) return;
    Finger& other = *std::find_if(fingers_.begin(), fingers_.end(), [&](const Finger& f) {
        return f.group == moved.group && f.pointer != moved.pointer;
    });
    const std::int32_t index = groupIndex(world, moved.group);
    if (index < 0 || !other.paired || world.time() < widenedTime_ + kWidenTime) return;
    const GroupDef def = world.groupDef(static_cast<std::size_t>(index));
    if (def.formation.kind != FormationKind::Square || def.count < 2) return;
    const Pose& pose = world.group(static_cast<std::size_t>(index)).pose;
    // Fingers that have drawn a way ahead of the crowd no longer hold its sides.
    const Vec2 middle = (moved.at + other.at) * 0.5;
    if (distance(middle, middleOf(world, index)) > kWidenReach) return;
    const std::int32_t files = filesFor(def, pose, moved.at - other.at, moved.from - other.from);
    if (files <= 0) return;
    ChangeGroup change{.group = moved.group, .formation = def.formation};
    change.formation->files = files;
    commands.emplace_back(std::move(change));
    commands.emplace_back(Touch{TouchPhase::Cancel, moved.touch, {}, 0.0, {}});  // The line ends as a whole.
    for (Finger& finger : fingers_) {
        if (finger.group != moved.group) continue;
        finger.held = false;
    }
    widenedStep_ = world.stepCount() + 1;
    widenedTime_ = world.time();
}

// Fingers take the ends of a formation that was widened.
void MeshHands::takeAgain(const World& world, std::vector<CommandBody>& commands) {
    if (widenedStep_ == 0 || world.stepCount() < widenedStep_) return;
    widenedStep_ = 0;
    AddControl line;
    line.kind = ControlKind::Line;
    line.time = world.time();
    for (Finger& finger : fingers_) {
        if (finger.held) continue;
        finger.held = true;
        finger.touch = ++lastTouch_;
        line.group = finger.group;
        line.touches.push_back(finger.touch);
        line.positions.push_back(finger.at);
    }
    if (line.touches.size() == 1)
        commands.emplace_back(
            Touch{TouchPhase::Down, line.touches[0], line.positions[0], line.time, line.group});
    if (line.touches.size() == 2) commands.emplace_back(std::move(line));
}

// Two fingers that came down one after the other tear a formation once they are far enough apart.
void MeshHands::tear(const Finger& moved, const World& world, std::vector<CommandBody>& commands) {
    // In the step after, fingers do not know their parts yet.
    if (tornStep_ != 0 && world.stepCount() <= tornStep_) return;
    for (const Finger& other : fingers_) {
        if (other.group != moved.group || other.pointer == moved.pointer || other.paired) continue;
        const std::int32_t index = groupIndex(world, moved.group);
        if (index < 0) return;
        const double spacing = world.groupDef(static_cast<std::size_t>(index)).formation.spacing;
        const double first = distance(moved.from, other.from);
        const double apart = distance(moved.at, other.at);
        if (apart < kTearStretch * first || apart < first + kTearSpacings * spacing) continue;
        SplitGroup split;
        split.group = moved.group;
        split.by = SplitBy::Line;
        split.points = bisector(moved.from, other.from);
        // The fingers came down on the formation as it stood then; it has gone on with them.
        const Vec2 gone = (moved.at + other.at - moved.from - other.from) * 0.5;
        const Vec2 people = middleOf(world, index);
        const Vec2 middle = (moved.from + other.from) * 0.5;
        const Vec2 shift = clampLength(gone, distance(people, middle));
        for (Vec2& p : split.points) p += shift;
        commands.emplace_back(std::move(split));
        tornStep_ = world.stepCount() + 1;
        return;
    }
}

void MeshHands::beforeStep(const World& world, std::vector<CommandBody>& commands) {
    takeAgain(world, commands);
    for (Finger& finger : fingers_) {
        for (std::size_t g = 0; g < world.groupCount(); ++g) {
            const GroupView group = world.group(g);
            for (const Control& control : group.controls)
                for (const ControlPoint& point : control.points)
                    if (control.client == def_.client && point.down && point.touch == finger.touch &&
                        finger.group != group.id) {
                        finger.group = group.id;
                        finger.from = finger.at;
                    }
        }
    }
}

}  // namespace muster
