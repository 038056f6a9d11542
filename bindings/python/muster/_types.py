"""Definitions, commands, orders and what is read of worlds, as plain data. Made by schema/generate.mjs: change what is declared
there, not this file.

Points are pairs (x, y) in metres, x to the right and y forward; wherever a list of points stands, an array of shape (n, 2) is taken
too. Ids are numbers, 0 for none. A value of an enumeration may be given as its word: `FormationDef(kind="wedge")`.
Ranges are checked where the engine gets the data, and a failure names the field.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Union

from . import _core

Vec2 = tuple[float, float]
Box = tuple[Vec2, Vec2]

__all__ = [
    "AddCharacters",
    "AddCheckpoint",
    "AddControl",
    "AddGroup",
    "AddItem",
    "AddObstacle",
    "AddPatch",
    "AreaCount",
    "AreaDef",
    "AreaKind",
    "Arrivals",
    "Body",
    "BodyBuild",
    "Box",
    "CameraKey",
    "ChangeCharacters",
    "ChangeCheckpoint",
    "ChangeGroup",
    "ChangeItem",
    "ChangeObstacle",
    "ChangePatch",
    "Checkpoint",
    "CheckpointTrigger",
    "ClipFacts",
    "ClipPart",
    "ClockPoint",
    "ColourGroup",
    "Command",
    "CommandBody",
    "Conduct",
    "ContactReport",
    "Control",
    "ControlEdit",
    "ControlKind",
    "ControlPoint",
    "DepartureFigures",
    "Distribution",
    "Driver",
    "EditControl",
    "EditQueue",
    "Event",
    "EventKind",
    "ExitChoice",
    "ExitFigures",
    "FormationCheckpointDef",
    "FormationDef",
    "FormationKind",
    "GiveOrder",
    "GroupColour",
    "GroupDef",
    "GroupLook",
    "HashMark",
    "ItemDef",
    "LookPart",
    "Manner",
    "MapDef",
    "MapGrid",
    "MapGround",
    "MergeGroups",
    "MeshPoint",
    "MotionPhase",
    "MotionSet",
    "NameGroup",
    "ObstacleDef",
    "Order",
    "OrderForecast",
    "OrderKind",
    "PartShape",
    "PatchDef",
    "PathPin",
    "PeopleDef",
    "PinControl",
    "PlaceGroup",
    "PolygonWithHoles",
    "PutArea",
    "PutThing",
    "QueueEdit",
    "QueueMode",
    "QueuedOrder",
    "ReleaseClient",
    "RemoveArea",
    "RemoveCharacters",
    "RemoveCheckpoint",
    "RemoveControl",
    "RemoveGroup",
    "RemoveItem",
    "RemoveObstacle",
    "RemovePatch",
    "RemoveThing",
    "ReplayReport",
    "ReverseQueue",
    "RoleArea",
    "RoleDef",
    "RunFigures",
    "SetAppearance",
    "SetBodies",
    "SetConduct",
    "SetCount",
    "SetDemands",
    "SetDriver",
    "SetFormation",
    "SetParameter",
    "SetPeople",
    "SetPose",
    "SetRoles",
    "SourceFigures",
    "SpeedPiece",
    "SplitBy",
    "SplitGroup",
    "Spread",
    "Stance",
    "Standing",
    "TakeAbout",
    "TakeEdit",
    "TakeEvent",
    "ThingKind",
    "TimedPath",
    "Touch",
    "TouchCancel",
    "TouchDown",
    "TouchMove",
    "TouchPhase",
    "TouchUp",
    "TransferCharacters",
    "Turn",
    "Vec2",
    "WalkTotals",
    "Waypoint",
    "WorldDef",
    "WriteMotion",
]


class FormationKind(str, Enum):
    """The library of shapes.

    SQUARE: A filled square.
    LINE: Two ranks abreast.
    COLUMN: Two files along the heading.
    WEDGE: A filled triangle with its tip in front.
    RING: Concentric circles round an open middle.
    CIRCLE: A filled disc.
    CRESCENT: Concentric arcs, open to the front.
    PACMAN: A disc with a mouth to the front.
    OUTLINE: Any polygon with holes, scaled to hold the count at the spacing.
    POINTS: Explicit places; the mesh is made round them.
    """

    SQUARE = "square"
    LINE = "line"
    COLUMN = "column"
    WEDGE = "wedge"
    RING = "ring"
    CIRCLE = "circle"
    CRESCENT = "crescent"
    PACMAN = "pacman"
    OUTLINE = "outline"
    POINTS = "points"


class BodyBuild(str, Enum):
    """The build of drawn bodies.

    BROAD: Wide shoulders, short hair.
    NARROW: Narrow shoulders, wider hips, tied hair.
    """

    BROAD = "broad"
    NARROW = "narrow"


class MotionSet(str, Enum):
    """A manner of walking and jogging, with clips of its own. Standing and what patches ask for is the same in all.

    MARCH: Upright, with high knees and stiff arms.
    WEARY: Stooped, with hanging arms and feet that are hardly lifted.
    """

    MARCH = "march"
    WEARY = "weary"


class MotionPhase(str, Enum):
    """The phase of the motion that a character performs (SPEC C1, C3, C4).

    STEADY: It performs the motion of the ground it is on.
    ENTERING: It plays the transition into the motion.
    LEAVING: It plays the transition out of the motion.
    LOCKED: It is within a single-step motion, which runs once per patch.
    """

    STEADY = "steady"
    ENTERING = "entering"
    LEAVING = "leaving"
    LOCKED = "locked"


class ControlKind(str, Enum):
    """Kind of a control by its number of points: one, two, or three and more.

    POINT: One point.
    LINE: Two points.
    AREA: Three points and more.
    """

    POINT = "point"
    LINE = "line"
    AREA = "area"


class AreaKind(str, Enum):
    """What an area does.

    EXIT: People who are to leave by it go there, and leave the world in it.
    SOURCE: People come into the world in it, where there is room.
    WAITING: People who are to wait in it spread in it and stand.
    """

    EXIT = "exit"
    SOURCE = "source"
    WAITING = "waiting"


class ThingKind(str, Enum):
    """What stands or lies in the place.

    OBSTACLE: Something in the way.
    PATCH: Ground on which another motion is performed.
    ITEM: Something to collect.
    CHECKPOINT: Where a formation is asked for.
    AREA: An exit, a source or a waiting area.
    """

    OBSTACLE = "obstacle"
    PATCH = "patch"
    ITEM = "item"
    CHECKPOINT = "checkpoint"
    AREA = "area"


class CheckpointTrigger(str, Enum):
    """What passes a checkpoint.

    CROWD: A share of the characters has been in it, or, up to a half, their middle is.
    MESH: The centre of the group's mesh is in it.
    """

    CROWD = "crowd"
    MESH = "mesh"


class Spread(str, Enum):
    """How a number is spread over persons.

    CONSTANT: All have `a`.
    UNIFORM: Evenly from `a` to `b`.
    NORMAL: Mean `a`, standard deviation `b`.
    LOG_NORMAL: Its logarithm has the mean `a` and the standard deviation `b`.
    GAMMA: Shape `a`, at most 10,000, scale `b`.
    WEIBULL: Scale `a`, shape `b`.
    """

    CONSTANT = "constant"
    UNIFORM = "uniform"
    NORMAL = "normal"
    LOG_NORMAL = "logNormal"
    GAMMA = "gamma"
    WEIBULL = "weibull"


class RoleArea(str, Enum):
    """Parts of a formation.

    FRONT: The foremost places.
    REAR: The hindmost.
    RIM: Those nearest to the outline.
    CENTRE: Those nearest to the middle.
    LEFT_FLANK: Those farthest to the left.
    RIGHT_FLANK: Those farthest to the right.
    FLANKS: Those farthest from the middle line.
    """

    FRONT = "front"
    REAR = "rear"
    RIM = "rim"
    CENTRE = "centre"
    LEFT_FLANK = "leftFlank"
    RIGHT_FLANK = "rightFlank"
    FLANKS = "flanks"


class Driver(str, Enum):
    """Who moves a character.

    MUSTER: Steering and contacts.
    OUTSIDE: Somebody else, by WriteMotion. Others keep clear of it.
    """

    MUSTER = "muster"
    OUTSIDE = "outside"


class SplitBy(str, Enum):
    """How a group is divided.

    IDS: Those with the given ids leave.
    LINE: Those to the left of a line leave, as their places lie.
    LASSO: Those whose places lie in a polygon leave.
    SHARES: Parts of given shares, front to back, or left to right.
    """

    IDS = "ids"
    LINE = "line"
    LASSO = "lasso"
    SHARES = "shares"


class PartShape(str, Enum):
    """The formation of parts.

    AS_HELD: The places that they held.
    SMALLER: The shape of the whole, for fewer.
    """

    AS_HELD = "asHeld"
    SMALLER = "smaller"


class OrderKind(str, Enum):
    """What an order asks for.

    MOVE: Go to `target`, by `route` if one is given.
    FACE: Turn to `facing` where it stands.
    FOLLOW: Keep at `offset` from a group or a character, until the next order.
    GUARD: Stand round a rectangle, which may move, until the next order.
    LEAVE: Leave the world by exits. Nobody has a place meanwhile.
    WAIT: Go to a waiting area and stand there. Nobody has a place meanwhile.
    WALK: Walk on towards `facing` without end. Nobody has a place meanwhile.
    """

    MOVE = "move"
    FACE = "face"
    FOLLOW = "follow"
    GUARD = "guard"
    LEAVE = "leave"
    WAIT = "wait"
    WALK = "walk"


class ExitChoice(str, Enum):
    """By which exit each leaves.

    QUICKEST: Where it will have left soonest, with the wait before it.
    NEAREST: The one with the quickest way.
    """

    QUICKEST = "quickest"
    NEAREST = "nearest"


class Manner(str, Enum):
    """How a group goes to its target.

    MARCH: In formation: the shape goes along the way and waits for the last.
    FREE: Each by the shortest way; the shape at the end.
    CONTINUUM: All to `target` itself, by one cost field that the crowd raises (Treuille et al. 2006): no shape, no
        places. Those who have come near stand where there is room.
    """

    MARCH = "march"
    FREE = "free"
    CONTINUUM = "continuum"


class Turn(str, Enum):
    """How a marching formation takes its turns.

    WHEEL: It faces along its way, and turns at a bounded rate.
    REVERSE: As Wheel, but where the way leads back its rear becomes its front, and nobody changes files.
    KEEP: It faces one way until it has arrived, and then turns to `facing`.
    FLOW: Everybody heads for the place that is nearest for all, and the formation flows where the way narrows. In the
        open nothing arrives sooner.
    """

    WHEEL = "wheel"
    REVERSE = "reverse"
    KEEP = "keep"
    FLOW = "flow"


class TouchPhase(str, Enum):
    """What a finger or a pointer does.

    DOWN: It comes down.
    MOVE: It moves.
    UP: It lifts.
    CANCEL: It is lost: its control ends at once.
    """

    DOWN = "down"
    MOVE = "move"
    UP = "up"
    CANCEL = "cancel"


class ControlEdit(str, Enum):
    """Changes of a control.

    PIN: It stays at the end of its trajectory.
    RELEASE: It is no longer pinned.
    REMOVE: It ends at once.
    """

    PIN = "pin"
    RELEASE = "release"
    REMOVE = "remove"


class QueueMode(str, Enum):
    """Where a new order stands in a queue.

    REPLACE: It takes the place of all others.
    APPEND: It comes last.
    INSERT: It comes before the order of a given index.
    """

    REPLACE = "replace"
    APPEND = "append"
    INSERT = "insert"


class QueueEdit(str, Enum):
    """Changes of a queue.

    CANCEL: Drops one order, or all.
    HOLD: The group waits where it is; the queue stays.
    RESUME: It goes on.
    PATROL: Orders that are done come last again.
    END_PATROL: They do not.
    STOP: Drops all orders, ends all controls, and the group stands where it is.
    """

    CANCEL = "cancel"
    HOLD = "hold"
    RESUME = "resume"
    PATROL = "patrol"
    END_PATROL = "endPatrol"
    STOP = "stop"


class Stance(str, Enum):
    """Who makes room where groups meet.

    NORMAL: Each as much as the other.
    HOLD: It holds its ground: others go round it.
    YIELD: It makes room for others.
    """

    NORMAL = "normal"
    HOLD = "hold"
    YIELD = "yield"


class Standing(str, Enum):
    """Whether a character stands in its place, and if not, what keeps it from there. Of a place it is said where the
        formation wants it: people stand beside it where they cannot stand there.

    IN_PLACE: It stands within 0.5 m of where its formation wants it.
    ON_THE_WAY: It is on its way, or its place is.
    HELD: Its group was ordered to hold, or it has not set out yet.
    STUCK: It has not got on for 5 s.
    OUTSIDE: Its place lies outside the ground.
    OBSTACLE: Its place lies in an obstacle.
    NARROW: Its place is too narrow for its body.
    NO_WAY: No way leads to its place.
    CROWDED: Others have taken the room at its place.
    """

    IN_PLACE = "inPlace"
    ON_THE_WAY = "onTheWay"
    HELD = "held"
    STUCK = "stuck"
    OUTSIDE = "outside"
    OBSTACLE = "obstacle"
    NARROW = "narrow"
    NO_WAY = "noWay"
    CROWDED = "crowded"


class EventKind(str, Enum):
    """Kinds of events. Those from Arrived on tell how orders get on and how groups change; each from Arrived to
        Partial comes once per order and version of the ground. An order is a pose, a formation, a count or a drawn
        way; the ground changes with every command that changes obstacles or patches.

    ENTER_PATCH: `value` is the id of the patch.
    LEAVE_PATCH: `value` is the id of the patch.
    TRANSITION_START: A transition into or out of a motion begins; `value` is the motion id.
    TRANSITION_END: A transition has ended; `value` is the motion id.
    SINGLE_STEP: A jump or climb begins; `value` is the motion id.
    COLLECT: An item was collected; `value` is the index of the item.
    FORMATION_CHANGE: A group has another formation; `subject` is the id of the group.
    SWAP: A character's place changed without a command; `value` is the new place.
    ARRIVED: All of a group's characters that have a place are within 0.5 m of it for 1 s, and the places stand where
        the order wants them; `value` is their number.
    STUCK: A character is not at its place and has moved less than 0.25 m over the last 5 s, and not in a queue that
        moves on; `value` is the place. Raised again only once it has moved.
    BLOCKED: The ground cut off the way of `value` characters of a group, or for 2 s a moving obstacle did, as a gate
        that closes. One that only passes gives no event.
    FREE: All of a group have their way again; `value` is how many had none.
    NO_PATH: No place of the group's order can be reached, or not by its largest members, who stay behind; `value` is
        the number of those concerned.
    PARTIAL: `value` places of the group's order cannot be reached; the others can.
    ORDER_GIVEN: A group was given the order of id `value`.
    ORDER_BEGUN: It begins the order of id `value`.
    ORDER_DONE: It has carried out the order of id `value`.
    ORDER_SKIPPED: It passes over the order of id `value`, whose target cannot be reached.
    PASSED: A group has passed the checkpoint of index `value`.
    GROUP_ADDED: A group is new; `value` is the id of the group that it was split off, 0 for none.
    GROUP_REMOVED: A group has ended; `value` is the id of the group that it was merged into, 0 for none.
    JOINED: A character is new; `value` is the id of its group.
    LEFT: A character has left the world; `value` is the id of its group.
    TRANSFERRED: A character has changed groups; `value` is the id of its new group.
    EXITED: A character has left the world by an exit; `value` is the id of that area.
    ENTERED: A character has come into the world by a source; `value` is the id of that area.
    """

    ENTER_PATCH = "enterPatch"
    LEAVE_PATCH = "leavePatch"
    TRANSITION_START = "transitionStart"
    TRANSITION_END = "transitionEnd"
    SINGLE_STEP = "singleStep"
    COLLECT = "collect"
    FORMATION_CHANGE = "formationChange"
    SWAP = "swap"
    ARRIVED = "arrived"
    STUCK = "stuck"
    BLOCKED = "blocked"
    FREE = "free"
    NO_PATH = "noPath"
    PARTIAL = "partial"
    ORDER_GIVEN = "orderGiven"
    ORDER_BEGUN = "orderBegun"
    ORDER_DONE = "orderDone"
    ORDER_SKIPPED = "orderSkipped"
    PASSED = "passed"
    GROUP_ADDED = "groupAdded"
    GROUP_REMOVED = "groupRemoved"
    JOINED = "joined"
    LEFT = "left"
    TRANSFERRED = "transferred"
    EXITED = "exited"
    ENTERED = "entered"


@dataclass(slots=True)
class Waypoint:
    """Position and angle of a moving object at one time.

    Attributes:
        time: World time, 0 to 1e7 [s].
        position: Offset from the object's defined position [m].
        angle: Rotation about the object's centre of area, -1e5 to 1e5 [rad].
    """

    time: float = 0.0
    position: Vec2 = (0.0, 0.0)
    angle: float = 0.0


@dataclass(slots=True)
class TimedPath:
    """Piecewise linear motion through waypoints of strictly rising time. An obstacle whose path is over becomes
        ground: the world then holds it where it stands, without a path.

    Attributes:
        waypoints: At least 1e-6 s apart; empty for an object that stands still.
        loop: True to start again after the last waypoint; false to stay there.
    """

    waypoints: list[Waypoint] = field(default_factory=list)
    loop: bool = False


@dataclass(slots=True)
class ObstacleDef:
    """Describes an obstacle, which nobody can walk through: a polygon or a disc.

    Attributes:
        name: Name for display; may be empty.
        polygon: Simple, convex or not [m]; empty for a disc.
        centre: Centre of the disc [m].
        radius: Radius of the disc, above 0 [m]; 0 for a polygon.
        path: Its motion; empty for an obstacle that stands still.
        range: Reach of its potential field, 0 or more [m]; negative for the world's default.
        strength: Factor of its potential field, 0 or more; negative for the world's default.
        height: Height for display only, above 0 [m].
    """

    name: str = ""
    polygon: list[Vec2] = field(default_factory=list)
    centre: Vec2 = (0.0, 0.0)
    radius: float = 0.0
    path: TimedPath = field(default_factory=TimedPath)
    range: float = -1.0
    strength: float = -1.0
    height: float = 3.0


@dataclass(slots=True)
class ClipFacts:
    """Facts of a motion clip that simulation needs (the paper's table 1).

    Attributes:
        name: Name of the motion: "run", "crawl", "climb"...
        file: File of the clip; empty for one of Muster's own.
        speed: Travel speed relative to running, above 0 (running is 1).
        length: Ground covered by one play [m]; 0 where unknown.
        duration: Duration of one play, 0 or more [s].
        cyclic: False for single-step motions (jump, climb).
        transition_time: Duration of the transition on entering and on leaving [s]; 0 for none.
        reach_ahead: From the character's position to the head of a body that leans or lies [m].
        reach_behind: From there back to its hips [m]; both are 0 for upright bodies.
    """

    name: str = ""
    file: str = ""
    speed: float = 1.0
    length: float = 0.0
    duration: float = 0.0
    cyclic: bool = True
    transition_time: float = 0.0
    reach_ahead: float = 0.0
    reach_behind: float = 0.0


@dataclass(slots=True)
class PatchDef:
    """Describes a patch: ground with a motion clip of its own (SPEC C1).

    Attributes:
        name: Name for display: "Net", "Pool"...
        polygon: Corners of a simple polygon, convex or not [m].
        path: Its motion; empty for a patch that stands still.
        motion: Clip played on it: an index into the world's clips.
        speed: Travel speed relative to running, above 0; negative for the clip's.
        ascent: For stairs and ramps: heading of the way up, where `speed` is that of going up [rad]; none for level
            ground.
        speed_down: For stairs and ramps: that of going down; negative for `speed`.
    """

    name: str = ""
    polygon: list[Vec2] = field(default_factory=list)
    path: TimedPath = field(default_factory=TimedPath)
    motion: int = 0
    speed: float = -1.0
    ascent: float | None = None
    speed_down: float = -1.0


@dataclass(slots=True)
class MapGrid:
    """The cells of a MovingAI map.

    Attributes:
        width: Columns, 1 to 4096.
        height: Rows, 1 to 4096.
        cells: One character per cell, row by row, the top row first.
    """

    width: int = 0
    height: int = 0
    cells: str = ""


@dataclass(slots=True)
class MapDef:
    """Scale and position of a map.

    Attributes:
        metres_per_cell: Edge of a map cell, above 0 [m].
        origin: Lower left corner of the map [m].
        swamp_speed: Travel speed on swamp cells `S` relative to running, above 0.
    """

    metres_per_cell: float = 1.0
    origin: Vec2 = (0.0, 0.0)
    swamp_speed: float = 0.4


@dataclass(slots=True)
class MapGround:
    """A MovingAI map as ground.

    Attributes:
        grid: The cells.
        placement: Scale and placement.
    """

    grid: MapGrid = field(default_factory=MapGrid)
    placement: MapDef = field(default_factory=MapDef)


@dataclass(slots=True)
class Arrivals:
    """How many people a source has let in by a time.

    Attributes:
        time: Time of the world [s].
        count: That come at this time.
    """

    time: float = 0.0
    count: int = 0


@dataclass(slots=True)
class AreaDef:
    """Describes an area, where people leave the world, come into it, or wait. It is no obstacle.

    Attributes:
        name: Name for display: "Main exit".
        kind: What it does.
        polygon: Corners of a simple polygon, convex or not [m].
        open: False: nobody leaves or comes here for now.
        rate: For Exit: the most people who leave in a second, 0 to 1000 [1/s]; 0 for as many as come. For Source: how
            many come in a second on average, at random times by the world's seed, 0 to 1000.
        queue: For Exit: a line in which people queue, from who is next to the last [m]; empty for a crowd.
        group: For Source in a WorldDef: index of the group whom its people join.
        from_: For Exit: when it opens [s]; for Source with a rate: when it begins.
        until: For Exit: when it closes [s]; for Source with a rate: when it ends.
        most: For Source with a rate: how many come in all; 0 for no end.
        timetable: For Source: further people, by ascending times.
    """

    name: str = ""
    kind: AreaKind = AreaKind.EXIT
    polygon: list[Vec2] = field(default_factory=list)
    open: bool = True
    rate: float = 0.0
    queue: list[Vec2] = field(default_factory=list)
    group: int = 0
    from_: float = 0.0
    until: float = 1e9
    most: int = 0
    timetable: list[Arrivals] = field(default_factory=list)


@dataclass(slots=True)
class ItemDef:
    """An item, which a character collects by coming within its radius.

    Attributes:
        position: Centre [m].
        radius: Radius, above 0 [m].
    """

    position: Vec2 = (0.0, 0.0)
    radius: float = 0.5


@dataclass(slots=True)
class Body:
    """The body of a character. A number of 0 stands for the parameter of that name.

    Attributes:
        radius: Radius, 0 or 0.05 to 1.5 [m].
        max_speed: Top speed in the open, 0 or 0.01 to 50 [m/s].
        acceleration: Top acceleration, 0 or 0.01 to 1000 [m/s^2].
        mass: Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less.
        supply: Units that it supplies to places (SPEC A1), above 0 and at most 1000.
        unit_class: Class, for roles; 0 for none.
        headway: Time that it keeps from who is ahead, 0 or 0.02 to 5 [s].
        premovement: Time from its first order until it sets out, 0 to 1e7 [s]; no parameter.
        upstairs: Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
        downstairs: Speed down stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
    """

    radius: float = 0.0
    max_speed: float = 0.0
    acceleration: float = 0.0
    mass: float = 1.0
    supply: float = 1.0
    unit_class: int = 0
    headway: float = 0.0
    premovement: float = 0.0
    upstairs: float = 0.0
    downstairs: float = 0.0


@dataclass(slots=True)
class RoleDef:
    """Characters of a class take their places in a part of the formation: as many as there are such characters. Roles
        choose in their order; who is of no role takes what is left. (Ranks by class: several roles in front.)

    Attributes:
        area: Where.
        unit_class: Who, 1 or more.
    """

    area: RoleArea = RoleArea.FRONT
    unit_class: int = 1


@dataclass(slots=True)
class Distribution:
    """The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not drawn, and
        what lies inside is drawn in its proportions. A constant is as it is.

    Attributes:
        spread: Its kind.
        a: First number, in the unit of what is drawn but for LogNormal.
        b: Second number; not read for Constant.
        least: The smallest value that occurs.
        most: The largest one.
    """

    spread: Spread = Spread.CONSTANT
    a: float = 0.0
    b: float = 0.0
    least: float = 0.0
    most: float = 1e9

    @classmethod
    def constant(cls, value: float) -> Distribution:
        """Everybody has `value`."""
        return cls(spread=Spread.CONSTANT, a=value)

    @classmethod
    def uniform(cls, low: float, high: float) -> Distribution:
        """Evenly from `low` to `high`."""
        return cls(spread=Spread.UNIFORM, a=low, b=high)

    @classmethod
    def normal(cls, mean: float, deviation: float, least: float, most: float) -> Distribution:
        """A normal distribution, cut off below `least` and above `most`."""
        return cls(spread=Spread.NORMAL, a=mean, b=deviation, least=least, most=most)

    def quantile(self, share: float) -> float:
        """The value below which a share of persons lie, in (0, 1)."""
        return _core.quantile(self, share)


@dataclass(slots=True)
class PeopleDef:
    """One sort of persons in a group. What is constantly 0 is not drawn: it is that of GroupDef.bodies, or of the
        parameters where that is 0, too. Each new person of a group is drawn: those who are there when the group is
        made, those whom ChangeGroup or AddCharacters without bodies adds, and those who come by a source. Bodies that
        AddCharacters or ChangeCharacters give are as given. Of those who are there when the group is made so many are
        of each sort as its share says, by largest remainders, at random ranks; who comes later is of a sort at
        random, by its share. Each number depends on the seed of the world, the id of the person and which number it
        is, and on nothing else.

    Attributes:
        name: Name for display: "Women over 50".
        share: Share of the group, above 0; shares are divided by their sum.
        unit_class: Class, for roles; 0 for none.
        speed: Top speed in the open, 0 or 0.01 to 50 [m/s].
        radius: Radius of the body, 0 or 0.05 to 1.5 [m].
        headway: Time that it keeps from who is ahead, 0 or 0.02 to 5 [s].
        premovement: Time until it sets out on its first order, 0 to 1e7 [s].
        age: Age, 0 or 5 to 90 [years]; above 0 it gives the top speed in the place of `speed`, as RiMEA has it.
        upstairs: Speed up stairs as a share of that in the open, 0 or 0.01 to 1.
        downstairs: Speed down stairs as a share of that in the open, 0 or 0.01 to 1.
    """

    name: str = ""
    share: float = 1.0
    unit_class: int = 0
    speed: Distribution = field(default_factory=Distribution)
    radius: Distribution = field(default_factory=Distribution)
    headway: Distribution = field(default_factory=Distribution)
    premovement: Distribution = field(default_factory=Distribution)
    age: Distribution = field(default_factory=Distribution)
    upstairs: float = 0.0
    downstairs: float = 0.0


@dataclass(slots=True)
class PolygonWithHoles:
    """An outline with holes; the outline runs counter-clockwise, holes clockwise.

    Attributes:
        outline: At least three corners [m].
        holes: Inside the outline, apart from each other [m].
    """

    outline: list[Vec2] = field(default_factory=list)
    holes: list[list[Vec2]] = field(default_factory=list)


@dataclass(slots=True)
class FormationDef:
    """Describes a formation in its local axes: it faces +x, its centre is the origin.

    Attributes:
        kind: Shape.
        spacing: Distance between neighbouring places, 0.05 to 100 [m].
        opening: Full angle of Pacman's mouth or of the crescent's gap, above 0 and at most 6 [rad].
        outline: For Outline: the shape, in any size [m].
        points: For Points: the places in this order [m]; at least as many as characters.
        files: For Square: how many stand abreast, 0 to 200,000; 0 for about as many as there are ranks.
    """

    kind: FormationKind = FormationKind.SQUARE
    spacing: float = 1.0
    opening: float = 1.2
    outline: PolygonWithHoles = field(default_factory=PolygonWithHoles)
    points: list[Vec2] = field(default_factory=list)
    files: int = 0


@dataclass(slots=True)
class Order:
    """One order of a group.

    Attributes:
        kind: What it asks for.
        target: Centre of the formation at the end [m]; of the rectangle for Guard.
        facing: Heading at the end [rad]; none for that of the last stretch.
        width: Width of the front of a formation in ranks (square, line, column), which becomes a square of so many
            files [m]; 0 for its own. Other shapes keep theirs.
        route: Drawn way to the target [m]; followed as drawn, round obstacles.
        formation: New formation, which is taken up on the way; none to keep it.
        manner: How it goes.
        turn: How it turns on a march.
        pace: Speed of a march [m/s]; 0 for as fast as all can keep up with.
        share: Share of the group that must have arrived before the next order begins, (0, 1].
        group: For Follow and Guard: the group to stay with; none for a character or a place.
        character: For Follow and Guard: id of the character to stay with; 0 for none.
        offset: For Follow: from its centre to the formation's, in its axes [m].
        half_size: For Guard: half the length and half the width of the rectangle [m].
        path: For Guard: how the rectangle moves from `target` on.
        exits: For Leave: by which exits; empty for all.
        choice: For Leave: by which of them each goes.
        attractions: For Leave: seconds by which each of `exits` counts as nearer than it is, -1e6 to 1e6 [s]; empty
            for none.
        herding: For Leave: seconds by which an exit counts as nearer if all others nearby choose it, 0 to 1e6 [s].
        misjudgement: For Leave: deviation of the error by which each misjudges the time by an exit, drawn by the
            world's seed, 0 to 1e6 [s].
        area: For Wait: the waiting area.
        seconds: For Wait: how long, from when its share has come, 0 to 1e9 [s]; 0 for no end.
    """

    kind: OrderKind = OrderKind.MOVE
    target: Vec2 = (0.0, 0.0)
    facing: float | None = None
    width: float = 0.0
    route: list[Vec2] = field(default_factory=list)
    formation: FormationDef | None = None
    manner: Manner = Manner.MARCH
    turn: Turn = Turn.FLOW
    pace: float = 0.0
    share: float = 0.95
    group: int = 0
    character: int = 0
    offset: Vec2 = (0.0, 0.0)
    half_size: Vec2 = (0.0, 0.0)
    path: TimedPath = field(default_factory=TimedPath)
    exits: list[int] = field(default_factory=list)
    choice: ExitChoice = ExitChoice.QUICKEST
    attractions: list[float] = field(default_factory=list)
    herding: float = 0.0
    misjudgement: float = 0.0
    area: int = 0
    seconds: float = 0.0

    @classmethod
    def move(cls, target: Vec2, facing: float | None = None) -> Order:
        """Goes to `target` [m] in formation and faces `facing` [rad]; None for the heading of the last stretch."""
        return cls(kind=OrderKind.MOVE, target=target, facing=facing)

    @classmethod
    def move_to_line(cls, left: Vec2, right: Vec2) -> Order:
        """Takes up a front from `left` to `right` [m]: its middle, width and facing."""
        return _core.move_to_line(left, right)

    @classmethod
    def go(cls, target: Vec2, facing: float | None = None) -> Order:
        """Goes to `target` [m], each by the shortest way."""
        return cls(kind=OrderKind.MOVE, target=target, facing=facing, manner=Manner.FREE)

    @classmethod
    def face(cls, facing: float) -> Order:
        """Turns to a heading [rad]."""
        return cls(kind=OrderKind.FACE, facing=facing)

    @classmethod
    def follow(cls, group: int, offset: Vec2) -> Order:
        """Follows a group; `offset` is from its centre, in its axes [m]."""
        return cls(kind=OrderKind.FOLLOW, group=group, offset=offset)

    @classmethod
    def follow_character(cls, character: int, offset: Vec2) -> Order:
        """Follows the character of an id; `offset` is in its axes [m]."""
        return cls(kind=OrderKind.FOLLOW, character=character, offset=offset)

    @classmethod
    def guard(cls, centre: Vec2, half_size: Vec2, facing: float) -> Order:
        """Stands round a rectangle of that centre and half size [m]."""
        return cls(kind=OrderKind.GUARD, target=centre, half_size=half_size, facing=facing)

    @classmethod
    def leave(cls, exits: list[int] | None = None) -> Order:
        """Leaves by exits: by the quickest of the ids given, of all where none are."""
        return cls(kind=OrderKind.LEAVE, exits=list(exits or []))

    @classmethod
    def wait(cls, area: int, seconds: float = 0.0) -> Order:
        """Waits in the area of an id for some seconds; 0 for no end."""
        return cls(kind=OrderKind.WAIT, area=area, seconds=seconds)

    @classmethod
    def walk(cls, facing: float) -> Order:
        """Walks on towards a heading [rad]."""
        return cls(kind=OrderKind.WALK, facing=facing)


@dataclass(slots=True)
class QueuedOrder:
    """An order in a group's queue.

    Attributes:
        id: Unique in the world; it is not used again.
        order: What is to be done.
    """

    id: int = 0
    order: Order = field(default_factory=Order)


@dataclass(slots=True)
class Conduct:
    """How a group behaves, whatever its orders.

    Attributes:
        stance: Who makes room.
        cohesion: 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1].
        squeeze: Share of its width that it may give up in narrow passages, [0, 1]; 0 for none.
        avoids: True: its mesh gives way to other meshes and to moving obstacles (SPEC B3).
    """

    stance: Stance = Stance.NORMAL
    cohesion: float = 0.0
    squeeze: float = 1.0
    avoids: bool = False


@dataclass(slots=True)
class GroupDef:
    """A group of characters with one mesh.

    Attributes:
        name: Name for display.
        count: Number of characters, 1 to 200,000, or 0 where a source sends some; at most 5,000 in all groups with
            exact plans.
        formation: Shape and spacing of the places.
        position: Centre of the formation [m].
        angle: Heading, counter-clockwise from +x [rad].
        starts: Initial positions of characters [m]; empty to start on their places.
        jitter: Largest random displacement of initial positions, 0 or more [m].
        bodies: One for all, or one for each character; empty for the parameters'.
        roles: Which class stands where; empty for none.
        demands: Units of supply that each place demands; empty for 1 each.
        conduct: How it behaves.
        orders: What it is to do at first, one after the other.
        patrols: True: orders that are done come last again.
        colour: Colour for display, 0xRRGGBB; none for the palette's.
        build: Build of its drawn bodies; none for both, by the character's id.
        motions: How it walks and jogs; none for the plain manner.
        people: Sorts of persons, who also come by sources; empty for none. A number that a sort draws goes before
            that of `bodies`; what it does not draw, and acceleration, mass and supply, is that of `bodies`.
    """

    name: str = "Group"
    count: int = 36
    formation: FormationDef = field(default_factory=FormationDef)
    position: Vec2 = (0.0, 0.0)
    angle: float = 0.0
    starts: list[Vec2] = field(default_factory=list)
    jitter: float = 0.0
    bodies: list[Body] = field(default_factory=list)
    roles: list[RoleDef] = field(default_factory=list)
    demands: list[float] = field(default_factory=list)
    conduct: Conduct = field(default_factory=Conduct)
    orders: list[Order] = field(default_factory=list)
    patrols: bool = False
    colour: int | None = None
    build: BodyBuild | None = None
    motions: MotionSet | None = None
    people: list[PeopleDef] = field(default_factory=list)


@dataclass(slots=True)
class GroupColour:
    """The colour of a group.

    Attributes:
        colour: Colour for display, 0xRRGGBB; none for the palette's.
    """

    colour: int | None = None


@dataclass(slots=True)
class GroupLook:
    """How the people of a group look.

    Attributes:
        build: Build of its drawn bodies; none for both, by the character's id.
        motions: How it walks and jogs; none for the plain manner.
    """

    build: BodyBuild | None = None
    motions: MotionSet | None = None


@dataclass(slots=True)
class FormationCheckpointDef:
    """A disc that changes the formation of a group which passes it (SPEC M7).

    Attributes:
        position: Centre [m].
        radius: Radius, above 0 [m].
        formation: New formation of the group.
        group: Index of the group that it applies to; -1 for all groups.
        once: True: it applies once per group. False: whenever a group enters.
        trigger: What passes it.
        share: For Crowd: share of the group, (0, 1].
    """

    position: Vec2 = (0.0, 0.0)
    radius: float = 2.0
    formation: FormationDef = field(default_factory=FormationDef)
    group: int = -1
    once: bool = True
    trigger: CheckpointTrigger = CheckpointTrigger.CROWD
    share: float = 0.5


@dataclass(slots=True)
class WorldDef:
    """Describes a world.

    Attributes:
        name: Title for display.
        description: Description in one or two sentences.
        credit: Credit for the data it uses; may be empty.
        gestures: File of its gestures, in the scenario's folder or below, which worlds do not read; empty for none.
        box: Extent of the ground [m].
        cell: Edge of a ground cell, above 0 [m].
        seed: Seed of all random numbers.
        clips: Facts of clips, which patches name by their index.
        obstacles: At most 20,000 obstacles.
        patches: At most 20,000 patches.
        map: Map that adds obstacles and patches; none for no map.
        groups: At most 20,000 groups.
        checkpoints: Discs that change formations.
        items: Items to collect.
        areas: Exits, sources and waiting areas; at most 1,000.
        ring: True: the left and the right side of `box` are joined. Who walks out on one side comes in on the other.
        parameters: Parameters of behaviour.
    """

    name: str = "Untitled"
    description: str = ""
    credit: str = ""
    gestures: str = ""
    box: Box = ((-16.0, -16.0), (16.0, 16.0))
    cell: float = 0.25
    seed: int = 1
    clips: list[ClipFacts] = field(default_factory=lambda: _core.default_clip_facts())
    obstacles: list[ObstacleDef] = field(default_factory=list)
    patches: list[PatchDef] = field(default_factory=list)
    map: MapGround | None = None
    groups: list[GroupDef] = field(default_factory=list)
    checkpoints: list[FormationCheckpointDef] = field(default_factory=list)
    items: list[ItemDef] = field(default_factory=list)
    areas: list[AreaDef] = field(default_factory=list)
    ring: bool = False
    parameters: dict[str, float] = field(default_factory=dict)


@dataclass(slots=True)
class Touch:
    """A finger touches down, moves or lifts, or its control ends at once. One that comes down edits the group whose
        mesh is nearest within `input.reach`, or `group` if given; when it has lifted, its trajectory is still
        followed.

    Attributes:
        phase: What it does.
        touch: Number of the finger, unique per client while it is down.
        position: For Down and Move: position in the world [m].
        time: World time stamp [s]; not read for Cancel.
        group: For Down: group to edit; none to pick it by position.
    """

    phase: TouchPhase = TouchPhase.DOWN
    touch: int = 0
    position: Vec2 = (0.0, 0.0)
    time: float = 0.0
    group: int = 0


@dataclass(slots=True)
class AddControl:
    """Makes a control of all its points at once, for mouse and programs. Its points are then moved and lifted like
        touches.

    Attributes:
        group: Group whose mesh it controls.
        kind: Kind of control, which must fit the number of touches.
        touches: Numbers of its fingers, 1 to 64.
        positions: Positions in the world, one per touch [m].
        time: World time stamp [s].
    """

    group: int = 0
    kind: ControlKind = ControlKind.POINT
    touches: list[int] = field(default_factory=list)
    positions: list[Vec2] = field(default_factory=list)
    time: float = 0.0


@dataclass(slots=True)
class EditControl:
    """Pins a control at the end of its trajectory, releases it, or ends it at once.

    Attributes:
        group: Group that the control belongs to.
        control: Its id.
        edit: What is done to it.
    """

    group: int = 0
    control: int = 0
    edit: ControlEdit = ControlEdit.PIN


@dataclass(slots=True)
class ReleaseClient:
    """A client has disconnected: all its fingers lift.

    Attributes:
        unused: Not used; archives need at least one field.
    """

    unused: int = 0


@dataclass(slots=True)
class ChangeGroup:
    """Changes what a group is. What is not given stays as it is. First comes the formation with its number of places,
        then the sorts of people, who joins or leaves, and all else. Where one of them cannot be, none is changed.

    Attributes:
        group: Group to change.
        formation: Its formation; none for the one that it has.
        count: Its number of characters: new ones join behind the mesh, those with the highest ids leave first; none
            for the number that it has.
        people: Its sorts of persons, empty where all are as GroupDef.bodies say. Persons who join it are drawn by
            them from now on. Its present members are drawn again, as those who come at once: each number that neither
            the sorts before nor these draw stays as it is. A person who has heard an order sets out when it was to;
            none for the sorts that it has.
        conduct: How it behaves; none for as it does.
        roles: Which class stands where, in the order in which they choose places; none for the roles that it has.
        demands: How many units of supply each place demands (SPEC A1), 0 to 1000, of each place, or empty for 1 each;
            none for the demands that these have.
        name: Its name, of at most 4,096 bytes; none for the one that it has.
        colour: Its colour; none for the one that it has.
        look: How its people look; none for as they do.
    """

    group: int = 0
    formation: FormationDef | None = None
    count: int | None = None
    people: list[PeopleDef] | None = None
    conduct: Conduct | None = None
    roles: list[RoleDef] | None = None
    demands: list[float] | None = None
    name: str | None = None
    colour: GroupColour | None = None
    look: GroupLook | None = None


@dataclass(slots=True)
class SetPose:
    """Moves the mesh of a group at once; its places and its characters walk there, or stand there at once. Its orders
        and controls end.

    Attributes:
        group: Group to move.
        position: New centre of the mesh in the world [m].
        angle: New heading, counter-clockwise from +x [rad].
        characters: True: its places and characters are there at once, and stand still.
    """

    group: int = 0
    position: Vec2 = (0.0, 0.0)
    angle: float = 0.0
    characters: bool = False


@dataclass(slots=True)
class AddGroup:
    """Adds a group.

    Attributes:
        group: Its definition.
    """

    group: GroupDef = field(default_factory=GroupDef)


@dataclass(slots=True)
class RemoveGroup:
    """Removes a group and its characters.

    Attributes:
        group: Group to remove.
    """

    group: int = 0


@dataclass(slots=True)
class PutThing:
    """Puts a thing into the place, or gives one another definition. Exactly one of the five definitions says what it
        is. An item that is collected stays so, and a checkpoint stays passed by the groups that have passed it.

    Attributes:
        id: Thing that gets another definition; 0 to add one.
        obstacle: An obstacle; none for other things.
        patch: A patch; none for other things.
        item: An item to collect; none for other things.
        checkpoint: A formation checkpoint (SPEC M7), whose `group` is not read; none for other things.
        area: An area, whose `group` is not read; none for other things.
        group: Group that a checkpoint concerns, none for any, or that people of a source join.
    """

    id: int = 0
    obstacle: ObstacleDef | None = None
    patch: PatchDef | None = None
    item: ItemDef | None = None
    checkpoint: FormationCheckpointDef | None = None
    area: AreaDef | None = None
    group: int = 0


@dataclass(slots=True)
class RemoveThing:
    """Removes a thing. People on their way to an area that is removed go to the other areas of their order, or stand.

    Attributes:
        thing: What it is.
        id: Its id.
    """

    thing: ThingKind = ThingKind.OBSTACLE
    id: int = 0


@dataclass(slots=True)
class SetParameter:
    """Changes the value of a parameter.

    Attributes:
        name: Name in parameterTable(): "plan.exponent".
        value: New value, in the range of the parameter.
    """

    name: str = ""
    value: float = 0.0


@dataclass(slots=True)
class GiveOrder:
    """Puts an order into a group's queue. The event OrderGiven tells its id.

    Attributes:
        group: The group.
        mode: Where the order stands in the queue.
        index: For Insert: before which order, counted from 0.
        order: The order.
    """

    group: int = 0
    mode: QueueMode = QueueMode.REPLACE
    index: int = 0
    order: Order = field(default_factory=Order)


@dataclass(slots=True)
class EditQueue:
    """Changes a group's queue.

    Attributes:
        group: The group.
        edit: What is done to the queue.
        order: For Cancel: the id of the order; 0 for all.
    """

    group: int = 0
    edit: QueueEdit = QueueEdit.CANCEL
    order: int = 0


@dataclass(slots=True)
class AddCharacters:
    """Characters join a group where they stand; places are added to its formation. Events Joined tell their ids.

    Attributes:
        group: Group that they join.
        positions: Where they stand [m]; they part where they would stand in each other.
        bodies: One for each, or one for all; empty for that of the group.
    """

    group: int = 0
    positions: list[Vec2] = field(default_factory=list)
    bodies: list[Body] = field(default_factory=list)


@dataclass(slots=True)
class TransferCharacters:
    """Characters leave their groups for another one, or leave the world. Ids, positions and velocities stay. The
        ranks behind them close up; a group may become empty, and stays.

    Attributes:
        ids: Their ids.
        group: Group that they join; none to leave the world.
    """

    ids: list[int] = field(default_factory=list)
    group: int = 0


@dataclass(slots=True)
class SplitGroup:
    """Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops, and
        all parts go on with the orders of the whole.

    Attributes:
        group: The group.
        by: How it is divided.
        ids: For Ids: the characters that leave.
        points: For Line: two points [m]; for Lasso: the corners of the polygon.
        shares: For Shares: of all parts, above 0; their sum counts as the whole.
        abreast: For Shares: parts lie side by side, not one behind the other.
        shape: Formation of the parts.
    """

    group: int = 0
    by: SplitBy = SplitBy.IDS
    ids: list[int] = field(default_factory=list)
    points: list[Vec2] = field(default_factory=list)
    shares: list[float] = field(default_factory=list)
    abreast: bool = False
    shape: PartShape = PartShape.AS_HELD


@dataclass(slots=True)
class MergeGroups:
    """Joins groups to the first of them; the others end.

    Attributes:
        groups: Two or more.
        shape: Smaller: the formation of the first for all; AsHeld: all places stay.
    """

    groups: list[int] = field(default_factory=list)
    shape: PartShape = PartShape.SMALLER


@dataclass(slots=True)
class ChangeCharacters:
    """Changes what characters are. What is not given stays as it is.

    Attributes:
        ids: Their ids.
        bodies: Their bodies, one for each or one for all; none for those that they have.
        driver: What moves them; none for what moves them now.
    """

    ids: list[int] = field(default_factory=list)
    bodies: list[Body] | None = None
    driver: Driver | None = None


@dataclass(slots=True)
class WriteMotion:
    """Where characters that are moved from outside are after this step.

    Attributes:
        ids: Their ids.
        positions: Where they are [m].
        velocities: Their velocities [m/s]; empty for what follows from the last positions.
    """

    ids: list[int] = field(default_factory=list)
    positions: list[Vec2] = field(default_factory=list)
    velocities: list[Vec2] = field(default_factory=list)


@dataclass(slots=True)
class ReverseQueue:
    """Reverses the orders of a group's queue: the last one begins, and what is under way comes last.

    Attributes:
        group: The group.
    """

    group: int = 0


@dataclass(slots=True)
class AddObstacle:
    """Adds an obstacle.

    Attributes:
        obstacle: Its definition.
    """

    obstacle: ObstacleDef = field(default_factory=ObstacleDef)


@dataclass(slots=True)
class ChangeObstacle:
    """Changes shape, position, path or field of an obstacle.

    Attributes:
        id: Its id.
        obstacle: Its new definition.
    """

    id: int = 0
    obstacle: ObstacleDef = field(default_factory=ObstacleDef)


@dataclass(slots=True)
class RemoveObstacle:
    """Removes an obstacle.

    Attributes:
        id: Its id.
    """

    id: int = 0


@dataclass(slots=True)
class AddPatch:
    """Adds a patch.

    Attributes:
        patch: Its definition.
    """

    patch: PatchDef = field(default_factory=PatchDef)


@dataclass(slots=True)
class ChangePatch:
    """Changes shape, position, path or motion of a patch.

    Attributes:
        id: Its id.
        patch: Its new definition.
    """

    id: int = 0
    patch: PatchDef = field(default_factory=PatchDef)


@dataclass(slots=True)
class RemovePatch:
    """Removes a patch.

    Attributes:
        id: Its id.
    """

    id: int = 0


@dataclass(slots=True)
class AddItem:
    """Adds an item to collect.

    Attributes:
        item: Its definition.
    """

    item: ItemDef = field(default_factory=ItemDef)


@dataclass(slots=True)
class ChangeItem:
    """Moves an item or changes its radius. Whether it is collected stays.

    Attributes:
        id: Its id.
        item: Its new definition.
    """

    id: int = 0
    item: ItemDef = field(default_factory=ItemDef)


@dataclass(slots=True)
class RemoveItem:
    """Removes an item.

    Attributes:
        id: Its id.
    """

    id: int = 0


@dataclass(slots=True)
class AddCheckpoint:
    """Adds a formation checkpoint (SPEC M7), which nobody has passed yet.

    Attributes:
        checkpoint: Its definition; its `group` is not read.
        group: Group that it concerns; none for any group.
    """

    checkpoint: FormationCheckpointDef = field(default_factory=FormationCheckpointDef)
    group: int = 0


@dataclass(slots=True)
class ChangeCheckpoint:
    """Changes a formation checkpoint. It stays passed by the groups that have passed it.

    Attributes:
        id: Its id.
        checkpoint: Its new definition; its `group` is not read.
        group: Group that it concerns; none for any group.
    """

    id: int = 0
    checkpoint: FormationCheckpointDef = field(default_factory=FormationCheckpointDef)
    group: int = 0


@dataclass(slots=True)
class RemoveCheckpoint:
    """Removes a formation checkpoint.

    Attributes:
        id: Its id.
    """

    id: int = 0


@dataclass(slots=True)
class PutArea:
    """Adds an area, or changes one.

    Attributes:
        id: The area that is changed; none to add one.
        area: Its definition; its `group` is not read.
        group: For Source: the group that its people join.
    """

    id: int = 0
    area: AreaDef = field(default_factory=AreaDef)
    group: int = 0


@dataclass(slots=True)
class RemoveArea:
    """Removes an area. People on their way to it go to the other areas of their order, or stand.

    Attributes:
        id: Its id.
    """

    id: int = 0


@dataclass(slots=True)
class SetFormation:
    """The group takes another formation.

    Attributes:
        group: Group to change.
        formation: Its new definition.
    """

    group: int = 0
    formation: FormationDef = field(default_factory=FormationDef)


@dataclass(slots=True)
class SetCount:
    """Changes the number of characters. New ones join behind the mesh; those with the highest ids leave first.

    Attributes:
        group: Group to change.
        count: New number of characters.
    """

    group: int = 0
    count: int = 0


@dataclass(slots=True)
class SetConduct:
    """Tells a group how to behave.

    Attributes:
        group: The group.
        conduct: How it behaves.
    """

    group: int = 0
    conduct: Conduct = field(default_factory=Conduct)


@dataclass(slots=True)
class RemoveCharacters:
    """Characters leave the world; the ranks behind them close up. A group may become empty, and stays.

    Attributes:
        ids: Their ids.
    """

    ids: list[int] = field(default_factory=list)


@dataclass(slots=True)
class SetBodies:
    """Gives characters other bodies.

    Attributes:
        ids: Their ids.
        bodies: One for each, or one for all.
    """

    ids: list[int] = field(default_factory=list)
    bodies: list[Body] = field(default_factory=list)


@dataclass(slots=True)
class SetRoles:
    """Says which class stands where in a formation.

    Attributes:
        group: The group.
        roles: In the order in which they choose places; empty for none.
    """

    group: int = 0
    roles: list[RoleDef] = field(default_factory=list)


@dataclass(slots=True)
class SetDemands:
    """Says how many units of supply each place demands (SPEC A1).

    Attributes:
        group: The group.
        demands: Of each place, 0 to 1000; empty for 1 each.
    """

    group: int = 0
    demands: list[float] = field(default_factory=list)


@dataclass(slots=True)
class SetDriver:
    """Says what moves characters.

    Attributes:
        ids: Their ids.
        driver: What moves them.
    """

    ids: list[int] = field(default_factory=list)
    driver: Driver = Driver.MUSTER


@dataclass(slots=True)
class PlaceGroup:
    """Puts a group elsewhere at once: its mesh, its places, and its characters, who stand still there. Its orders and
        controls end. (SetPose moves the mesh alone, and characters walk.)

    Attributes:
        group: The group.
        position: New centre of the formation [m].
        angle: New heading, counter-clockwise from +x [rad].
    """

    group: int = 0
    position: Vec2 = (0.0, 0.0)
    angle: float = 0.0


@dataclass(slots=True)
class NameGroup:
    """Gives a group another name.

    Attributes:
        group: The group.
        name: At most 4,096 bytes.
    """

    group: int = 0
    name: str = ""


@dataclass(slots=True)
class ColourGroup:
    """Gives a group another colour.

    Attributes:
        group: The group.
        colour: 0xRRGGBB; none for the palette's, by the group's id.
    """

    group: int = 0
    colour: int | None = None


@dataclass(slots=True)
class SetAppearance:
    """Gives the people of a group another appearance.

    Attributes:
        group: The group.
        build: Build of its drawn bodies; none for both, by the character's id.
        motions: How it walks and jogs; none for the plain manner.
    """

    group: int = 0
    build: BodyBuild | None = None
    motions: MotionSet | None = None


@dataclass(slots=True)
class SetPeople:
    """Gives a group other sorts of persons. Persons who join it by number or by a source are drawn by them from now
        on. Its present members are drawn again, as those who come at once: each number that neither the sorts before
        nor these draw stays as it is. A person who has heard an order sets out when it was to.

    Attributes:
        group: The group.
        people: Its sorts; none: all are as GroupDef.bodies say.
    """

    group: int = 0
    people: list[PeopleDef] = field(default_factory=list)


@dataclass(slots=True)
class TouchDown:
    """A finger touches down. It edits the group whose mesh is nearest within `input.reach`, or `group` if given.

    Attributes:
        touch: Number of the finger, unique per client while it is down.
        position: Position in the world [m].
        time: World time stamp [s].
        group: Group to edit; none to pick it by position.
    """

    touch: int = 0
    position: Vec2 = (0.0, 0.0)
    time: float = 0.0
    group: int = 0


@dataclass(slots=True)
class TouchMove:
    """A finger moves.

    Attributes:
        touch: Number of the finger.
        position: Position in the world [m].
        time: World time stamp [s].
    """

    touch: int = 0
    position: Vec2 = (0.0, 0.0)
    time: float = 0.0


@dataclass(slots=True)
class TouchUp:
    """A finger lifts; its trajectory is still followed.

    Attributes:
        touch: Number of the finger.
        time: World time stamp [s].
    """

    touch: int = 0
    time: float = 0.0


@dataclass(slots=True)
class TouchCancel:
    """The control of a finger ends at once.

    Attributes:
        touch: Number of the finger.
    """

    touch: int = 0


@dataclass(slots=True)
class PinControl:
    """Pins a control at the end of its trajectory, or releases it.

    Attributes:
        group: Group that the control belongs to.
        control: Its id.
        pinned: False to release it.
    """

    group: int = 0
    control: int = 0
    pinned: bool = True


@dataclass(slots=True)
class RemoveControl:
    """Ends a control at once.

    Attributes:
        group: Group that the control belongs to.
        control: Its id.
    """

    group: int = 0
    control: int = 0


@dataclass(slots=True)
class OrderForecast:
    """What would come of an order.

    Attributes:
        arrives: True where the target can be reached.
        way: The way of the formation's centre, both ends included [m].
        end: Where the formation would stand: the target, or the nearest ground to it [m].
        seconds: Time until it would arrive [s]; infinite where it never does.
    """

    arrives: bool = False
    way: list[Vec2] = field(default_factory=list)
    end: Vec2 = (0.0, 0.0)
    seconds: float = 0.0


CommandBody = Union[
    Touch,
    AddControl,
    EditControl,
    ReleaseClient,
    ChangeGroup,
    SetPose,
    AddGroup,
    RemoveGroup,
    PutThing,
    RemoveThing,
    SetParameter,
    GiveOrder,
    EditQueue,
    AddCharacters,
    TransferCharacters,
    SplitGroup,
    MergeGroups,
    ChangeCharacters,
    WriteMotion,
    ReverseQueue,
    AddObstacle,
    ChangeObstacle,
    RemoveObstacle,
    AddPatch,
    ChangePatch,
    RemovePatch,
    AddItem,
    ChangeItem,
    RemoveItem,
    AddCheckpoint,
    ChangeCheckpoint,
    RemoveCheckpoint,
    PutArea,
    RemoveArea,
    SetFormation,
    SetCount,
    SetConduct,
    RemoveCharacters,
    SetBodies,
    SetRoles,
    SetDemands,
    SetDriver,
    PlaceGroup,
    NameGroup,
    ColourGroup,
    SetAppearance,
    SetPeople,
    TouchDown,
    TouchMove,
    TouchUp,
    TouchCancel,
    PinControl,
    RemoveControl,
]


@dataclass(slots=True)
class Command:
    """A change of a world, with its step and sender. Commands apply in the order of (step, client, sequence).

    Attributes:
        step: It applies at the start of the step from `step` to `step + 1`.
        client: Number of the sender.
        sequence: Rises with each command of a client.
        body: The change.
    """

    step: int = 0
    client: int = 0
    sequence: int = 0
    body: CommandBody = field(default_factory=Touch)


@dataclass(slots=True)
class WalkTotals:
    """Sums over the path costs of all characters with a place, in metres of open ground.

    Attributes:
        sum: Sum of the costs [m].
        squares: Sum of the squared costs [m^2].
        longest: Largest cost [m].
    """

    sum: float = 0.0
    squares: float = 0.0
    longest: float = 0.0


@dataclass(slots=True)
class Checkpoint:
    """A point of a drawn trajectory.

    Attributes:
        position: Position in the world [m].
        time: When it was drawn [s].
    """

    position: Vec2 = (0.0, 0.0)
    time: float = 0.0


@dataclass(slots=True)
class ControlPoint:
    """A mesh vertex that a finger controls, and the trajectory drawn for it.

    Attributes:
        vertex: Index of the mesh vertex, which is a hard constraint.
        touch: Number of the finger; unique per client while it is down.
        down: False once the finger has lifted.
        offset: From the finger to the vertex at touch down [m]; added to all drawn points.
        position: Current position of the vertex in the world [m].
        trajectory: Checkpoints still ahead; the last is the finger's newest point.
    """

    vertex: int = 0
    touch: int = 0
    down: bool = True
    offset: Vec2 = (0.0, 0.0)
    position: Vec2 = (0.0, 0.0)
    trajectory: list[Checkpoint] = field(default_factory=list)


@dataclass(slots=True)
class MeshPoint:
    """A point of a mesh by its barycentric coordinates. It follows the mesh when that is deformed.

    Attributes:
        triangle: Index into the mesh's triangles.
        weight: Barycentric coordinates; their sum is 1.
    """

    triangle: int = 0
    weight: tuple[float, float, float] = (1.0, 0.0, 0.0)


@dataclass(slots=True)
class Control:
    """One control of a mesh. All its points follow their trajectories by a common clock, which preserves their
        relative timing.

    Attributes:
        id: Unique id, which is not reused.
        kind: Follows from the number of points.
        client: Number of the client that touches.
        pinned: True where it stays at the end of its trajectories.
        open: True while touches of the same client may still join.
        join_deadline: World time at which it stops being open [s]; -1 before its first step.
        start_time: Time stamp of the first touch [s]; may be later than the world's time.
        clock: Time of the drawing that the points have reached [s].
        points: Controlled vertices, at least one.
        supplementary: Supplementary points, which are soft constraints.
        weights: Row-major weights, supplementary points x points; each row sums to 1.
    """

    id: int = 0
    kind: ControlKind = ControlKind.POINT
    client: int = 0
    pinned: bool = False
    open: bool = True
    join_deadline: float = -1.0
    start_time: float = 0.0
    clock: float = 0.0
    points: list[ControlPoint] = field(default_factory=list)
    supplementary: list[MeshPoint] = field(default_factory=list)
    weights: list[float] = field(default_factory=list)


@dataclass(slots=True)
class Event:
    """One event.

    Attributes:
        kind: What happened.
        subject: Id of the character; of the group where the kind speaks of one.
        value: Its meaning depends on the kind.
        position: Where it happened: the middle of those concerned [m].
    """

    kind: EventKind = EventKind.ENTER_PATCH
    subject: int = 0
    value: int = 0
    position: Vec2 = (0.0, 0.0)


@dataclass(slots=True)
class ContactReport:
    """Overlaps of bodies that remain after a step.

    Attributes:
        overlap_pairs: Pairs that overlap by more than 10 % of the sum of their radii.
        worst_penetration: Overlap of the deepest pair, as a share of that.
    """

    overlap_pairs: int = 0
    worst_penetration: float = 0.0


@dataclass(slots=True)
class HashMark:
    """The hash of a world's state after that many steps.

    Attributes:
        step: Number of steps done.
        hash: Hash of the state after these steps.
        commands: Number of commands recorded before this mark. The file does not store it.
    """

    step: int = 0
    hash: int = 0
    commands: int = 0


@dataclass(slots=True)
class TakeEvent:
    """An event of an order, as it was raised while the take was recorded (EventKind: Arrived and later ones).

    Attributes:
        step: Number of steps done at the event.
        event: The event.
    """

    step: int = 0
    event: Event = field(default_factory=Event)


@dataclass(slots=True)
class SpeedPiece:
    """A part of a take that plays faster or slower than it was recorded.

    Attributes:
        from_: Time in the take [s].
        to: Time in the take [s], above `from`.
        speed: Seconds of the take per second, 0.1 to 8.
        ease: Time at each end in which the speed comes and goes [s], 0 or more.
    """

    from_: float = 0.0
    to: float = 0.0
    speed: float = 1.0
    ease: float = 0.0


@dataclass(slots=True)
class CameraKey:
    """Where a film's camera is at a moment of a take. From one to the next it moves with ease.

    Attributes:
        step: Number of steps done.
        x: The point on the ground that it looks at [m].
        y: As above [m].
        distance: From there, above 0 [m].
        turn: Round the vertical [rad].
        pitch: How steeply it looks down [rad].
        cut: True: the camera is here at once, and rests before.
    """

    step: int = 0
    x: float = 0.0
    y: float = 0.0
    distance: float = 1.0
    turn: float = 0.0
    pitch: float = 0.0
    cut: bool = False


@dataclass(slots=True)
class PathPin:
    """Holds the path of edited people at another place at one moment of their own clock; before and after it the path
        moves along, ever less.

    Attributes:
        time: Time on the own clock of each of them, 0 or more [s].
        offset: How far from where they were then [m].
        seconds: So long before and after the path moves along [s], 0.2 to 60; never beyond the next pin.
    """

    time: float = 0.0
    offset: Vec2 = (0.0, 0.0)
    seconds: float = 2.0


@dataclass(slots=True)
class ClockPoint:
    """A moment at which edited people are as far on their path as they were at another.

    Attributes:
        time: Time in the take [s].
        own: Time of the recording that is shown then [s].
    """

    time: float = 0.0
    own: float = 0.0


@dataclass(slots=True)
class ClipPart:
    """A time in which edited people play a named clip.

    Attributes:
        name: Name of the clip; one that does not repeat is played once.
        from_: Time in the take [s].
        to: Time in the take [s], above `from`.
    """

    name: str = ""
    from_: float = 0.0
    to: float = 0.0


@dataclass(slots=True)
class LookPart:
    """A time in which edited people look at something.

    Attributes:
        person: At whom; 0 for a point.
        point: At which point, without a person [m].
        height: The height of that point, -10 to 100 [m].
        from_: Time in the take [s].
        to: Time in the take [s], above `from`.
    """

    person: int = 0
    point: Vec2 = (0.0, 0.0)
    height: float = 1.6
    from_: float = 0.0
    to: float = 0.0


@dataclass(slots=True)
class TakeEdit:
    """What is changed afterwards in how some people are shown; everybody else keeps everything.

    Attributes:
        people: Who, in ascending order; nobody has two edits.
        pins: In ascending order, at least 0.1 s apart.
        clock: None, or two and more in ascending order; before the first and after the last one their clock runs as
            usual.
        clips: In ascending order, apart from each other.
        looks: In ascending order, apart from each other.
    """

    people: list[int] = field(default_factory=list)
    pins: list[PathPin] = field(default_factory=list)
    clock: list[ClockPoint] = field(default_factory=list)
    clips: list[ClipPart] = field(default_factory=list)
    looks: list[LookPart] = field(default_factory=list)


@dataclass(slots=True)
class TakeAbout:
    """What is said about a take: its name, and the part of it that is to be shown. It changes nothing of what was
        recorded.

    Attributes:
        title: Name for people; empty for none, at most kMaxTitleBytes.
        from_: Steps before the part begins.
        to: Steps after which the part ends; kTakeEnd for the end of the take.
        speeds: In ascending order, apart from each other; at most kMaxSpeedPieces.
        camera: In ascending order of steps; at most kMaxCameraKeys.
        edits: Changes of how some people are shown; at most kMaxEdits, of kMaxEdited people together.
    """

    title: str = ""
    from_: int = 0
    to: int = 0xffffffff
    speeds: list[SpeedPiece] = field(default_factory=list)
    camera: list[CameraKey] = field(default_factory=list)
    edits: list[TakeEdit] = field(default_factory=list)


@dataclass(slots=True)
class ReplayReport:
    """Outcome of a replay.

    Attributes:
        steps: Number of steps simulated.
        compared: Number of marks that matched.
        unmarked: Steps after the last mark, which no hash confirms.
        hash: Hash of the final state.
    """

    steps: int = 0
    compared: int = 0
    unmarked: int = 0
    hash: int = 0


@dataclass(slots=True)
class ExitFigures:
    """What an exit let through in a run.

    Attributes:
        id: Of the exit, which may be no more.
        name: Its name; may be empty.
        left: Persons who left by it.
        first: When the first one did [s]; -1 where nobody did.
        last: When the last one did [s]; -1 where nobody did.
        flow: (left - 1) / (last - first) [1/s]; -1 where that is no number.
    """

    id: int = 0
    name: str = ""
    left: int = 0
    first: float = -1.0
    last: float = -1.0
    flow: float = -1.0


@dataclass(slots=True)
class SourceFigures:
    """What a source let in in a run.

    Attributes:
        id: Of the source, which may be no more.
        name: Its name; may be empty.
        entered: Persons who came by it.
        waiting: Persons who wait for room in it at the end.
    """

    id: int = 0
    name: str = ""
    entered: int = 0
    waiting: int = 0


@dataclass(slots=True)
class DepartureFigures:
    """Figures of those who leave and come. Times count from the beginning of the world; -1 where not reached.

    Attributes:
        left: Persons who left by an exit.
        first: When the first one of them left [s].
        last: When the last one of them left [s].
        left50: When half of all had left: of those who left, who are still there and who wait at a source [s]; -1
            also while a source may still send more.
        left95: When 95 % of all had left, as left50 [s].
        exits: In ascending order of ids.
        sources: In ascending order of ids.
    """

    left: int = 0
    first: float = -1.0
    last: float = -1.0
    left50: float = -1.0
    left95: float = -1.0
    exits: list[ExitFigures] = field(default_factory=list)
    sources: list[SourceFigures] = field(default_factory=list)


@dataclass(slots=True)
class RunFigures:
    """Figures of a run. Times count from the last command, those of departures from the beginning.

    Attributes:
        characters: At the end.
        steps: Done.
        hash: Of the state at the end.
        arrived95: When 95 % had arrived of all who are there or have left by an exit, which is arriving [s]; -1 where
            not reached, and while a source may still send more.
        arrived100: When all had arrived, as arrived95 [s].
        stuck: Not arrived, and within 0.25 m for the last 5 s.
        path_ratio: Length walked over the least-sum geodesic assignment; -1 where it has no meaning.
        overlap_pairs_max: Most pairs at once deeper than 10 % of the mean diameter.
        worst_penetration: Share of the mean diameter.
        top_speed_ratio: Largest displacement of a step, in steps at own top speed on that ground.
        swaps_per_character_per_second: Changes of place without a command.
        planned: Paths to the places by the last plan, all groups.
        walked: Paths walked by those still there.
        lag_p95: Distance to the place at the end, p95 [m].
        unmatched: At the end.
        collected: Items.
        events: Of the whole run, by kind.
        event_persons: For the kinds that isAboutMany(): the sum over groups of the most characters that an event was
            about.
        departures: Who left by exits and came by sources.
        step_p50: Median time of a step [ms].
        step_p95: 95th percentile [ms].
        step_max: Longest step [ms].
        stage_mean: Mean time by stage [ms].
    """

    characters: int = 0
    steps: int = 0
    hash: int = 0
    arrived95: float = -1.0
    arrived100: float = -1.0
    stuck: int = 0
    path_ratio: float = -1.0
    overlap_pairs_max: int = 0
    worst_penetration: float = 0.0
    top_speed_ratio: float = 0.0
    swaps_per_character_per_second: float = 0.0
    planned: WalkTotals = field(default_factory=WalkTotals)
    walked: WalkTotals = field(default_factory=WalkTotals)
    lag_p95: float = 0.0
    unmatched: int = 0
    collected: int = 0
    events: dict[str, int] = field(default_factory=dict)
    event_persons: dict[str, int] = field(default_factory=dict)
    departures: DepartureFigures = field(default_factory=DepartureFigures)
    step_p50: float = 0.0
    step_p95: float = 0.0
    step_max: float = 0.0
    stage_mean: dict[str, float] = field(default_factory=dict)


@dataclass(slots=True)
class AreaCount:
    """What an area has seen.

    Attributes:
        passed: People who have left by an exit, or come by a source.
        waiting: People of a source for whom there is no room yet.
    """

    passed: int = 0
    waiting: int = 0
