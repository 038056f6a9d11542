// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// Definitions as scenario files have them (docs/scenario-format.md).

import type { FormationKindWord, BodyBuildWord, MotionSetWord, AreaKindWord, CheckpointTriggerWord, SpreadWord, RoleAreaWord, OrderKindWord, ExitChoiceWord, MannerWord, TurnWord, StanceWord } from './words';

export type Point = readonly [x: number, y: number];



/** Position and angle of a moving object at one time. */
export interface Waypoint {
  /** Time from the start of the world [s]. */
  readonly t: number;
  /** Offset from the defined placement [m]. */
  readonly x?: number;
  readonly y?: number;
  /** Turn about its centre [rad]. */
  readonly angle?: number;
}

/**
 * Piecewise linear motion through waypoints of strictly rising time. An obstacle whose path is over becomes
 * ground: the world then holds it where it stands, without a path.
 */
export interface TimedPath {
  /** Places at rising times. */
  readonly waypoints: readonly Waypoint[];
  /** Starts again after the last waypoint; else it stays there. */
  readonly loop?: boolean;
}

/** Describes an obstacle, which nobody can walk through: a polygon or a disc. */
export interface ObstacleDef {
  /** For people. */
  readonly name?: string;
  /** Its corners, convex or not, in either direction [m]. */
  readonly polygon?: readonly Point[];
  /** For a disc: its centre [m]. */
  readonly centre?: Point;
  /** For a disc, instead of a polygon [m]. */
  readonly radius?: number;
  /** Its motion; empty for an obstacle that stands still. */
  readonly path?: TimedPath;
  /** Range of its potential field; left out: the parameter field.range [m]. */
  readonly range?: number;
  /** Strength of its potential field; left out: the parameter field.strength. */
  readonly strength?: number;
  /** For the eye [m]. */
  readonly height?: number;
}

/** Facts of a motion clip that simulation needs (the paper's table 1). */
export interface ClipFacts {
  /** What patches call it. */
  readonly name: string;
  /** File of the clip; empty for one of Muster's own. */
  readonly file?: string;
  /** Travel speed relative to running. */
  readonly speed?: number;
  /** Ground covered by one play; 0 where unknown [m]. */
  readonly length?: number;
  /** Of one play [s]. */
  readonly duration?: number;
  /** False for motions that happen once per patch, such as a jump. */
  readonly cyclic?: boolean;
  /** Played on entering and leaving; 0 for none [s]. */
  readonly transitionTime?: number;
  /** From the character's position to the head of a body that leans or lies; 0 for upright bodies [m]. */
  readonly reachAhead?: number;
  /** From there back to its hips [m]. */
  readonly reachBehind?: number;
}

/** Describes a patch: ground with a motion clip of its own. */
export interface PatchDef {
  /** Shown on its tag. */
  readonly name?: string;
  /** Its corners [m]. */
  readonly polygon: readonly Point[];
  /** Its motion; empty for a patch that stands still. */
  readonly path?: TimedPath;
  /** Clip played on it: a name or index of `clips`. */
  readonly motion: string | number;
  /** Travel speed relative to running; left out: the clip's. */
  readonly speed?: number;
  /** For stairs and ramps: heading of the way up [rad]. */
  readonly ascent?: number;
  /** For stairs and ramps: travel speed down; left out: as `speed`. */
  readonly speedDown?: number;
}

/** Scale and position of a map. */
export interface MapDef {
  /** Edge of a map cell [m]. */
  readonly metresPerCell?: number;
  /** Lower left corner of the map [m]. */
  readonly origin?: Point;
  /** Travel speed of swamp cells. */
  readonly swampSpeed?: number;
}

/** How many people a source has let in by a time. */
export interface Arrivals {
  /** When [s]. */
  readonly t: number;
  /** How many. */
  readonly count: number;
}

