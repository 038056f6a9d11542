// Made by schema/generate.mjs from schema/api: change these, not this file.

import type { ReadOut } from '../binding/read_out.js';
import type { Rows } from '../binding/rows.js';
import type { Status, FormationKind, BodyBuild, MotionSet, ControlKind, AreaKind, ThingKind, CheckpointTrigger, Spread, RoleArea, Driver, SplitBy, PartShape, OrderKind, ExitChoice, Manner, Turn, TouchPhase, ControlEdit, QueueMode, QueueEdit, Stance, EventKind, MotionIndex, ObstacleId, PatchId, GroupId, AreaId, ControlId, CharacterId, OrderId, Limb } from './enums.js';

/** A point or vector in the ground plane: x right, y forward [m]. */
export interface Vec2 {
  /** To the right [m]. */
  x: number;
  /** Forward [m]. */
  y: number;
}

/** A rotation in the plane. */
export interface Rotation {
  /** Cosine of its angle. */
  readonly c: number;
  /** Sine. */
  readonly s: number;
}

/** A rigid transform: rotation about the origin, then translation. */
export interface Pose {
  /** Translation [m]. */
  readonly position: Vec2;
  /** Unit rotation. */
  readonly rotation: Rotation;
}

/** An axis-aligned box. */
export interface Box {
  /** Lower left corner [m]. */
  min: Vec2;
  /** Upper right corner [m]. */
  max: Vec2;
}

/** Three vertex indices, counter-clockwise. */
export interface Triangle {
  /** Indices. */
  readonly vertex: readonly number[];
}

/** A point of a mesh by its barycentric coordinates. */
export interface MeshPoint {
  /** Index into the mesh's triangles. */
  readonly triangle: number;
  /** Barycentric coordinates; their sum is 1. */
  readonly weight: readonly number[];
}

/** Corners of a polygon in order [m]; an edge joins the last to the first. */
export interface Polygon {
  /** Corners, counter-clockwise unless noted otherwise [m]. */
  points: Vec2[];
}

/** What may be given of Polygon. */
export interface PolygonInit {
  /** Corners, counter-clockwise unless noted otherwise [m]. */
  readonly points?: readonly Vec2[] | Float64Array | undefined;
}

/** A MovingAI grid map as ground. */
export interface MapDef {
  /** Columns, 1 to 4096. */
  width: number;
  /** Rows, 1 to 4096. */
  height: number;
  /** One character per cell, row by row, the top row first. */
  cells: string;
  /** Edge of a map cell, above 0 [m]. */
  metresPerCell: number;
  /** Lower left corner of the map [m]. */
  origin: Vec2;
  /** Travel speed on swamp cells `S` relative to running, above 0. */
  swampSpeed: number;
}

/** What may be given of MapDef. */
export interface MapDefInit {
  /** Columns, 1 to 4096. */
  readonly width?: number | undefined;
  /** Rows, 1 to 4096. */
  readonly height?: number | undefined;
  /** One character per cell, row by row, the top row first. */
  readonly cells?: string | null | undefined;
  /** Edge of a map cell, above 0 [m]. */
  readonly metresPerCell?: number | undefined;
  /** Lower left corner of the map [m]. */
  readonly origin?: Vec2 | undefined;
  /** Travel speed on swamp cells `S` relative to running, above 0. */
  readonly swampSpeed?: number | undefined;
}

/** The value of a parameter. */
export interface ParameterValue {
  /** Name as parameterInfo() gives it: "plan.exponent". */
  name: string;
  /** Value in the range of the parameter. */
  value: number;
}

/** What may be given of ParameterValue. */
export interface ParameterValueInit {
  /** Name as parameterInfo() gives it: "plan.exponent". */
  readonly name?: string | null | undefined;
  /** Value in the range of the parameter. */
  readonly value: number;
}

/** Position and angle of a moving object at one time. */
export interface Waypoint {
  /** World time, 0 to 1e7 [s]. */
  time: number;
  /** Offset from the object's defined position [m]. */
  position: Vec2;
  /** Rotation about the object's centre of area, -1e5 to 1e5 [rad]. */
  angle: number;
}

/**
 * Piecewise linear motion through waypoints of strictly rising time. An obstacle whose path is over becomes
 * ground: the world then holds it where it stands, without a path.
 */
export interface TimedPath {
  /** At least 1e-6 s apart; none for an object that stands still. */
  waypoints: Waypoint[];
  /** True to start again after the last waypoint; false to stay there. */
  loop: boolean;
}

/** What may be given of TimedPath. */
export interface TimedPathInit {
  /** At least 1e-6 s apart; none for an object that stands still. */
  readonly waypoints?: readonly Waypoint[] | undefined;
  /** True to start again after the last waypoint; false to stay there. */
  readonly loop?: boolean | undefined;
}

/** Describes an obstacle, which nobody can walk through: a polygon or a disc. */
export interface ObstacleDef {
  /** Name for display; null for none. */
  name: string;
  /** Simple, convex or not [m]; empty for a disc. */
  polygon: Polygon;
  /** Centre of the disc [m]. */
  centre: Vec2;
  /** Radius of the disc, above 0 [m]; 0 for a polygon. */
  radius: number;
  /** Its motion; empty for an obstacle that stands still. */
  path: TimedPath;
  /** Reach of its potential field, 0 or more [m]; negative for the world's default. */
  range: number;
  /** Factor of its potential field, 0 or more; negative for the world's default. */
  strength: number;
  /** Height for display only, above 0 [m]. */
  height: number;
}

/** What may be given of ObstacleDef. */
export interface ObstacleDefInit {
  /** Name for display; null for none. */
  readonly name?: string | null | undefined;
  /** Simple, convex or not [m]; empty for a disc. */
  readonly polygon?: PolygonInit | undefined;
  /** Centre of the disc [m]. */
  readonly centre?: Vec2 | undefined;
  /** Radius of the disc, above 0 [m]; 0 for a polygon. */
  readonly radius?: number | undefined;
  /** Its motion; empty for an obstacle that stands still. */
  readonly path?: TimedPathInit | undefined;
  /** Reach of its potential field, 0 or more [m]; negative for the world's default. */
  readonly range?: number | undefined;
  /** Factor of its potential field, 0 or more; negative for the world's default. */
  readonly strength?: number | undefined;
  /** Height for display only, above 0 [m]. */
  readonly height?: number | undefined;
}

/** Facts of a motion clip that simulation needs (the paper's table 1). */
export interface ClipFacts {
  /** Name of the motion: "run", "crawl", "climb"...; null for none. */
  name: string;
  /** File of the clip; empty for one of Muster's own; null for none. */
  file: string;
  /** Travel speed relative to running, above 0 (running is 1). */
  speed: number;
  /** Ground covered by one play [m]; 0 where unknown. */
  length: number;
  /** Duration of one play, 0 or more [s]. */
  duration: number;
  /** False for single-step motions (jump, climb). */
  cyclic: boolean;
  /** Duration of the transition on entering and on leaving [s]; 0 for none. */
  transitionTime: number;
  /** From the character's position to the head of a body that leans or lies [m]. */
  reachAhead: number;
  /** From there back to its hips [m]; both are 0 for upright bodies. */
  reachBehind: number;
}

/** What may be given of ClipFacts. */
export interface ClipFactsInit {
  /** Name of the motion: "run", "crawl", "climb"...; null for none. */
  readonly name?: string | null | undefined;
  /** File of the clip; empty for one of Muster's own; null for none. */
  readonly file?: string | null | undefined;
  /** Travel speed relative to running, above 0 (running is 1). */
  readonly speed?: number | undefined;
  /** Ground covered by one play [m]; 0 where unknown. */
  readonly length?: number | undefined;
  /** Duration of one play, 0 or more [s]. */
  readonly duration?: number | undefined;
  /** False for single-step motions (jump, climb). */
  readonly cyclic?: boolean | undefined;
  /** Duration of the transition on entering and on leaving [s]; 0 for none. */
  readonly transitionTime?: number | undefined;
  /** From the character's position to the head of a body that leans or lies [m]. */
  readonly reachAhead?: number | undefined;
  /** From there back to its hips [m]; both are 0 for upright bodies. */
  readonly reachBehind?: number | undefined;
}

/** Describes a patch: ground with a motion clip of its own. */
export interface PatchDef {
  /** Name for display: "Net", "Pool"...; null for none. */
  name: string;
  /** Corners of a simple polygon, convex or not [m]. */
  polygon: Polygon;
  /** Its motion; empty for a patch that stands still. */
  path: TimedPath;
  /** Clip played on it: an index into the world's clips. */
  motion: MotionIndex;
  /** Travel speed relative to running, above 0; negative for the clip's. */
  speed: number;
  /** For stairs and ramps: heading of the way up, where `speed` is that of going up [rad]. Null: level ground. */
  ascent: number | null;
  /** For stairs and ramps: that of going down; negative for `speed`. */
  speedDown: number;
}

/** What may be given of PatchDef. */
export interface PatchDefInit {
  /** Name for display: "Net", "Pool"...; null for none. */
  readonly name?: string | null | undefined;
  /** Corners of a simple polygon, convex or not [m]. */
  readonly polygon?: PolygonInit | undefined;
  /** Its motion; empty for a patch that stands still. */
  readonly path?: TimedPathInit | undefined;
  /** Clip played on it: an index into the world's clips. */
  readonly motion?: MotionIndex | undefined;
  /** Travel speed relative to running, above 0; negative for the clip's. */
  readonly speed?: number | undefined;
  /** For stairs and ramps: heading of the way up, where `speed` is that of going up [rad]. Null: level ground. */
  readonly ascent?: number | null | undefined;
  /** For stairs and ramps: that of going down; negative for `speed`. */
  readonly speedDown?: number | undefined;
}

