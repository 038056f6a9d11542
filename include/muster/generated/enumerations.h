// Made by schema/generate.mjs from schema/enumerations.txt: change these, not this file.
// The enumerations of definitions, orders, commands and events.
#pragma once

#include <cstddef>
#include <cstdint>

namespace muster {

/// The library of shapes.
enum class FormationKind : std::uint8_t {
    Square,    ///< A filled square.
    Line,      ///< Two ranks abreast.
    Column,    ///< Two files along the heading.
    Wedge,     ///< A filled triangle with its tip in front.
    Ring,      ///< Concentric circles round an open middle.
    Circle,    ///< A filled disc.
    Crescent,  ///< Concentric arcs, open to the front.
    Pacman,    ///< A disc with a mouth to the front.
    Outline,   ///< Any polygon with holes, scaled to hold the count at the spacing.
    Points,    ///< Explicit places; the mesh is made round them.
};

/// The build of drawn bodies.
enum class BodyBuild : std::uint8_t {
    Broad,   ///< Wide shoulders, short hair.
    Narrow,  ///< Narrow shoulders, wider hips, tied hair.
};

/// A manner of walking and jogging, with clips of its own. Standing and what patches ask for is the same in
/// all.
enum class MotionSet : std::uint8_t {
    March,  ///< Upright, with high knees and stiff arms.
    Weary,  ///< Stooped, with hanging arms and feet that are hardly lifted.
};

/// The phase of the motion that a character performs (SPEC C1, C3, C4).
enum class MotionPhase : std::uint8_t {
    Steady,    ///< It performs the motion of the ground it is on.
    Entering,  ///< It plays the transition into the motion.
    Leaving,   ///< It plays the transition out of the motion.
    Locked,    ///< It is within a single-step motion, which runs once per patch.
};

/// Kind of a control by its number of points: one, two, or three and more.
enum class ControlKind : std::uint8_t {
    Point,  ///< One point.
    Line,   ///< Two points.
    Area,   ///< Three points and more.
};

/// What an area does.
enum class AreaKind : std::uint8_t {
    Exit,     ///< People who are to leave by it go there, and leave the world in it.
    Source,   ///< People come into the world in it, where there is room.
    Waiting,  ///< People who are to wait in it spread in it and stand.
};

/// What stands or lies in the place.
enum class ThingKind : std::uint8_t {
    Obstacle,    ///< Something in the way.
    Patch,       ///< Ground on which another motion is performed.
    Item,        ///< Something to collect.
    Checkpoint,  ///< Where a formation is asked for.
    Area,        ///< An exit, a source or a waiting area.
};

/// What passes a checkpoint.
enum class CheckpointTrigger : std::uint8_t {
    Crowd,  ///< A share of the characters has been in it, or, up to a half, their middle is.
    Mesh,   ///< The centre of the group's mesh is in it.
};

/// How a number is spread over persons.
enum class Spread : std::uint8_t {
    Constant,   ///< All have `a`.
    Uniform,    ///< Evenly from `a` to `b`.
    Normal,     ///< Mean `a`, standard deviation `b`.
    LogNormal,  ///< Its logarithm has the mean `a` and the standard deviation `b`.
    Gamma,      ///< Shape `a`, at most 10,000, scale `b`.
    Weibull,    ///< Scale `a`, shape `b`.
};

/// Parts of a formation.
enum class RoleArea : std::uint8_t {
    Front,       ///< The foremost places.
    Rear,        ///< The hindmost.
    Rim,         ///< Those nearest to the outline.
    Centre,      ///< Those nearest to the middle.
    LeftFlank,   ///< Those farthest to the left.
    RightFlank,  ///< Those farthest to the right.
    Flanks,      ///< Those farthest from the middle line.
};

/// Who moves a character.
enum class Driver : std::uint8_t {
    Muster,   ///< Steering and contacts.
    Outside,  ///< Somebody else, by WriteMotion. Others keep clear of it.
};

/// How a group is divided.
enum class SplitBy : std::uint8_t {
    Ids,     ///< Those with the given ids leave.
    Line,    ///< Those to the left of a line leave, as their places lie.
    Lasso,   ///< Those whose places lie in a polygon leave.
    Shares,  ///< Parts of given shares, front to back, or left to right.
};

/// The formation of parts.
enum class PartShape : std::uint8_t {
    AsHeld,   ///< The places that they held.
    Smaller,  ///< The shape of the whole, for fewer.
};

/// What an order asks for.
enum class OrderKind : std::uint8_t {
    Move,    ///< Go to `target`, by `route` if one is given.
    Face,    ///< Turn to `facing` where it stands.
    Follow,  ///< Keep at `offset` from a group or a character, until the next order.
    Guard,   ///< Stand round a rectangle, which may move, until the next order.
    Leave,   ///< Leave the world by exits. Nobody has a place meanwhile.
    Wait,    ///< Go to a waiting area and stand there. Nobody has a place meanwhile.
    Walk,    ///< Walk on towards `facing` without end. Nobody has a place meanwhile.
};

/// By which exit each leaves.
enum class ExitChoice : std::uint8_t {
    Quickest,  ///< Where it will have left soonest, with the wait before it.
    Nearest,   ///< The one with the quickest way.
};

/// How a group goes to its target.
enum class Manner : std::uint8_t {
    March,  ///< In formation: the shape goes along the way and waits for the last.
    Free,   ///< Each by the shortest way; the shape at the end.
    /// All to `target` itself, by one cost field that the crowd raises (Treuille et al. 2006): no shape, no
    /// places. Those who have come near stand where there is room.
    Continuum,
};

/// How a marching formation takes its turns.
enum class Turn : std::uint8_t {
    Wheel,  ///< It faces along its way, and turns at a bounded rate.
    /// As Wheel, but where the way leads back its rear becomes its front, and nobody changes files.
    Reverse,
    Keep,  ///< It faces one way until it has arrived, and then turns to `facing`.
    /// Everybody heads for the place that is nearest for all, and the formation flows where the way narrows.
    /// In the open nothing arrives sooner.
    Flow,
};

/// What a finger or a pointer does.
enum class TouchPhase : std::uint8_t {
    Down,    ///< It comes down.
    Move,    ///< It moves.
    Up,      ///< It lifts.
    Cancel,  ///< It is lost: its control ends at once.
};

/// Changes of a control.
enum class ControlEdit : std::uint8_t {
    Pin,      ///< It stays at the end of its trajectory.
    Release,  ///< It is no longer pinned.
    Remove,   ///< It ends at once.
};

/// Where a new order stands in a queue.
enum class QueueMode : std::uint8_t {
    Replace,  ///< It takes the place of all others.
    Append,   ///< It comes last.
    Insert,   ///< It comes before the order of a given index.
};

/// Changes of a queue.
enum class QueueEdit : std::uint8_t {
    Cancel,     ///< Drops one order, or all.
    Hold,       ///< The group waits where it is; the queue stays.
    Resume,     ///< It goes on.
    Patrol,     ///< Orders that are done come last again.
    EndPatrol,  ///< They do not.
    Stop,       ///< Drops all orders, ends all controls, and the group stands where it is.
};

/// Who makes room where groups meet.
enum class Stance : std::uint8_t {
    Normal,  ///< Each as much as the other.
    Hold,    ///< It holds its ground: others go round it.
    Yield,   ///< It makes room for others.
};

/// Whether a character stands in its place, and if not, what keeps it from there. Of a place it is said where
/// the formation wants it: people stand beside it where they cannot stand there.
enum class Standing : std::uint8_t {
    InPlace,   ///< It stands within 0.5 m of where its formation wants it.
    OnTheWay,  ///< It is on its way, or its place is.
    Held,      ///< Its group was ordered to hold, or it has not set out yet.
    Stuck,     ///< It has not got on for 5 s.
    Outside,   ///< Its place lies outside the ground.
    Obstacle,  ///< Its place lies in an obstacle.
    Narrow,    ///< Its place is too narrow for its body.
    NoWay,     ///< No way leads to its place.
    Crowded,   ///< Others have taken the room at its place.
    Count,     ///< Their number.
};

/// Kinds of events. Those from Arrived on tell how orders get on and how groups change; each from Arrived to
/// Partial comes once per order and version of the ground. An order is a pose, a formation, a count or a
/// drawn way; the ground changes with every command that changes obstacles or patches.
enum class EventKind : std::uint8_t {
    EnterPatch,       ///< `value` is the id of the patch.
    LeavePatch,       ///< `value` is the id of the patch.
    TransitionStart,  ///< A transition into or out of a motion begins; `value` is the motion id.
    TransitionEnd,    ///< A transition has ended; `value` is the motion id.
    SingleStep,       ///< A jump or climb begins; `value` is the motion id.
    Collect,          ///< An item was collected; `value` is the index of the item.
    FormationChange,  ///< A group has another formation; `subject` is the id of the group.
    Swap,             ///< A character's place changed without a command; `value` is the new place.
    /// All of a group's characters that have a place are within 0.5 m of it for 1 s, and the places stand
    /// where the order wants them; `value` is their number.
    Arrived,
    /// A character is not at its place and has moved less than 0.25 m over the last 5 s, and not in a queue
    /// that moves on; `value` is the place. Raised again only once it has moved.
    Stuck,
    /// The ground cut off the way of `value` characters of a group, or for 2 s a moving obstacle did, as a
    /// gate that closes. One that only passes gives no event.
    Blocked,
    Free,  ///< All of a group have their way again; `value` is how many had none.
    /// No place of the group's order can be reached, or not by its largest members, who stay behind; `value`
    /// is the number of those concerned.
    NoPath,
    Partial,       ///< `value` places of the group's order cannot be reached; the others can.
    OrderGiven,    ///< A group was given the order of id `value`.
    OrderBegun,    ///< It begins the order of id `value`.
    OrderDone,     ///< It has carried out the order of id `value`.
    OrderSkipped,  ///< It passes over the order of id `value`, whose target cannot be reached.
    Passed,        ///< A group has passed the checkpoint of index `value`.
    GroupAdded,    ///< A group is new; `value` is the id of the group that it was split off, 0 for none.
    /// A group has ended; `value` is the id of the group that it was merged into, 0 for none.
    GroupRemoved,
    Joined,       ///< A character is new; `value` is the id of its group.
    Left,         ///< A character has left the world; `value` is the id of its group.
    Transferred,  ///< A character has changed groups; `value` is the id of its new group.
    Exited,       ///< A character has left the world by an exit; `value` is the id of that area.
    Entered,      ///< A character has come into the world by a source; `value` is the id of that area.
    Count,        ///< Their number.
};

/// The last value of an enumeration.
template <class Enum>
inline constexpr Enum kLastOf{};
template <>
inline constexpr FormationKind kLastOf<FormationKind> = FormationKind::Points;
template <>
inline constexpr BodyBuild kLastOf<BodyBuild> = BodyBuild::Narrow;
template <>
inline constexpr MotionSet kLastOf<MotionSet> = MotionSet::Weary;
template <>
inline constexpr MotionPhase kLastOf<MotionPhase> = MotionPhase::Locked;
template <>
inline constexpr ControlKind kLastOf<ControlKind> = ControlKind::Area;
template <>
inline constexpr AreaKind kLastOf<AreaKind> = AreaKind::Waiting;
template <>
inline constexpr ThingKind kLastOf<ThingKind> = ThingKind::Area;
template <>
inline constexpr CheckpointTrigger kLastOf<CheckpointTrigger> = CheckpointTrigger::Mesh;
template <>
inline constexpr Spread kLastOf<Spread> = Spread::Weibull;
template <>
inline constexpr RoleArea kLastOf<RoleArea> = RoleArea::Flanks;
template <>
inline constexpr Driver kLastOf<Driver> = Driver::Outside;
template <>
inline constexpr SplitBy kLastOf<SplitBy> = SplitBy::Shares;
template <>
inline constexpr PartShape kLastOf<PartShape> = PartShape::Smaller;
template <>
inline constexpr OrderKind kLastOf<OrderKind> = OrderKind::Walk;
template <>
inline constexpr ExitChoice kLastOf<ExitChoice> = ExitChoice::Nearest;
template <>
inline constexpr Manner kLastOf<Manner> = Manner::Continuum;
template <>
inline constexpr Turn kLastOf<Turn> = Turn::Flow;
template <>
inline constexpr TouchPhase kLastOf<TouchPhase> = TouchPhase::Cancel;
template <>
inline constexpr ControlEdit kLastOf<ControlEdit> = ControlEdit::Remove;
template <>
inline constexpr QueueMode kLastOf<QueueMode> = QueueMode::Insert;
template <>
inline constexpr QueueEdit kLastOf<QueueEdit> = QueueEdit::Stop;
template <>
inline constexpr Stance kLastOf<Stance> = Stance::Yield;
template <>
inline constexpr Standing kLastOf<Standing> = Standing::Crowded;
template <>
inline constexpr EventKind kLastOf<EventKind> = EventKind::Entered;
/// How many values an enumeration has.
template <class Enum>
inline constexpr std::size_t kCountOf = static_cast<std::size_t>(kLastOf<Enum>) + 1;

}  // namespace muster