/** Describes an area, where people leave the world, come into it, or wait. It is no obstacle. */
export interface AreaDef {
  /** Shown on its tag. */
  readonly name?: string;
  /** What it does. */
  readonly kind: AreaKindWord;
  /** Its corners [m]. */
  readonly polygon: readonly Point[];
  /** False: nobody leaves or comes here for now. */
  readonly open?: boolean;
  /** For exit: the most who leave, 0 for as many as come. For source: how many come on average [1/s]. */
  readonly rate?: number;
  /** For exit: the line in which people queue, from who is next to the last [m]. */
  readonly queue?: readonly Point[];
  /** For Source in a WorldDef: index of the group whom its people join. */
  readonly group?: number;
  /** For exit: when it opens. For source with a rate: when it begins [s]. */
  readonly from?: number;
  /** For exit: when it closes. For source with a rate: when it ends [s]. */
  readonly until?: number;
  /** For source with a rate: in all; 0 for no end. */
  readonly most?: number;
  /** For source: further people, by ascending times. */
  readonly timetable?: readonly Arrivals[];
}

/** An item, which a character collects by coming within its radius. */
export interface ItemDef {
  /** Where it lies [m]. */
  readonly position: Point;
  /** Collected when a character comes within it [m]. */
  readonly radius?: number;
}

/** The body of a character. A number of 0 stands for the parameter of that name. */
export interface Body {
  /** 0: the parameter's; else 0.05 or more [m]. */
  readonly radius?: number;
  /** 0: the parameter's; else 0.01 or more [m/s]. */
  readonly maxSpeed?: number;
  /** 0: the parameter's; else 0.01 or more [m/s^2]. */
  readonly acceleration?: number;
  /** Who is heavy gives way less. */
  readonly mass?: number;
  /** Units that it supplies to places. */
  readonly supply?: number;
  /** For roles; 0 for none. */
  readonly class?: number;
  /** Time that it keeps from who is ahead. 0: the parameter's; else 0.02 or more [s]. */
  readonly headway?: number;
  /** From its first order until it sets out [s]. */
  readonly premovement?: number;
  /** Speed up stairs as a share of that in the open; 0: the stairs'. */
  readonly upstairs?: number;
  /** The same for down. */
  readonly downstairs?: number;
}

/**
 * Characters of a class take their places in a part of the formation: as many as there are such characters.
 * Roles choose in their order; who is of no role takes what is left. (Ranks by class: several roles in front.)
 */
export interface RoleDef {
  /** Part of the formation. */
  readonly area: RoleAreaWord;
  /** Of those who stand there. */
  readonly class: number;
}

/**
 * The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not drawn,
 * and what lies inside is drawn in its proportions. A constant is as it is.
 */
export interface Distribution {
  /** Its kind. */
  readonly spread: SpreadWord;
  /** The value of all, the least, the mean, the logarithm's mean, the shape, or Weibull's scale. */
  readonly a?: number;
  /** The most, the deviation, the logarithm's, the scale, or Weibull's shape. */
  readonly b?: number;
  /** What lies below does not occur. */
  readonly least?: number;
  /** What lies above does not occur. */
  readonly most?: number;
}

/**
 * One sort of persons in a group. What is constantly 0 is not drawn: it is that of GroupDef::bodies, or of the
 * parameters where that is 0, too.
 */
export interface PeopleDef {
  /** For people. */
  readonly name?: string;
  /** Of the group; shares are divided by their sum. */
  readonly share?: number;
  /** For roles; 0 for none. */
  readonly class?: number;
  /** Top speed in the open [m/s]. */
  readonly speed?: number | Distribution;
  /** Radius of the body [m]. */
  readonly radius?: number | Distribution;
  /** Time that it keeps from who is ahead [s]. */
  readonly headway?: number | Distribution;
  /** Until it sets out on its first order [s]. */
  readonly premovement?: number | Distribution;
  /** Above 0 it gives the speed, as RiMEA has it [years]. */
  readonly age?: number | Distribution;
  /** Speed up stairs as a share of that in the open; 0: the stairs'. */
  readonly upstairs?: number;
  /** The same for down. */
  readonly downstairs?: number;
}

