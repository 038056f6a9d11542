// The numbers of the C API are those of the engine.
#include "muster/c/world.h"
#include "muster/parameters.h"
#include "muster/world.h"

namespace muster::c_api {
namespace {

template <class Enum>
constexpr bool is(Enum engine, int number) {
    return static_cast<int>(engine) == number && sizeof(Enum) == 1;
}

static_assert(is(FormationKind::Square, MUSTER_FORMATION_SQUARE));
static_assert(is(FormationKind::Line, MUSTER_FORMATION_LINE));
static_assert(is(FormationKind::Column, MUSTER_FORMATION_COLUMN));
static_assert(is(FormationKind::Wedge, MUSTER_FORMATION_WEDGE));
static_assert(is(FormationKind::Ring, MUSTER_FORMATION_RING));
static_assert(is(FormationKind::Circle, MUSTER_FORMATION_CIRCLE));
static_assert(is(FormationKind::Crescent, MUSTER_FORMATION_CRESCENT));
static_assert(is(FormationKind::Pacman, MUSTER_FORMATION_PACMAN));
static_assert(is(FormationKind::Outline, MUSTER_FORMATION_OUTLINE));
static_assert(is(FormationKind::Points, MUSTER_FORMATION_POINTS));
static_assert(is(RoleArea::Front, MUSTER_ROLE_FRONT));
static_assert(is(RoleArea::Rear, MUSTER_ROLE_REAR));
static_assert(is(RoleArea::Rim, MUSTER_ROLE_RIM));
static_assert(is(RoleArea::Centre, MUSTER_ROLE_CENTRE));
static_assert(is(RoleArea::LeftFlank, MUSTER_ROLE_LEFT_FLANK));
static_assert(is(RoleArea::RightFlank, MUSTER_ROLE_RIGHT_FLANK));
static_assert(is(RoleArea::Flanks, MUSTER_ROLE_FLANKS));
static_assert(is(Driver::Muster, MUSTER_DRIVER_MUSTER));
static_assert(is(Driver::Outside, MUSTER_DRIVER_OUTSIDE));
static_assert(is(SplitBy::Ids, MUSTER_SPLIT_BY_IDS));
static_assert(is(SplitBy::Line, MUSTER_SPLIT_BY_LINE));
static_assert(is(SplitBy::Lasso, MUSTER_SPLIT_BY_LASSO));
static_assert(is(SplitBy::Shares, MUSTER_SPLIT_BY_SHARES));
static_assert(is(PartShape::AsHeld, MUSTER_PART_AS_HELD));
static_assert(is(PartShape::Smaller, MUSTER_PART_SMALLER));
static_assert(is(OrderKind::Move, MUSTER_ORDER_MOVE));
static_assert(is(OrderKind::Face, MUSTER_ORDER_FACE));
static_assert(is(OrderKind::Follow, MUSTER_ORDER_FOLLOW));
static_assert(is(OrderKind::Guard, MUSTER_ORDER_GUARD));
static_assert(is(OrderKind::Leave, MUSTER_ORDER_LEAVE));
static_assert(is(OrderKind::Wait, MUSTER_ORDER_WAIT));
static_assert(is(OrderKind::Walk, MUSTER_ORDER_WALK));
static_assert(is(ExitChoice::Quickest, MUSTER_EXIT_QUICKEST));
static_assert(is(ExitChoice::Nearest, MUSTER_EXIT_NEAREST));
static_assert(is(Manner::March, MUSTER_MANNER_MARCH));
static_assert(is(Manner::Free, MUSTER_MANNER_FREE));
static_assert(is(Manner::Continuum, MUSTER_MANNER_CONTINUUM));
static_assert(is(Turn::Wheel, MUSTER_TURN_WHEEL));
static_assert(is(Turn::Reverse, MUSTER_TURN_REVERSE));
static_assert(is(Turn::Keep, MUSTER_TURN_KEEP));
static_assert(is(Turn::Flow, MUSTER_TURN_FLOW));
static_assert(is(QueueMode::Replace, MUSTER_QUEUE_REPLACE));
static_assert(is(QueueMode::Append, MUSTER_QUEUE_APPEND));
static_assert(is(QueueMode::Insert, MUSTER_QUEUE_INSERT));
static_assert(is(QueueEdit::Cancel, MUSTER_EDIT_CANCEL));
static_assert(is(QueueEdit::Hold, MUSTER_EDIT_HOLD));
static_assert(is(QueueEdit::Resume, MUSTER_EDIT_RESUME));
static_assert(is(QueueEdit::Patrol, MUSTER_EDIT_PATROL));
static_assert(is(QueueEdit::EndPatrol, MUSTER_EDIT_END_PATROL));
static_assert(is(QueueEdit::Stop, MUSTER_EDIT_STOP));
static_assert(is(Stance::Normal, MUSTER_STANCE_NORMAL));
static_assert(is(Stance::Hold, MUSTER_STANCE_HOLD));
static_assert(is(Stance::Yield, MUSTER_STANCE_YIELD));
static_assert(is(CheckpointTrigger::Crowd, MUSTER_CHECKPOINT_CROWD));
static_assert(is(CheckpointTrigger::Mesh, MUSTER_CHECKPOINT_MESH));
static_assert(is(ControlKind::Point, MUSTER_CONTROL_POINT));
static_assert(is(ControlKind::Line, MUSTER_CONTROL_LINE));
static_assert(is(ControlKind::Area, MUSTER_CONTROL_AREA));
static_assert(is(MotionPhase::Steady, MUSTER_PHASE_STEADY));
static_assert(is(MotionPhase::Entering, MUSTER_PHASE_ENTERING));
static_assert(is(MotionPhase::Leaving, MUSTER_PHASE_LEAVING));
static_assert(is(MotionPhase::Locked, MUSTER_PHASE_LOCKED));
static_assert(is(EventKind::EnterPatch, MUSTER_EVENT_ENTER_PATCH));
static_assert(is(EventKind::LeavePatch, MUSTER_EVENT_LEAVE_PATCH));
static_assert(is(EventKind::TransitionStart, MUSTER_EVENT_TRANSITION_START));
static_assert(is(EventKind::TransitionEnd, MUSTER_EVENT_TRANSITION_END));
static_assert(is(EventKind::SingleStep, MUSTER_EVENT_SINGLE_STEP));
static_assert(is(EventKind::Collect, MUSTER_EVENT_COLLECT));
static_assert(is(EventKind::FormationChange, MUSTER_EVENT_FORMATION_CHANGE));
static_assert(is(EventKind::Swap, MUSTER_EVENT_SWAP));
static_assert(is(EventKind::Arrived, MUSTER_EVENT_ARRIVED));
static_assert(is(EventKind::Stuck, MUSTER_EVENT_STUCK));
static_assert(is(EventKind::Blocked, MUSTER_EVENT_BLOCKED));
static_assert(is(EventKind::Free, MUSTER_EVENT_FREE));
static_assert(is(EventKind::NoPath, MUSTER_EVENT_NO_PATH));
static_assert(is(EventKind::Partial, MUSTER_EVENT_PARTIAL));
static_assert(is(EventKind::OrderGiven, MUSTER_EVENT_ORDER_GIVEN));
static_assert(is(EventKind::OrderBegun, MUSTER_EVENT_ORDER_BEGUN));
static_assert(is(EventKind::OrderDone, MUSTER_EVENT_ORDER_DONE));
static_assert(is(EventKind::OrderSkipped, MUSTER_EVENT_ORDER_SKIPPED));
static_assert(is(EventKind::Passed, MUSTER_EVENT_PASSED));
static_assert(is(EventKind::GroupAdded, MUSTER_EVENT_GROUP_ADDED));
static_assert(is(EventKind::GroupRemoved, MUSTER_EVENT_GROUP_REMOVED));
static_assert(is(EventKind::Joined, MUSTER_EVENT_JOINED));
static_assert(is(EventKind::Left, MUSTER_EVENT_LEFT));
static_assert(is(EventKind::Transferred, MUSTER_EVENT_TRANSFERRED));
static_assert(is(EventKind::Exited, MUSTER_EVENT_EXITED));
static_assert(is(EventKind::Entered, MUSTER_EVENT_ENTERED));
static_assert(is(EventKind::Count, MUSTER_EVENT_COUNT));

static_assert(is(Spread::Constant, MUSTER_SPREAD_CONSTANT));
static_assert(is(Spread::Uniform, MUSTER_SPREAD_UNIFORM));
static_assert(is(Spread::Normal, MUSTER_SPREAD_NORMAL));
static_assert(is(Spread::LogNormal, MUSTER_SPREAD_LOG_NORMAL));
static_assert(is(Spread::Gamma, MUSTER_SPREAD_GAMMA));
static_assert(is(Spread::Weibull, MUSTER_SPREAD_WEIBULL));
static_assert(is(AreaKind::Exit, MUSTER_AREA_EXIT));
static_assert(is(AreaKind::Source, MUSTER_AREA_SOURCE));
static_assert(is(AreaKind::Waiting, MUSTER_AREA_WAITING));

static_assert(is(BodyBuild::Broad, MUSTER_BODY_BUILD_BROAD));
static_assert(is(BodyBuild::Narrow, MUSTER_BODY_BUILD_NARROW));
static_assert(is(MotionSet::March, MUSTER_MOTION_SET_MARCH));
static_assert(is(MotionSet::Weary, MUSTER_MOTION_SET_WEARY));

}  // namespace
}  // namespace muster::c_api

const char* muster_event_name(MusterEventKind kind) {
    return kind < MUSTER_EVENT_COUNT ? muster::eventKindName(static_cast<muster::EventKind>(kind)) : nullptr;
}