/** How many people a source has let in by a time. */
export interface Arrivals {
  /** Time of the world [s]. */
  time: number;
  /** That come at this time. */
  count: number;
}

/** Describes an area, where people leave the world, come into it, or wait. It is no obstacle. */
export interface AreaDef {
  /** Name for display: "Main exit"; null for none. */
  name: string;
  /** What it does. */
  kind: AreaKind;
  /** Corners of a simple polygon, convex or not [m]. */
  polygon: Polygon;
  /** False: nobody leaves or comes here for now. */
  open: boolean;
  /**
   * For Exit: the most people who leave in a second, 0 to 1000 [1/s]; 0 for as many as come. For Source: how many
   * come in a second on average, at random times by the world's seed, 0 to 1000.
   */
  rate: number;
  /** For Exit: a line in which people queue, from who is next to the last [m]; none for a crowd. */
  queue: Vec2[];
  /** For Source in a WorldDef: index of the group whom its people join. */
  group: number;
  /** For Exit: when it opens [s]; for Source with a rate: when it begins. */
  from: number;
  /** For Exit: when it closes [s]; for Source with a rate: when it ends. */
  until: number;
  /** For Source with a rate: how many come in all; 0 for no end. */
  most: number;
  /** For Source: further people, by ascending times. */
  timetable: Arrivals[];
}

/** What may be given of AreaDef. */
export interface AreaDefInit {
  /** Name for display: "Main exit"; null for none. */
  readonly name?: string | null | undefined;
  /** What it does. */
  readonly kind?: AreaKind | undefined;
  /** Corners of a simple polygon, convex or not [m]. */
  readonly polygon?: PolygonInit | undefined;
  /** False: nobody leaves or comes here for now. */
  readonly open?: boolean | undefined;
  /**
   * For Exit: the most people who leave in a second, 0 to 1000 [1/s]; 0 for as many as come. For Source: how many
   * come in a second on average, at random times by the world's seed, 0 to 1000.
   */
  readonly rate?: number | undefined;
  /** For Exit: a line in which people queue, from who is next to the last [m]; none for a crowd. */
  readonly queue?: readonly Vec2[] | Float64Array | undefined;
  /** For Source in a WorldDef: index of the group whom its people join. */
  readonly group?: number | undefined;
  /** For Exit: when it opens [s]; for Source with a rate: when it begins. */
  readonly from?: number | undefined;
  /** For Exit: when it closes [s]; for Source with a rate: when it ends. */
  readonly until?: number | undefined;
  /** For Source with a rate: how many come in all; 0 for no end. */
  readonly most?: number | undefined;
  /** For Source: further people, by ascending times. */
  readonly timetable?: readonly Arrivals[] | undefined;
}

/** An item, which a character collects by coming within its radius. */
export interface ItemDef {
  /** Centre [m]. */
  position: Vec2;
  /** Radius, above 0 [m]. */
  radius: number;
}

/** What may be given of ItemDef. */
export interface ItemDefInit {
  /** Centre [m]. */
  readonly position?: Vec2 | undefined;
  /** Radius, above 0 [m]. */
  readonly radius?: number | undefined;
}

/** The body of a character. A number of 0 stands for the parameter of that name. */
export interface Body {
  /** Radius, 0 or 0.05 to 1.5 [m]. */
  radius: number;
  /** Top speed in the open, 0 or 0.01 to 50 [m/s]. */
  maxSpeed: number;
  /** Top acceleration, 0 or 0.01 to 1000 [m/s^2]. */
  acceleration: number;
  /** Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less. */
  mass: number;
  /** Units that it supplies to places, above 0 and at most 1000. */
  supply: number;
  /** Class, for roles; 0 for none. */
  unitClass: number;
  /** Time that it keeps from who is ahead, 0 or 0.02 to 5 [s]. */
  headway: number;
  /** Time from its first order until it sets out, 0 to 1e7 [s]; no parameter. */
  premovement: number;
  /** Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'. */
  upstairs: number;
  /** Speed down stairs as a share of that in the open, 0.01 to 1; 0: the stairs'. */
  downstairs: number;
}

/** What may be given of Body. */
export interface BodyInit {
  /** Radius, 0 or 0.05 to 1.5 [m]. */
  readonly radius?: number | undefined;
  /** Top speed in the open, 0 or 0.01 to 50 [m/s]. */
  readonly maxSpeed?: number | undefined;
  /** Top acceleration, 0 or 0.01 to 1000 [m/s^2]. */
  readonly acceleration?: number | undefined;
  /** Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less. */
  readonly mass?: number | undefined;
  /** Units that it supplies to places, above 0 and at most 1000. */
  readonly supply?: number | undefined;
  /** Class, for roles; 0 for none. */
  readonly unitClass?: number | undefined;
  /** Time that it keeps from who is ahead, 0 or 0.02 to 5 [s]. */
  readonly headway?: number | undefined;
  /** Time from its first order until it sets out, 0 to 1e7 [s]; no parameter. */
  readonly premovement?: number | undefined;
  /** Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'. */
  readonly upstairs?: number | undefined;
  /** Speed down stairs as a share of that in the open, 0.01 to 1; 0: the stairs'. */
  readonly downstairs?: number | undefined;
}

/**
 * Characters of a class take their places in a part of the formation: as many as there are such characters. Roles
 * choose in their order; who is of no role takes what is left. (Ranks by class: several roles in front.)
 */
export interface RoleDef {
  /** Where. */
  area: RoleArea;
  /** Who, 1 or more. */
  unitClass: number;
}

/**
 * The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not drawn, and
 * what lies inside is drawn in its proportions. A constant is as it is.
 */
export interface Distribution {
  /** Its kind. */
  spread: Spread;
  /** First number, in the unit of what is drawn but for LogNormal. */
  a: number;
  /** Second number; not read for Constant. */
  b: number;
  /** The smallest value that occurs. */
  least: number;
  /** The largest one. */
  most: number;
}

/** What may be given of Distribution. */
export interface DistributionInit {
  /** Its kind. */
  readonly spread?: Spread | undefined;
  /** First number, in the unit of what is drawn but for LogNormal. */
  readonly a?: number | undefined;
  /** Second number; not read for Constant. */
  readonly b?: number | undefined;
  /** The smallest value that occurs. */
  readonly least?: number | undefined;
  /** The largest one. */
  readonly most?: number | undefined;
}

/**
 * One sort of persons in a group. What is constantly 0 is not drawn: it is that of GroupDef.bodies, or of the
 * parameters where that is 0, too.
 */
export interface PeopleDef {
  /** Name for display: "Women over 50"; null for none. */
  name: string;
  /** Share of the group, above 0; shares are divided by their sum. */
  share: number;
  /** Class, for roles; 0 for none. */
  unitClass: number;
  /** Top speed in the open, 0 or 0.01 to 50 [m/s]. */
  speed: Distribution;
  /** Radius of the body, 0 or 0.05 to 1.5 [m]. */
  radius: Distribution;
  /** Time that it keeps from who is ahead, 0 or 0.02 to 5 [s]. */
  headway: Distribution;
  /** Time until it sets out on its first order, 0 to 1e7 [s]. */
  premovement: Distribution;
  /** Age, 0 or 5 to 90 [years]; above 0 it gives the top speed in the place of `speed`, as RiMEA has it. */
  age: Distribution;
  /** Speed up stairs as a share of that in the open, 0 or 0.01 to 1. */
  upstairs: number;
  /** Speed down stairs as a share of that in the open, 0 or 0.01 to 1. */
  downstairs: number;
}

/** What may be given of PeopleDef. */
export interface PeopleDefInit {
  /** Name for display: "Women over 50"; null for none. */
  readonly name?: string | null | undefined;
  /** Share of the group, above 0; shares are divided by their sum. */
  readonly share?: number | undefined;
  /** Class, for roles; 0 for none. */
  readonly unitClass?: number | undefined;
  /** Top speed in the open, 0 or 0.01 to 50 [m/s]. */
  readonly speed?: DistributionInit | undefined;
  /** Radius of the body, 0 or 0.05 to 1.5 [m]. */
  readonly radius?: DistributionInit | undefined;
  /** Time that it keeps from who is ahead, 0 or 0.02 to 5 [s]. */
  readonly headway?: DistributionInit | undefined;
  /** Time until it sets out on its first order, 0 to 1e7 [s]. */
  readonly premovement?: DistributionInit | undefined;
  /** Age, 0 or 5 to 90 [years]; above 0 it gives the top speed in the place of `speed`, as RiMEA has it. */
  readonly age?: DistributionInit | undefined;
  /** Speed up stairs as a share of that in the open, 0 or 0.01 to 1. */
  readonly upstairs?: number | undefined;
  /** Speed down stairs as a share of that in the open, 0 or 0.01 to 1. */
  readonly downstairs?: number | undefined;
}