/** Describes a formation in its local axes: it faces +x, its centre is the origin. */
export interface FormationDef {
  /** The shape. */
  readonly kind?: FormationKindWord;
  /** Distance between neighbouring places [m]. */
  readonly spacing?: number;
  /** Full angle of Pacman's mouth or the crescent's gap [rad]. */
  readonly opening?: number;
  /** For outline: its corners, of any size [m]. */
  readonly outline?: readonly Point[];
  /** Corners of each hole. */
  readonly holes?: readonly (readonly Point[])[];
  /** For points: places in the local frame, facing +x [m]. */
  readonly points?: readonly Point[];
  /** For square: how many stand abreast; 0: as deep as wide. */
  readonly files?: number;
}

/** One order of a group. */
export interface Order {
  /** What it asks for. */
  readonly kind?: OrderKindWord;
  /** Centre of the formation at the end; of the rectangle for Guard [m]. */
  readonly x?: number;
  readonly y?: number;
  /** Heading at the end; none for that of the last stretch [rad]. */
  readonly facing?: number;
  /** Width of the front of a formation in ranks (square, line, column), which becomes a square of so many files; 0 for its own. Other shapes keep theirs [m]. */
  readonly width?: number;
  /** Drawn way to the target [m]. */
  readonly route?: readonly Point[];
  /** New formation; left out: the old one. */
  readonly formation?: FormationKindWord | FormationDef;
  /** In formation, each by the shortest way, or to one point by one field. */
  readonly manner?: MannerWord;
  /** How it turns on a march. */
  readonly turn?: TurnWord;
  /** Of a march; 0 for as fast as all can [m/s]. */
  readonly pace?: number;
  /** Of those who must be there before the next order begins. */
  readonly share?: number;
  /** For follow and guard: the group to stay with. */
  readonly leader?: number;
  /** For follow and guard: the character to stay with. */
  readonly character?: number;
  /** For follow: from its centre, in its axes [m]. */
  readonly offset?: Point;
  /** For guard: half the length and half the width [m]. */
  readonly halfSize?: Point;
  /** For Guard: how the rectangle moves from `target` on. */
  readonly path?: TimedPath;
  /** For leave: ids of areas, from 1; left out: all exits. */
  readonly exits?: readonly number[];
  /** For leave: where it has left soonest, or the quickest way alone. */
  readonly choice?: ExitChoiceWord;
  /** For leave: seconds by which each exit counts as nearer [s]. */
  readonly attractions?: readonly number[];
  /** For leave: by so much an exit counts as nearer that all others nearby choose [s]. */
  readonly herding?: number;
  /** For leave: deviation of the error by which each misjudges the time by an exit [s]. */
  readonly misjudgement?: number;
  /** For wait: id of the waiting area, from 1. */
  readonly area?: number;
  /** For wait: from when its share has come; 0: no end [s]. */
  readonly seconds?: number;
}

/** How a group behaves, whatever its orders. */
export interface Conduct {
  /** Who makes room where groups meet. */
  readonly stance?: StanceWord;
  /** 0: each at their own pace; 1: at the slowest one's. */
  readonly cohesion?: number;
  /** Share of its width that it may give up in passages. */
  readonly squeeze?: number;
  /** Its mesh gives way to other meshes and to moving obstacles. */
  readonly avoids?: boolean;
}