/** Describes a formation in its local axes: it faces +x, its centre is the origin. */
export interface FormationDef {
  /** Shape. */
  kind: FormationKind;
  /** Distance between neighbouring places, 0.05 to 100 [m]. */
  spacing: number;
  /** Full angle of Pacman's mouth or of the crescent's gap, above 0 and at most 6 [rad]. */
  opening: number;
  /** For Outline: the shape, in any size [m]. */
  outline: Polygon;
  /** Its holes, clockwise, apart from each other [m]. */
  holes: Polygon[];
  /** For Points: the places in this order [m]; at least as many as characters. */
  points: Vec2[];
  /** For Square: how many stand abreast, 0 to 200,000; 0 for about as many as there are ranks. */
  files: number;
}

/** What may be given of FormationDef. */
export interface FormationDefInit {
  /** Shape. */
  readonly kind?: FormationKind | undefined;
  /** Distance between neighbouring places, 0.05 to 100 [m]. */
  readonly spacing?: number | undefined;
  /** Full angle of Pacman's mouth or of the crescent's gap, above 0 and at most 6 [rad]. */
  readonly opening?: number | undefined;
  /** For Outline: the shape, in any size [m]. */
  readonly outline?: PolygonInit | undefined;
  /** Its holes, clockwise, apart from each other [m]. */
  readonly holes?: readonly PolygonInit[] | undefined;
  /** For Points: the places in this order [m]; at least as many as characters. */
  readonly points?: readonly Vec2[] | Float64Array | undefined;
  /** For Square: how many stand abreast, 0 to 200,000; 0 for about as many as there are ranks. */
  readonly files?: number | undefined;
}

/** One order of a group. */
export interface Order {
  /** What it asks for. */
  kind: OrderKind;
  /** How it goes. */
  manner: Manner;
  /** How it turns on a march. */
  turn: Turn;
  /** Centre of the formation at the end [m]; of the rectangle for Guard. */
  target: Vec2;
  /** Heading at the end [rad]. Null: that of the last stretch. */
  facing: number | null;
  /**
   * Width of the front of a formation in ranks (square, line, column), which becomes a square of so many files
   * [m]; 0 for its own. Other shapes keep theirs.
   */
  width: number;
  /** Drawn way to the target [m]; followed as drawn, round obstacles. */
  route: Vec2[];
  /** New formation, which is taken up on the way; null to keep it. */
  formation: FormationDef | null;
  /** Speed of a march [m/s]; 0 for as fast as all can keep up with. */
  pace: number;
  /** Share of the group that must have arrived before the next order begins, (0, 1]. */
  share: number;
  /** For Follow and Guard: the group to stay with; 0 for a character or a place. */
  group: GroupId;
  /** For Follow and Guard: id of the character to stay with; 0 for none. */
  character: CharacterId;
  /** For Follow: from its centre to the formation's, in its axes [m]. */
  offset: Vec2;
  /** For Guard: half the length and half the width of the rectangle [m]. */
  halfSize: Vec2;
  /** For Guard: how the rectangle moves from `target` on. */
  path: TimedPath;
  /** For Leave: by which exits; none for all. */
  exits: number[];
  /** For Leave: by which of them each goes. */
  choice: ExitChoice;
  /** For Leave: seconds by which each of `exits` counts as nearer than it is, -1e6 to 1e6 [s]. */
  attractions: number[];
  /** For Leave: seconds by which an exit counts as nearer if all others nearby choose it, 0 to 1e6 [s]. */
  herding: number;
  /**
   * For Leave: deviation of the error by which each misjudges the time by an exit, drawn by the world's seed, 0 to
   * 1e6 [s].
   */
  misjudgement: number;
  /** For Wait: the waiting area. */
  area: AreaId;
  /** For Wait: how long, from when its share has come, 0 to 1e9 [s]; 0 for no end. */
  seconds: number;
}

/** What may be given of Order. */
export interface OrderInit {
  /** What it asks for. */
  readonly kind?: OrderKind | undefined;
  /** How it goes. */
  readonly manner?: Manner | undefined;
  /** How it turns on a march. */
  readonly turn?: Turn | undefined;
  /** Centre of the formation at the end [m]; of the rectangle for Guard. */
  readonly target?: Vec2 | undefined;
  /** Heading at the end [rad]. Null: that of the last stretch. */
  readonly facing?: number | null | undefined;
  /**
   * Width of the front of a formation in ranks (square, line, column), which becomes a square of so many files
   * [m]; 0 for its own. Other shapes keep theirs.
   */
  readonly width?: number | undefined;
  /** Drawn way to the target [m]; followed as drawn, round obstacles. */
  readonly route?: readonly Vec2[] | Float64Array | undefined;
  /** New formation, which is taken up on the way; null to keep it. */
  readonly formation?: FormationDefInit | null | undefined;
  /** Speed of a march [m/s]; 0 for as fast as all can keep up with. */
  readonly pace?: number | undefined;
  /** Share of the group that must have arrived before the next order begins, (0, 1]. */
  readonly share?: number | undefined;
  /** For Follow and Guard: the group to stay with; 0 for a character or a place. */
  readonly group?: GroupId | undefined;
  /** For Follow and Guard: id of the character to stay with; 0 for none. */
  readonly character?: CharacterId | undefined;
  /** For Follow: from its centre to the formation's, in its axes [m]. */
  readonly offset?: Vec2 | undefined;
  /** For Guard: half the length and half the width of the rectangle [m]. */
  readonly halfSize?: Vec2 | undefined;
  /** For Guard: how the rectangle moves from `target` on. */
  readonly path?: TimedPathInit | undefined;
  /** For Leave: by which exits; none for all. */
  readonly exits?: ArrayLike<number> | undefined;
  /** For Leave: by which of them each goes. */
  readonly choice?: ExitChoice | undefined;
  /** For Leave: seconds by which each of `exits` counts as nearer than it is, -1e6 to 1e6 [s]. */
  readonly attractions?: ArrayLike<number> | undefined;
  /** For Leave: seconds by which an exit counts as nearer if all others nearby choose it, 0 to 1e6 [s]. */
  readonly herding?: number | undefined;
  /**
   * For Leave: deviation of the error by which each misjudges the time by an exit, drawn by the world's seed, 0 to
   * 1e6 [s].
   */
  readonly misjudgement?: number | undefined;
  /** For Wait: the waiting area. */
  readonly area?: AreaId | undefined;
  /** For Wait: how long, from when its share has come, 0 to 1e9 [s]; 0 for no end. */
  readonly seconds?: number | undefined;
}

/** An order in a group's queue. */
export interface QueuedOrder {
  /** Unique in the world; it is not used again. */
  readonly id: OrderId;
  /** What is to be done. */
  readonly order: Order;
}

/** How a group behaves, whatever its orders. */
export interface Conduct {
  /** Who makes room. */
  stance: Stance;
  /** 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1]. */
  cohesion: number;
  /** Share of its width that it may give up in narrow passages, [0, 1]; 0 for none. */
  squeeze: number;
  /** True: its mesh gives way to other meshes and to moving obstacles. */
  avoids: boolean;
}

/** What may be given of Conduct. */
export interface ConductInit {
  /** Who makes room. */
  readonly stance?: Stance | undefined;
  /** 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1]. */
  readonly cohesion?: number | undefined;
  /** Share of its width that it may give up in narrow passages, [0, 1]; 0 for none. */
  readonly squeeze?: number | undefined;
  /** True: its mesh gives way to other meshes and to moving obstacles. */
  readonly avoids?: boolean | undefined;
}

/** A group of characters with one mesh. */
export interface GroupDef {
  /** Name for display; null for none. */
  name: string;
  /**
   * Number of characters, 1 to 200,000, or 0 where a source sends some; at most 5,000 in all groups with exact
   * plans.
   */
  count: number;
  /** Shape and spacing of the places. */
  formation: FormationDef;
  /** Centre of the formation [m]. */
  position: Vec2;
  /** Heading, counter-clockwise from +x [rad]. */
  angle: number;
  /** Initial positions of characters [m]; none to start on their places. */
  starts: Vec2[];
  /** Largest random displacement of initial positions, 0 or more [m]. */
  jitter: number;
  /** One for all, or one for each character; none for the parameters'. */
  bodies: Body[];
  /** Which class stands where. */
  roles: RoleDef[];
  /** Units of supply that each place demands; none for 1 each. */
  demands: number[];
  /** How it behaves. */
  conduct: Conduct;
  /** What it is to do at first, one after the other. */
  orders: Order[];
  /** True: orders that are done come last again. */
  patrols: boolean;
  /** Colour for display, 0xRRGGBB. Null: the palette's. */
  colour: number | null;
  /** Build of its drawn bodies. Null: both, by the character's id. */
  build: BodyBuild | null;
  /** How it walks and jogs. Null: the plain manner. */
  motions: MotionSet | null;
  /**
   * Sorts of persons, who also come by sources. A number that a sort draws goes before that of `bodies`; what it
   * does not draw, and acceleration, mass and supply, is that of `bodies`.
   */
  people: PeopleDef[];
}

/** What may be given of GroupDef. */
export interface GroupDefInit {
  /** Name for display; null for none. */
  readonly name?: string | null | undefined;
  /**
   * Number of characters, 1 to 200,000, or 0 where a source sends some; at most 5,000 in all groups with exact
   * plans.
   */
  readonly count?: number | undefined;
  /** Shape and spacing of the places. */
  readonly formation?: FormationDefInit | undefined;
  /** Centre of the formation [m]. */
  readonly position?: Vec2 | undefined;
  /** Heading, counter-clockwise from +x [rad]. */
  readonly angle?: number | undefined;
  /** Initial positions of characters [m]; none to start on their places. */
  readonly starts?: readonly Vec2[] | Float64Array | undefined;
  /** Largest random displacement of initial positions, 0 or more [m]. */
  readonly jitter?: number | undefined;
  /** One for all, or one for each character; none for the parameters'. */
  readonly bodies?: readonly BodyInit[] | undefined;
  /** Which class stands where. */
  readonly roles?: readonly RoleDef[] | undefined;
  /** Units of supply that each place demands; none for 1 each. */
  readonly demands?: ArrayLike<number> | undefined;
  /** How it behaves. */
  readonly conduct?: ConductInit | undefined;
  /** What it is to do at first, one after the other. */
  readonly orders?: readonly OrderInit[] | undefined;
  /** True: orders that are done come last again. */
  readonly patrols?: boolean | undefined;
  /** Colour for display, 0xRRGGBB. Null: the palette's. */
  readonly colour?: number | null | undefined;
  /** Build of its drawn bodies. Null: both, by the character's id. */
  readonly build?: BodyBuild | null | undefined;
  /** How it walks and jogs. Null: the plain manner. */
  readonly motions?: MotionSet | null | undefined;
  /**
   * Sorts of persons, who also come by sources. A number that a sort draws goes before that of `bodies`; what it
   * does not draw, and acceleration, mass and supply, is that of `bodies`.
   */
  readonly people?: readonly PeopleDefInit[] | undefined;
}

/** The colour of a group. */
export interface GroupColour {
  /** Colour for display, 0xRRGGBB. Null: the palette's. */
  colour: number | null;
}

/** What may be given of GroupColour. */
export interface GroupColourInit {
  /** Colour for display, 0xRRGGBB. Null: the palette's. */
  readonly colour?: number | null | undefined;
}

/** How the people of a group look. */
export interface GroupLook {
  /** Build of its drawn bodies. Null: both, by the character's id. */
  build: BodyBuild | null;
  /** How it walks and jogs. Null: the plain manner. */
  motions: MotionSet | null;
}

/** What may be given of GroupLook. */
export interface GroupLookInit {
  /** Build of its drawn bodies. Null: both, by the character's id. */
  readonly build?: BodyBuild | null | undefined;
  /** How it walks and jogs. Null: the plain manner. */
  readonly motions?: MotionSet | null | undefined;
}

/** A disc that changes the formation of a group which passes it. */
export interface CheckpointDef {
  /** Centre [m]. */
  position: Vec2;
  /** Radius, above 0 [m]. */
  radius: number;
  /** New formation of the group. */
  formation: FormationDef;
  /** Index of the group that it applies to; -1 for all groups. */
  group: number;
  /** True: it applies once per group. False: whenever a group enters. */
  once: boolean;
  /** What passes it. */
  trigger: CheckpointTrigger;
  /** For Crowd: share of the group, (0, 1]. */
  share: number;
}

/** What may be given of CheckpointDef. */
export interface CheckpointDefInit {
  /** Centre [m]. */
  readonly position?: Vec2 | undefined;
  /** Radius, above 0 [m]. */
  readonly radius?: number | undefined;
  /** New formation of the group. */
  readonly formation?: FormationDefInit | undefined;
  /** Index of the group that it applies to; -1 for all groups. */
  readonly group?: number | undefined;
  /** True: it applies once per group. False: whenever a group enters. */
  readonly once?: boolean | undefined;
  /** What passes it. */
  readonly trigger?: CheckpointTrigger | undefined;
  /** For Crowd: share of the group, (0, 1]. */
  readonly share?: number | undefined;
}

/** Describes a world. */
export interface WorldDef {
  /** Title for display; null for none. */
  name: string;
  /** Description in one or two sentences; null for none. */
  description: string;
  /** Credit for the data it uses; null for none. */
  credit: string;
  /** File of its gestures, in the scenario's folder or below, which worlds do not read; null for none. */
  gestures: string;
  /** Extent of the ground [m]. */
  box: Box;
  /** Edge of a ground cell, above 0 [m]. */
  cell: number;
  /** Seed of all random numbers. */
  seed: bigint;
  /** Facts of clips, which patches name by their index. */
  clips: ClipFacts[];
  /** At most 20,000 obstacles. */
  obstacles: ObstacleDef[];
  /** At most 20,000 patches. */
  patches: PatchDef[];
  /** Map that adds obstacles and patches; null for no map. */
  map: MapDef | null;
  /** At most 20,000 groups. */
  groups: GroupDef[];
  /** Discs that change formations. */
  checkpoints: CheckpointDef[];
  /** Items to collect. */
  items: ItemDef[];
  /** Exits, sources and waiting areas; at most 1,000. */
  areas: AreaDef[];
  /** True: the left and the right side of `box` are joined. Who walks out on one side comes in on the other. */
  ring: boolean;
  /** Preset of parameters, "units", "people" or "paper"; null for "units". */
  preset: string;
  /** Parameters that differ from the preset, set in this order. */
  parameters: ParameterValue[];
}

/** What may be given of WorldDef. */
export interface WorldDefInit {
  /** Title for display; null for none. */
  readonly name?: string | null | undefined;
  /** Description in one or two sentences; null for none. */
  readonly description?: string | null | undefined;
  /** Credit for the data it uses; null for none. */
  readonly credit?: string | null | undefined;
  /** File of its gestures, in the scenario's folder or below, which worlds do not read; null for none. */
  readonly gestures?: string | null | undefined;
  /** Extent of the ground [m]. */
  readonly box?: Box | undefined;
  /** Edge of a ground cell, above 0 [m]. */
  readonly cell?: number | undefined;
  /** Seed of all random numbers. */
  readonly seed?: bigint | number | undefined;
  /** Facts of clips, which patches name by their index. */
  readonly clips?: readonly ClipFactsInit[] | undefined;
  /** At most 20,000 obstacles. */
  readonly obstacles?: readonly ObstacleDefInit[] | undefined;
  /** At most 20,000 patches. */
  readonly patches?: readonly PatchDefInit[] | undefined;
  /** Map that adds obstacles and patches; null for no map. */
  readonly map?: MapDefInit | null | undefined;
  /** At most 20,000 groups. */
  readonly groups?: readonly GroupDefInit[] | undefined;
  /** Discs that change formations. */
  readonly checkpoints?: readonly CheckpointDefInit[] | undefined;
  /** Items to collect. */
  readonly items?: readonly ItemDefInit[] | undefined;
  /** Exits, sources and waiting areas; at most 1,000. */
  readonly areas?: readonly AreaDefInit[] | undefined;
  /** True: the left and the right side of `box` are joined. Who walks out on one side comes in on the other. */
  readonly ring?: boolean | undefined;
  /** Preset of parameters, "units", "people" or "paper"; null for "units". */
  readonly preset?: string | null | undefined;
  /** Parameters that differ from the preset, set in this order. */
  readonly parameters?: readonly ParameterValueInit[] | undefined;
}

/** Position, angle and velocities on a path at one time. */
export interface PathState {
  /** Position and angle. */
  readonly at: Waypoint;
  /** Velocity [m/s]. */
  readonly velocity: Vec2;
  /** Angular velocity [rad/s]. */
  readonly angularVelocity: number;
}

/** What would come of an order. */
export interface Forecast {
  /** True where the target can be reached. */
  readonly arrives: boolean;
  /** The way of the formation's centre, both ends included [m]. */
  readonly way: Float64Array;
  /** Where the formation would stand: the target, or the nearest ground to it [m]. */
  readonly end: Vec2;
  /** Time until it would arrive [s]; infinite where it never does. */
  readonly seconds: number;
}

/** Describes one parameter. */
export interface ParameterInfo {
  /** Name in files and messages: "plan.exponent". */
  readonly name: string;
  /** "m", "s", "m/s", "1", "switch", "mode", "steps", "count"... */
  readonly unit: string;
  /** Smallest allowed value. */
  readonly minimum: number;
  /** Largest allowed value. */
  readonly maximum: number;
  /** Value of the preset "units". */
  readonly standard: number;
  /** True where only whole numbers are valid: switches, modes, steps and counts. */
  readonly whole: boolean;
  /** One sentence. */
  readonly description: string;
}

/**
 * A finger touches down, moves or lifts, or its control ends at once. One that comes down edits the group whose
 * mesh is nearest within `input.reach`, or `group` if given; when it has lifted, its trajectory is still followed.
 */
export interface Touch {
  /** What it does. */
  phase: TouchPhase;
  /** Number of the finger, unique per client while it is down. */
  touch: number;
  /** For Down and Move: position in the world [m]. */
  position: Vec2;
  /** World time stamp [s]; not read for Cancel. */
  time: number;
  /** For Down: group to edit; 0 to pick it by position. */
  group: GroupId;
}

/** What may be given of Touch. */
export interface TouchInit {
  /** What it does. */
  readonly phase?: TouchPhase | undefined;
  /** Number of the finger, unique per client while it is down. */
  readonly touch?: number | undefined;
  /** For Down and Move: position in the world [m]. */
  readonly position?: Vec2 | undefined;
  /** World time stamp [s]; not read for Cancel. */
  readonly time?: number | undefined;
  /** For Down: group to edit; 0 to pick it by position. */
  readonly group?: GroupId | undefined;
}