/** A group of characters with one mesh. */
export interface GroupDef {
  /** Shown on its chip. */
  readonly name?: string;
  /** Of its shirts and marks; left out: the palette's, by its place in the list. */
  readonly colour?: string;
  /** Build of the drawn bodies; left out: both, by their ids. */
  readonly build?: BodyBuildWord;
  /** How they walk and jog; left out: plainly. */
  readonly motions?: MotionSetWord;
  /** Characters; 0 where a source sends some. */
  readonly count?: number;
  /** Kind and spacing, or the kind alone. */
  readonly formation?: FormationKindWord | FormationDef;
  /** Centre of the formation [m]. */
  readonly position?: Point;
  /** Where it faces, from +x counter-clockwise [rad]. */
  readonly angle?: number;
  /** Where characters stand at first, one point each; left out: on their places [m]. */
  readonly starts?: readonly Point[];
  /** Start positions are moved by up to this, by the seed [m]. */
  readonly jitter?: number;
  /** One for all, or one for each character; empty for the parameters'. */
  readonly bodies?: readonly (Body & { readonly count?: number })[];
  /** Sorts of persons, who also come by sources; empty for none. A number that a sort draws goes before that of `bodies`; what it does not draw, and acceleration, mass and supply, is that of `bodies`. */
  readonly people?: 'adults' | PeopleDef | readonly ('adults' | PeopleDef)[];
  /** Which class stands where; empty for none. */
  readonly roles?: readonly RoleDef[];
  /** Units of supply that each place demands; left out: 1 each. */
  readonly demands?: readonly number[];
  /** How it behaves. */
  readonly conduct?: Conduct;
  /** What it is to do at first, one after the other. */
  readonly orders?: readonly Order[];
  /** Orders that are done come last again. */
  readonly patrols?: boolean;
}

/** The colour of a group. */
export interface GroupColour {
  /** Of its shirts and marks; left out: the palette's. */
  readonly colour?: string;
}

/** How the people of a group look. */
export interface GroupLook {
  /** Build of the drawn bodies; left out: both, by their ids. */
  readonly build?: BodyBuildWord;
  /** How they walk and jog; left out: plainly. */
  readonly motions?: MotionSetWord;
}

/** A disc that changes the formation of a group which passes it. */
export interface CheckpointDef {
  /** Where it lies [m]. */
  readonly position: Point;
  /** Works for who comes within it [m]. */
  readonly radius?: number;
  /** What the group becomes. */
  readonly formation: FormationKindWord | FormationDef;
  /** Index of the group that it applies to; -1 for all groups. */
  readonly group?: number;
  /** Works once per group; else each time the group comes anew. */
  readonly once?: boolean;
  /** What passes it: a share of the crowd, or the centre of the mesh. */
  readonly trigger?: CheckpointTriggerWord;
  /** For crowd: share of the group that has been in it. */
  readonly share?: number;
}

/** Describes a world. */
export interface WorldDef {
  /** Shown in the studio. */
  readonly name?: string;
  /** One or two sentences. */
  readonly description?: string;
  /** Whose data it uses. */
  readonly credit?: string;
  /** File of its gestures, in the scenario's folder or below, which worlds do not read; empty for none. */
  readonly gestures?: string;
  /** Map that adds obstacles and patches; none for no map. */
  readonly map?: MapDef & { readonly file?: string; readonly rows?: readonly string[] };
  /** Extent of the ground [m]. */
  readonly box?: readonly [Point, Point];
  /** Edge of a ground cell [m]. */
  readonly cell?: number;
  /** Of all random numbers. */
  readonly seed?: number;
  /** Facts of clips, which patches name by their index. */
  readonly clips?: readonly ClipFacts[];
  /** What nobody can walk through. */
  readonly obstacles?: readonly ObstacleDef[];
  /** At most 20,000 patches. */
  readonly patches?: readonly PatchDef[];
  /** Crowds, each with one mesh. */
  readonly groups?: readonly GroupDef[];
  /** Discs that change formations. */
  readonly checkpoints?: readonly CheckpointDef[];
  /** Things to collect. */
  readonly items?: readonly ItemDef[];
  /** Exits, sources and waiting areas; at most 1,000. */
  readonly areas?: readonly AreaDef[];
  /** The left and the right side of the box are joined. */
  readonly ring?: boolean;
  /** Parameters of behaviour. */
  readonly parameters?: Readonly<Record<string, number>>;
}