/**
 * Makes a control of all its points at once, for mouse and programs. Its points are then moved and lifted like
 * touches.
 */
export interface AddControl {
  /** Group whose mesh it controls. */
  group: GroupId;
  /** Kind of control, which must fit the number of touches. */
  kind: ControlKind;
  /** Numbers of its fingers, 1 to 64. */
  touches: number[];
  /** Positions in the world, one per touch [m]. */
  positions: Vec2[];
  /** World time stamp [s]. */
  time: number;
}

/** What may be given of AddControl. */
export interface AddControlInit {
  /** Group whose mesh it controls. */
  readonly group?: GroupId | undefined;
  /** Kind of control, which must fit the number of touches. */
  readonly kind?: ControlKind | undefined;
  /** Numbers of its fingers, 1 to 64. */
  readonly touches?: ArrayLike<number> | undefined;
  /** Positions in the world, one per touch [m]. */
  readonly positions?: readonly Vec2[] | Float64Array | undefined;
  /** World time stamp [s]. */
  readonly time?: number | undefined;
}

/** Pins a control at the end of its trajectory, releases it, or ends it at once. */
export interface EditControl {
  /** Group that the control belongs to. */
  group: GroupId;
  /** Its id. */
  control: ControlId;
  /** What is done to it. */
  edit: ControlEdit;
}

/** What may be given of EditControl. */
export interface EditControlInit {
  /** Group that the control belongs to. */
  readonly group?: GroupId | undefined;
  /** Its id. */
  readonly control?: ControlId | undefined;
  /** What is done to it. */
  readonly edit?: ControlEdit | undefined;
}

/** A client has disconnected: all its fingers lift. */
export interface ReleaseClient {
  /** Not used; 0. */
  unused: number;
}

/** What may be given of ReleaseClient. */
export interface ReleaseClientInit {
  /** Not used; 0. */
  readonly unused?: number | undefined;
}

/**
 * Changes what a group is. What is not given stays as it is. First comes the formation with its number of places,
 * then the sorts of people, who joins or leaves, and all else. Where one of them cannot be, none is changed.
 */
export interface ChangeGroup {
  /** Group to change. */
  group: GroupId;
  /** Its formation; null for the one that it has. */
  formation: FormationDef | null;
  /**
   * Its number of characters: new ones join behind the mesh, those with the highest ids leave first. Null: the
   * number that it has.
   */
  count: number | null;
  /**
   * Its sorts of persons, none where all are as GroupDef.bodies say. Persons who join it are drawn by them from
   * now on. Its present members are drawn again, as those who come at once: each number that neither the sorts
   * before nor these draw stays as it is. A person who has heard an order sets out when it was to. Null: the sorts
   * that it has.
   */
  people: PeopleDef[] | null;
  /** How it behaves; null for as it does. */
  conduct: Conduct | null;
  /** Which class stands where, in the order in which they choose places. Null: the roles that it has. */
  roles: RoleDef[] | null;
  /**
   * How many units of supply each place demands, 0 to 1000, of each place, or none for 1 each. Null: the demands
   * that these have.
   */
  demands: number[] | null;
  /** Its name, of at most 4,096 bytes. Null: the one that it has. */
  name: string | null;
  /** Its colour; null for the one that it has. */
  colour: GroupColour | null;
  /** How its people look; null for as they do. */
  look: GroupLook | null;
}

/** What may be given of ChangeGroup. */
export interface ChangeGroupInit {
  /** Group to change. */
  readonly group?: GroupId | undefined;
  /** Its formation; null for the one that it has. */
  readonly formation?: FormationDefInit | null | undefined;
  /**
   * Its number of characters: new ones join behind the mesh, those with the highest ids leave first. Null: the
   * number that it has.
   */
  readonly count?: number | null | undefined;
  /**
   * Its sorts of persons, none where all are as GroupDef.bodies say. Persons who join it are drawn by them from
   * now on. Its present members are drawn again, as those who come at once: each number that neither the sorts
   * before nor these draw stays as it is. A person who has heard an order sets out when it was to. Null: the sorts
   * that it has.
   */
  readonly people?: readonly PeopleDefInit[] | null | undefined;
  /** How it behaves; null for as it does. */
  readonly conduct?: ConductInit | null | undefined;
  /** Which class stands where, in the order in which they choose places. Null: the roles that it has. */
  readonly roles?: readonly RoleDef[] | null | undefined;
  /**
   * How many units of supply each place demands, 0 to 1000, of each place, or none for 1 each. Null: the demands
   * that these have.
   */
  readonly demands?: ArrayLike<number> | null | undefined;
  /** Its name, of at most 4,096 bytes. Null: the one that it has. */
  readonly name?: string | null | undefined;
  /** Its colour; null for the one that it has. */
  readonly colour?: GroupColourInit | null | undefined;
  /** How its people look; null for as they do. */
  readonly look?: GroupLookInit | null | undefined;
}

/**
 * Moves the mesh of a group at once; its places and its characters walk there, or stand there at once. Its orders
 * and controls end.
 */
export interface SetPose {
  /** Group to move. */
  group: GroupId;
  /** New centre of the mesh in the world [m]. */
  position: Vec2;
  /** New heading, counter-clockwise from +x [rad]. */
  angle: number;
  /** True: its places and characters are there at once, and stand still. */
  characters: boolean;
}

/** What may be given of SetPose. */
export interface SetPoseInit {
  /** Group to move. */
  readonly group?: GroupId | undefined;
  /** New centre of the mesh in the world [m]. */
  readonly position?: Vec2 | undefined;
  /** New heading, counter-clockwise from +x [rad]. */
  readonly angle?: number | undefined;
  /** True: its places and characters are there at once, and stand still. */
  readonly characters?: boolean | undefined;
}

/** Adds a group. */
export interface AddGroup {
  /** Its definition. */
  group: GroupDef;
}

/** What may be given of AddGroup. */
export interface AddGroupInit {
  /** Its definition. */
  readonly group?: GroupDefInit | undefined;
}

/** Removes a group and its characters. */
export interface RemoveGroup {
  /** Group to remove. */
  group: GroupId;
}

/** What may be given of RemoveGroup. */
export interface RemoveGroupInit {
  /** Group to remove. */
  readonly group?: GroupId | undefined;
}

/**
 * Puts a thing into the place, or gives one another definition. Exactly one of the five definitions says what it
 * is. An item that is collected stays so, and a checkpoint stays passed by the groups that have passed it.
 */
export interface PutThing {
  /** Thing that gets another definition; 0 to add one. */
  id: number;
  /** An obstacle; null for other things. */
  obstacle: ObstacleDef | null;
  /** A patch; null for other things. */
  patch: PatchDef | null;
  /** An item to collect; null for other things. */
  item: ItemDef | null;
  /** A formation checkpoint, whose `group` is not read; null for other things. */
  checkpoint: CheckpointDef | null;
  /** An area, whose `group` is not read; null for other things. */
  area: AreaDef | null;
  /** Group that a checkpoint concerns, 0 for any, or that people of a source join. */
  group: GroupId;
}

/** What may be given of PutThing. */
export interface PutThingInit {
  /** Thing that gets another definition; 0 to add one. */
  readonly id?: number | undefined;
  /** An obstacle; null for other things. */
  readonly obstacle?: ObstacleDefInit | null | undefined;
  /** A patch; null for other things. */
  readonly patch?: PatchDefInit | null | undefined;
  /** An item to collect; null for other things. */
  readonly item?: ItemDefInit | null | undefined;
  /** A formation checkpoint, whose `group` is not read; null for other things. */
  readonly checkpoint?: CheckpointDefInit | null | undefined;
  /** An area, whose `group` is not read; null for other things. */
  readonly area?: AreaDefInit | null | undefined;
  /** Group that a checkpoint concerns, 0 for any, or that people of a source join. */
  readonly group?: GroupId | undefined;
}

/** Removes a thing. People on their way to an area that is removed go to the other areas of their order, or stand. */
export interface RemoveThing {
  /** What it is. */
  thing: ThingKind;
  /** Its id. */
  id: number;
}

/** What may be given of RemoveThing. */
export interface RemoveThingInit {
  /** What it is. */
  readonly thing?: ThingKind | undefined;
  /** Its id. */
  readonly id?: number | undefined;
}

/** Changes the value of a parameter. */
export interface SetParameter {
  /** Name in parameterTable(): "plan.exponent"; null for none. */
  name: string;
  /** New value, in the range of the parameter. */
  value: number;
}

/** What may be given of SetParameter. */
export interface SetParameterInit {
  /** Name in parameterTable(): "plan.exponent"; null for none. */
  readonly name?: string | null | undefined;
  /** New value, in the range of the parameter. */
  readonly value?: number | undefined;
}

/** Puts an order into a group's queue. The event OrderGiven tells its id. */
export interface GiveOrder {
  /** The group. */
  group: GroupId;
  /** Where the order stands in the queue. */
  mode: QueueMode;
  /** For Insert: before which order, counted from 0. */
  index: number;
  /** The order. */
  order: Order;
}

/** What may be given of GiveOrder. */
export interface GiveOrderInit {
  /** The group. */
  readonly group?: GroupId | undefined;
  /** Where the order stands in the queue. */
  readonly mode?: QueueMode | undefined;
  /** For Insert: before which order, counted from 0. */
  readonly index?: number | undefined;
  /** The order. */
  readonly order?: OrderInit | undefined;
}

/** Changes a group's queue. */
export interface EditQueue {
  /** The group. */
  group: GroupId;
  /** What is done to the queue. */
  edit: QueueEdit;
  /** For Cancel: the id of the order; 0 for all. */
  order: OrderId;
}

/** What may be given of EditQueue. */
export interface EditQueueInit {
  /** The group. */
  readonly group?: GroupId | undefined;
  /** What is done to the queue. */
  readonly edit?: QueueEdit | undefined;
  /** For Cancel: the id of the order; 0 for all. */
  readonly order?: OrderId | undefined;
}

/** Characters join a group where they stand; places are added to its formation. Events Joined tell their ids. */
export interface AddCharacters {
  /** Group that they join. */
  group: GroupId;
  /** Where they stand [m]; they part where they would stand in each other. */
  positions: Vec2[];
  /** One for each, or one for all; none for that of the group. */
  bodies: Body[];
}

/** What may be given of AddCharacters. */
export interface AddCharactersInit {
  /** Group that they join. */
  readonly group?: GroupId | undefined;
  /** Where they stand [m]; they part where they would stand in each other. */
  readonly positions?: readonly Vec2[] | Float64Array | undefined;
  /** One for each, or one for all; none for that of the group. */
  readonly bodies?: readonly BodyInit[] | undefined;
}

/**
 * Characters leave their groups for another one, or leave the world. Ids, positions and velocities stay. The ranks
 * behind them close up; a group may become empty, and stays.
 */
export interface TransferCharacters {
  /** Their ids. */
  ids: number[];
  /** Group that they join; 0 to leave the world. */
  group: GroupId;
}

/** What may be given of TransferCharacters. */
export interface TransferCharactersInit {
  /** Their ids. */
  readonly ids?: ArrayLike<number> | undefined;
  /** Group that they join; 0 to leave the world. */
  readonly group?: GroupId | undefined;
}

/**
 * Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops, and all
 * parts go on with the orders of the whole.
 */
export interface SplitGroup {
  /** The group. */
  group: GroupId;
  /** How it is divided. */
  by: SplitBy;
  /** For Ids: the characters that leave. */
  ids: number[];
  /** For Line: two points [m]; for Lasso: the corners of the polygon. */
  points: Vec2[];
  /** For Shares: of all parts, above 0; their sum counts as the whole. */
  shares: number[];
  /** For Shares: parts lie side by side, not one behind the other. */
  abreast: boolean;
  /** Formation of the parts. */
  shape: PartShape;
}

/** What may be given of SplitGroup. */
export interface SplitGroupInit {
  /** The group. */
  readonly group?: GroupId | undefined;
  /** How it is divided. */
  readonly by?: SplitBy | undefined;
  /** For Ids: the characters that leave. */
  readonly ids?: ArrayLike<number> | undefined;
  /** For Line: two points [m]; for Lasso: the corners of the polygon. */
  readonly points?: readonly Vec2[] | Float64Array | undefined;
  /** For Shares: of all parts, above 0; their sum counts as the whole. */
  readonly shares?: ArrayLike<number> | undefined;
  /** For Shares: parts lie side by side, not one behind the other. */
  readonly abreast?: boolean | undefined;
  /** Formation of the parts. */
  readonly shape?: PartShape | undefined;
}

/** Joins groups to the first of them; the others end. */
export interface MergeGroups {
  /** Two or more. */
  groups: number[];
  /** Smaller: the formation of the first for all; AsHeld: all places stay. */
  shape: PartShape;
}

/** What may be given of MergeGroups. */
export interface MergeGroupsInit {
  /** Two or more. */
  readonly groups?: ArrayLike<number> | undefined;
  /** Smaller: the formation of the first for all; AsHeld: all places stay. */
  readonly shape?: PartShape | undefined;
}

/** Changes what characters are. What is not given stays as it is. */
export interface ChangeCharacters {
  /** Their ids. */
  ids: number[];
  /** Their bodies, one for each or one for all. Null: those that they have. */
  bodies: Body[] | null;
  /** What moves them. Null: what moves them now. */
  driver: Driver | null;
}

/** What may be given of ChangeCharacters. */
export interface ChangeCharactersInit {
  /** Their ids. */
  readonly ids?: ArrayLike<number> | undefined;
  /** Their bodies, one for each or one for all. Null: those that they have. */
  readonly bodies?: readonly BodyInit[] | null | undefined;
  /** What moves them. Null: what moves them now. */
  readonly driver?: Driver | null | undefined;
}

/** Where characters that are moved from outside are after this step. */
export interface WriteMotion {
  /** Their ids. */
  ids: number[];
  /** Where they are [m]. */
  positions: Vec2[];
  /** Their velocities [m/s]; none for what follows from the last positions. */
  velocities: Vec2[];
}

/** What may be given of WriteMotion. */
export interface WriteMotionInit {
  /** Their ids. */
  readonly ids?: ArrayLike<number> | undefined;
  /** Where they are [m]. */
  readonly positions?: readonly Vec2[] | Float64Array | undefined;
  /** Their velocities [m/s]; none for what follows from the last positions. */
  readonly velocities?: readonly Vec2[] | Float64Array | undefined;
}

/** Reverses the orders of a group's queue: the last one begins, and what is under way comes last. */
export interface ReverseQueue {
  /** The group. */
  group: GroupId;
}

/** What may be given of ReverseQueue. */
export interface ReverseQueueInit {
  /** The group. */
  readonly group?: GroupId | undefined;
}

/** The body of each kind. */
export interface CommandBodies {
  /** Touch */
  0: Touch;
  /** AddControl */
  1: AddControl;
  /** EditControl */
  2: EditControl;
  /** ReleaseClient */
  3: ReleaseClient;
  /** ChangeGroup */
  4: ChangeGroup;
  /** SetPose */
  5: SetPose;
  /** AddGroup */
  6: AddGroup;
  /** RemoveGroup */
  7: RemoveGroup;
  /** PutThing */
  8: PutThing;
  /** RemoveThing */
  9: RemoveThing;
  /** SetParameter */
  10: SetParameter;
  /** GiveOrder */
  11: GiveOrder;
  /** EditQueue */
  12: EditQueue;
  /** AddCharacters */
  13: AddCharacters;
  /** TransferCharacters */
  14: TransferCharacters;
  /** SplitGroup */
  15: SplitGroup;
  /** MergeGroups */
  16: MergeGroups;
  /** ChangeCharacters */
  17: ChangeCharacters;
  /** WriteMotion */
  18: WriteMotion;
  /** ReverseQueue */
  19: ReverseQueue;
}

/**
 * A change of a world, with its step and sender. Commands apply in the order of (step, client, sequence). Of one
 * kind.
 */
export interface CommandOf<Kind extends keyof CommandBodies> {
  /** Which body it has. */
  kind: Kind;
  /** It applies at the start of the step from `step` to `step + 1`. */
  step: number;
  /** Number of the sender. */
  client: number;
  /** Rises with each command of a client. */
  sequence: number;
  /** The change. */
  body: CommandBodies[Kind];
}

/** A change of a world, with its step and sender. Commands apply in the order of (step, client, sequence). */
export type Command = {
  [Kind in keyof CommandBodies]: CommandOf<Kind>;
}[keyof CommandBodies];

/** What may be given of the body of each kind. */
export interface CommandBodiesInit {
  /** Touch */
  0: TouchInit;
  /** AddControl */
  1: AddControlInit;
  /** EditControl */
  2: EditControlInit;
  /** ReleaseClient */
  3: ReleaseClientInit;
  /** ChangeGroup */
  4: ChangeGroupInit;
  /** SetPose */
  5: SetPoseInit;
  /** AddGroup */
  6: AddGroupInit;
  /** RemoveGroup */
  7: RemoveGroupInit;
  /** PutThing */
  8: PutThingInit;
  /** RemoveThing */
  9: RemoveThingInit;
  /** SetParameter */
  10: SetParameterInit;
  /** GiveOrder */
  11: GiveOrderInit;
  /** EditQueue */
  12: EditQueueInit;
  /** AddCharacters */
  13: AddCharactersInit;
  /** TransferCharacters */
  14: TransferCharactersInit;
  /** SplitGroup */
  15: SplitGroupInit;
  /** MergeGroups */
  16: MergeGroupsInit;
  /** ChangeCharacters */
  17: ChangeCharactersInit;
  /** WriteMotion */
  18: WriteMotionInit;
  /** ReverseQueue */
  19: ReverseQueueInit;
}

/**
 * A change of a world, with its step and sender. Commands apply in the order of (step, client, sequence). Of one
 * kind.
 */
export interface CommandOfInit<Kind extends keyof CommandBodiesInit> {
  /** Which body it has. */
  kind: Kind;
  /** It applies at the start of the step from `step` to `step + 1`. */
  step?: number | undefined;
  /** Number of the sender. */
  client?: number | undefined;
  /** Rises with each command of a client. */
  sequence?: number | undefined;
  /** The change. */
  body?: CommandBodiesInit[Kind] | undefined;
}

/** What may be given of Command. */
export type CommandInit = {
  [Kind in keyof CommandBodiesInit]: CommandOfInit<Kind>;
}[keyof CommandBodiesInit];

/**
 * All characters of a world: one entry per character in each array, in ascending order of ids. No copies are made,
 * and arrays are valid until the world steps or ends.
 */
export interface Characters extends ReadOut {
  /** Number of characters. */
  readonly count: number;
  /** Unique id; it is not reused after the character has left. */
  readonly id: Uint32Array;
  /** Index of its group. */
  readonly group: Uint32Array;
  /** Position [m]. */
  readonly position: Float64Array;
  /** Velocity [m/s]. */
  readonly velocity: Float64Array;
  /** Unit vector in which the body faces. */
  readonly heading: Float64Array;
  /** Index of its place in its group; -1 for the unmatched. */
  readonly place: Int32Array;
  /** Unit vector along its planned path; zero where there is no path. */
  readonly direction: Float64Array;
  /** Cost of the path to its place; infinite for the unmatched. */
  readonly cost: Float64Array;
  /** Motion it performs: an index into the world's clips. */
  readonly motion: Int32Array;
  /** Phase of that motion. */
  readonly phase: Uint8Array;
  /** Time since the phase began [s]. */
  readonly motionTime: Float64Array;
  /** Id of the patch that it is in; 0 for none. */
  readonly patch: Uint32Array;
  /** What it is. */
  readonly body: Rows<Body>;
  /** Who moves it. */
  readonly driver: Uint8Array;
  /**
   * Velocity that steering aims at on the ground it is on, before bounds and contacts [m/s]. Those that are moved
   * from outside have it too.
   */
  readonly wantedVelocity: Float64Array;
  /** Exit or waiting area that it goes to; 0 for none. */
  readonly goal: Uint32Array;
}

/** Sums over the path costs of all characters with a place, in metres of open ground. */
export interface WalkTotals {
  /** Sum of the costs [m]. */
  readonly sum: number;
  /** Sum of the squared costs [m^2]. */
  readonly squares: number;
  /** Largest cost [m]. */
  readonly longest: number;
}

/** What can be read of a group without a copy. Texts and arrays are valid until the world steps or ends. */
export interface Group extends ReadOut {
  /** Unique id; it is not reused after the group is removed. */
  readonly id: GroupId;
  /** Name for display. */
  readonly name: string;
  /** Chosen colour, 0xRRGGBB. Null: the palette's colour. */
  readonly colour: number | null;
  /** Build of its drawn bodies. Null: bodies of both builds. */
  readonly build: BodyBuild | null;
  /** How it walks and jogs. Null: the plain manner. */
  readonly motions: MotionSet | null;
  /** Number of characters, and of places but where they go without (Leave, Wait, Walk): then there are none. */
  readonly count: number;
  /** Current shape. Its whole definition is read separately. */
  readonly formation: FormationKind;
  /** Increases whenever the mesh is replaced. */
  readonly formationVersion: number;
  /** Transforms the rest mesh to the world. */
  readonly pose: Pose;
  /** Indices of its characters, ascending. */
  readonly members: Int32Array;
  /** Vertices of the rest shape, in the group's axes [m]. */
  readonly restMesh: Float64Array;
  /** Vertices of Vu, deformed by controls [m]. */
  readonly userMesh: Float64Array;
  /** Vertices of Vf: Vu deformed by the environment [m]. */
  readonly finalMesh: Float64Array;
  /** Vertex indices, counter-clockwise. */
  readonly triangles: Int32Array;
  /** Each place as a point of the mesh. */
  readonly meshPlaces: Rows<MeshPoint>;
  /** Current position of each place [m]. */
  readonly placePositions: Float64Array;
  /** Current velocity of each place [m/s]. */
  readonly placeVelocities: Float64Array;
  /** Reachable target of each place [m]. */
  readonly placeTargets: Float64Array;
  /** 1 where a character can stand at the place, else 0. */
  readonly placeUsable: Uint8Array;
  /** Class of each place by the group's roles, 0 for whoever is left; none without roles. */
  readonly placeClasses: Uint8Array;
  /** Objective of the last plan [cost^p]. */
  readonly objective: number;
  /** Upper bound of its duality gap [cost^p]. */
  readonly gapBound: number;
  /** Path costs by the last plan. */
  readonly walk: WalkTotals;
  /** Mean distance of characters to the targets of their places (SPEC U6) [m]. */
  readonly meanLag: number;
  /** True: it was ordered to hold, and its orders stay. */
  readonly waits: boolean;
  /** True: orders that are done come last again. */
  readonly patrols: boolean;
  /** How it behaves. */
  readonly conduct: Conduct;
  /** What is ahead of the way of the order that it carries out: corners up to the end, the next one first [m]. */
  readonly way: Float64Array;
}

/** A point of a drawn trajectory. */
export interface Checkpoint {
  /** Position in the world [m]. */
  readonly position: Vec2;
  /** When it was drawn [s]. */
  readonly time: number;
}

/** A mesh vertex that a finger controls, and the trajectory drawn for it. */
export interface ControlPoint {
  /** Index of the mesh vertex, which is a hard constraint. */
  readonly vertex: number;
  /** Number of the finger; unique per client while it is down. */
  readonly touch: number;
  /** False once the finger has lifted. */
  readonly down: boolean;
  /** From the finger to the vertex at touch down [m]; added to all drawn points. */
  readonly offset: Vec2;
  /** Current position of the vertex in the world [m]. */
  readonly position: Vec2;
  /** Checkpoints still ahead; the last is the finger's newest point. */
  readonly trajectory: readonly Checkpoint[];
}

/**
 * One control of a mesh. All its points follow their trajectories by a common clock, which preserves their
 * relative timing.
 */
export interface Control {
  /** Unique id, which is not reused. */
  readonly id: ControlId;
  /** Follows from the number of points. */
  readonly kind: ControlKind;
  /** Number of the client that touches. */
  readonly client: number;
  /** True where it stays at the end of its trajectories. */
  readonly pinned: boolean;
  /** True while touches of the same client may still join. */
  readonly open: boolean;
  /** World time at which it stops being open [s]; -1 before its first step. */
  readonly joinDeadline: number;
  /** Time stamp of the first touch [s]; may be later than the world's time. */
  readonly startTime: number;
  /** Time of the drawing that the points have reached [s]. */
  readonly clock: number;
  /** Controlled vertices, at least one. */
  readonly points: readonly ControlPoint[];
  /** Supplementary points, which are soft constraints. */
  readonly supplementary: readonly MeshPoint[];
  /** Row-major weights, supplementary points x points; each row sums to 1. */
  readonly weights: Float64Array;
}

/** An obstacle and its current position. Its id is none where the world has no such obstacle. */
export interface Obstacle {
  /** Unique id; it is not reused. */
  readonly id: ObstacleId;
  /** Definition as added or last changed. */
  readonly def: ObstacleDef;
  /** Current corners [m]; none for a disc. */
  readonly outline: Float64Array;
  /** Current centre of the disc or of the area [m]. */
  readonly centre: Vec2;
}

/** A patch and its current position. Its id is none where the world has no such patch. */
export interface Patch {
  /** Unique id; it is not reused. */
  readonly id: PatchId;
  /** Definition as added or last changed. */
  readonly def: PatchDef;
  /** Current corners [m]. */
  readonly outline: Float64Array;
}

/** An exit, a source or a waiting area, and what it has seen. */
export interface Area {
  /** Unique id; it is not reused. */
  readonly id: AreaId;
  /** Definition as added or last changed; its `group` is not read. */
  readonly def: AreaDef;
  /** Of a source: whom its people join. */
  readonly group: GroupId;
  /** People who have left by an exit, or come by a source. */
  readonly passed: number;
  /** People of a source for whom there is no room yet. */
  readonly waiting: number;
}

/** One event. */
export interface Event {
  /** What happened. */
  readonly kind: EventKind;
  /** Id of the character; of the group where the kind speaks of one. */
  readonly subject: number;
  /** Its meaning depends on the kind. */
  readonly value: number;
  /** Where it happened: the middle of those concerned [m]. */
  readonly position: Vec2;
}

/** A command that could not be applied, and why. */
export interface Rejection {
  /** The command that failed. */
  readonly command: Command;
  /** The kind of failure. */
  readonly status: Status;
  /** Its sentence. */
  readonly message: string;
}

/** Overlaps of bodies that remain after a step. */
export interface Contacts {
  /** Pairs that overlap by more than 10 % of the sum of their radii. */
  readonly overlapPairs: number;
  /** Overlap of the deepest pair, as a share of that. */
  readonly worstPenetration: number;
}

/** Wall time of one stage of the last step. It is not part of the state. */
export interface StageTime {
  /** Name of the stage. */
  readonly name: string;
  /** Its time [ms]. */
  readonly milliseconds: number;
}

/** A point or vector in space [m]. In the world x right, y forward, z up; in body axes x forward, y left, z up. */
export interface Vec3 {
  /** First coordinate [m]. */
  x: number;
  /** Second coordinate [m]. */
  y: number;
  /** Height [m]. */
  z: number;
}

/** A rotation in space: a unit quaternion. */
export interface Quat {
  /** First imaginary part. */
  x: number;
  /** Second imaginary part. */
  y: number;
  /** Third imaginary part. */
  z: number;
  /** Real part. */
  w: number;
}

/** A rigid transform: rotation about the origin, then translation. */
export interface Transform {
  /** Rotation. */
  rotation: Quat;
  /** Translation [m]. */
  translation: Vec3;
}

/** A joint in the rest pose. */
export interface Joint {
  /** Name in common use by animation programs: "LeftForeArm". */
  readonly name: string;
  /** Index of the parent; -1 for the hips. */
  readonly parent: number;
  /** Offset from the parent [m]; for the hips, from the ground below. */
  readonly offset: Vec3;
  /** End of the bone relative to the joint [m]; zero for joints with children. */
  readonly tip: Vec3;
}

/** A pose of the body in body axes: the origin is on the ground below the character, which faces +x. */
export interface BodyPose {
  /** Position of the hips [m]. */
  hips: Vec3;
  /** Rotation of each joint relative to its parent; of the hips to the body axes. */
  rotation: readonly Quat[];
}

/** A time interval in which a limb does not move over the ground. */
export interface LimbContact {
  /** The limb that is in contact. */
  limb: Limb;
  /** Start time [s], in [0, duration). */
  begin: number;
  /** End time [s], above `begin`; in a cyclic clip it may exceed the duration. */
  end: number;
  /** Position of the joint during the contact [m], in the axes in which the travel starts. */
  anchor: Vec3;
}

/** Displacement of the body axes on the ground since the clip began (root motion). */
export interface Travel {
  /** Displacement forward [m]. */
  x: number;
  /** Displacement to the left [m]. */
  y: number;
  /** Rotation to the left [rad]. */
  yaw: number;
}

/** A motion clip: poses at a fixed rate, their travel, and the contacts. */
export interface Clip extends ReadOut {
  /** Unique name: "run", "crawl-enter"... */
  readonly name: string;
  /** The motion it belongs to: "run", "duck", "crawl"... */
  readonly motion: string;
  /** Poses per second, above 0. */
  readonly rate: number;
  /** True where the first pose follows the last, displaced by the travel. */
  readonly cyclic: boolean;
  /** Duration times rate of a cyclic clip, one more of others. */
  readonly poses: Float32Array;
  /** Travel at each pose; a cyclic clip has one more. */
  readonly travel: Float32Array;
  /** Contacts in order of `begin`. */
  readonly contacts: readonly LimbContact[];
  /** Of a transition: share of the entered cycle at which that continues. */
  readonly entryPhase: number;
  /** Of a transition: share of the left cycle at which it begins. */
  readonly exitPhase: number;
  /** Height of what a single-step clip passes over [m]; 0 for nothing. */
  readonly obstacleHeight: number;
  /** Its extent along the travel [m]. */
  readonly obstacleThickness: number;
}

/** What may be given of Clip. */
export interface ClipInit {
  /** Unique name: "run", "crawl-enter"... */
  readonly name?: string | null | undefined;
  /** The motion it belongs to: "run", "duck", "crawl"... */
  readonly motion?: string | null | undefined;
  /** Poses per second, above 0. */
  readonly rate?: number | undefined;
  /** True where the first pose follows the last, displaced by the travel. */
  readonly cyclic?: boolean | undefined;
  /** Duration times rate of a cyclic clip, one more of others. */
  readonly poses?: readonly BodyPose[] | Float32Array | undefined;
  /** Travel at each pose; a cyclic clip has one more. */
  readonly travel?: readonly Travel[] | Float32Array | undefined;
  /** Contacts in order of `begin`. */
  readonly contacts?: readonly LimbContact[] | undefined;
  /** Of a transition: share of the entered cycle at which that continues. */
  readonly entryPhase?: number | undefined;
  /** Of a transition: share of the left cycle at which it begins. */
  readonly exitPhase?: number | undefined;
  /** Height of what a single-step clip passes over [m]; 0 for nothing. */
  readonly obstacleHeight?: number | undefined;
  /** Its extent along the travel [m]. */
  readonly obstacleThickness?: number | undefined;
}

/** Measures of a clip. */
export interface ClipMeasures {
  /** Duration of one play [s]. */
  readonly duration: number;
  /** Distance from start to end of one play [m]. */
  readonly length: number;
  /** Length by duration [m/s]. */
  readonly speed: number;
}

/** The clip that a character plays: enough to draw it from baked poses. */
export interface MotionState {
  /** Index into the library. */
  readonly clip: number;
  /** The clip that fades out. */
  readonly fromClip: number;
  /** Time in `clip` [s], within one play. */
  readonly time: number;
  /** Time in `fromClip` [s]. */
  readonly fromTime: number;
  /** Share of `fromClip` still shown, 0 to 1. */
  readonly fade: number;
  /** Origin of the body axes in the world: the simulated position [m]. */
  readonly position: Vec2;
  /** Heading, counter-clockwise from +x [rad]. */
  readonly yaw: number;
  /** Factor of the skeleton: characterSize() of its id. */
  readonly size: number;
}

/** A joint of a BVH file, in Muster's axes (x forward, y left, z up). */
export interface BvhJoint {
  /** Name in the file. */
  readonly name: string;
  /** Index of a joint before it; -1 for a root. */
  readonly parent: number;
  /** From the parent in the rest pose [m]. */
  readonly offset: Vec3;
  /** End sites, from the joint [m]. */
  readonly ends: Float32Array;
  /** True where it has position channels. */
  readonly moves: boolean;
}

/** A whole BVH file. */
export interface BvhContents extends ReadOut {
  /** Parents before children; at least one. */
  readonly joints: readonly BvhJoint[];
  /** Transforms relative to the parent [m], by frame and then by joint. */
  readonly values: Float32Array;
  /** Number of frames, at least one. */
  readonly frames: number;
  /** Frames per second, above 0. */
  readonly rate: number;
  /** Length of one unit of the file [m]. */
  readonly unit: number;
  /** Time from the first frame to the last [s]. */
  readonly duration: number;
}

/** The hash of a world's state after that many steps. */
export interface HashMark {
  /** Number of steps done. */
  readonly step: number;
  /** Hash of the state after these steps. */
  readonly hash: bigint;
  /** Number of commands recorded before this mark. The file does not store it. */
  readonly commands: number;
}

/** An event of an order, as it was raised while the take was recorded (EventKind: Arrived and later ones). */
export interface TakeEvent {
  /** Number of steps done at the event. */
  readonly step: number;
  /** The event. */
  readonly event: Event;
}

/** Where everybody was after that many steps, to 1 mm: what a take shows where its simulation gives other bits. */
export interface TakeFrame {
  /** Number of steps done. */
  readonly step: number;
  /** Who, in ascending order. */
  readonly ids: Uint32Array;
  /** Where [m], in the same order. */
  readonly positions: Float64Array;
}

/** A part of a take that plays faster or slower than it was recorded. */
export interface SpeedPiece {
  /** Time in the take [s]. */
  from: number;
  /** Time in the take [s], above `from`. */
  to: number;
  /** Seconds of the take per second, 0.1 to 8. */
  speed: number;
  /** Time at each end in which the speed comes and goes [s], 0 or more. */
  ease: number;
}

/** What a take holds. */
export interface TakeContents extends ReadOut {
  /** Text of the scenario, map and clip facts embedded. */
  readonly scenario: string;
  /** The scenario, parsed. */
  readonly def: WorldDef;
  /** Commands in the order of submission. */
  readonly commands: readonly Command[];
  /** Hash marks in ascending order of steps. */
  readonly marks: readonly HashMark[];
  /** Events in ascending order of steps. */
  readonly events: readonly TakeEvent[];
  /** Frames in ascending order of steps. */
  readonly frames: readonly TakeFrame[];
  /** Name for people; empty for none. */
  readonly title: string;
  /** Steps before the part that is to be shown. */
  readonly firstStep: number;
  /** Steps after which that part ends. */
  readonly lastStep: number;
  /** Faster and slower parts, in ascending order. */
  readonly speeds: readonly SpeedPiece[];
  /** True where the take has an end record. */
  readonly finished: boolean;
  /** Bytes of an unfinished last record that were left out. */
  readonly tornBytes: bigint;
  /** Steps whose hashes are known: up to the last mark. */
  readonly markedSteps: number;
  /** Steps that can be replayed. */
  readonly steps: number;
}

/** Outcome of a replay. */
export interface ReplayReport {
  /** Number of steps simulated. */
  readonly steps: number;
  /** Number of marks that matched. */
  readonly compared: number;
  /** Steps after the last mark, which no hash confirms. */
  readonly unmarked: number;
  /** Hash of the final state. */
  readonly hash: bigint;
}

/** A file format of exports. */
export interface ExportFormat {
  /** Unique name: "glb", "bvh"... */
  readonly name: string;
  /** Ending of the file name (".glb"), or of the folder that bvh writes ("-bvh"). */
  readonly ending: string;
  /** Description in one line. */
  readonly about: string;
}

/** The part of a take to export, and the frame rate. */
export interface ExportDef {
  /** Time of the first frame [s], 0 or more. */
  from: number;
  /** Time of the last frame [s], within the take; negative: its end. */
  to: number;
  /** Frames per second, 1 to 240. */
  fps: number;
  /** Number of threads, as for World.create(). */
  threads: number;
  /** Faster and slower parts. */
  speeds: SpeedPiece[];
}

/** What may be given of ExportDef. */
export interface ExportDefInit {
  /** Time of the first frame [s], 0 or more. */
  readonly from?: number | undefined;
  /** Time of the last frame [s], within the take; negative: its end. */
  readonly to?: number | undefined;
  /** Frames per second, 1 to 240. */
  readonly fps?: number | undefined;
  /** Number of threads, as for World.create(). */
  readonly threads?: number | undefined;
  /** Faster and slower parts. */
  readonly speeds?: readonly SpeedPiece[] | undefined;
}
