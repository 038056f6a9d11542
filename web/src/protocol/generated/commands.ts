// Made by schema/generate.mjs from schema/definitions.txt and commands.txt: change these, not this file.
import type {
  FormationKindWord,
  BodyBuildWord,
  MotionSetWord,
  ControlKindWord,
  AreaKindWord,
  ThingKindWord,
  CheckpointTriggerWord,
  SpreadWord,
  RoleAreaWord,
  DriverWord,
  SplitByWord,
  PartShapeWord,
  OrderKindWord,
  ExitChoiceWord,
  MannerWord,
  TurnWord,
  TouchPhaseWord,
  ControlEditWord,
  QueueModeWord,
  QueueEditWord,
  StanceWord,
} from './words';

export type Vec2 = readonly [number, number];

/** A polygon with holes. */
export interface PolygonWithHoles {
  readonly outline: readonly Vec2[];
  readonly holes: readonly (readonly Vec2[])[];
}

/** What is left out is as the declarations say. */
export type Given<T> = T extends Vec2
  ? T
  : T extends readonly (infer Item)[]
    ? readonly Given<Item>[]
    : T extends object
      ? { readonly [Key in keyof T]?: Given<T[Key]> | undefined }
      : T;

/** Describes a formation in its local axes: it faces +x, its centre is the origin. */
export interface FormationDef {
  /** Shape. */
  readonly kind: FormationKindWord;
  /** Distance between neighbouring places, 0.05 to 100 [m]. */
  readonly spacing: number;
  /** Full angle of Pacman's mouth or of the crescent's gap, above 0 and at most 6 [rad]. */
  readonly opening: number;
  /** For Outline: the shape, in any size [m]. */
  readonly outline: PolygonWithHoles;
  /** For Points: the places in this order; at least as many as characters [m]. */
  readonly points: readonly Vec2[];
  /** For Square: how many stand abreast, 0 to 200,000; 0 for about as many as there are ranks. */
  readonly files: number;
}

/** The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not drawn, and what lies inside is drawn in its proportions. A constant is as it is. */
export interface Distribution {
  /** Its kind. */
  readonly spread: SpreadWord;
  /** First number, in the unit of what is drawn but for LogNormal. */
  readonly a: number;
  /** Second number; not read for Constant. */
  readonly b: number;
  /** The smallest value that occurs. */
  readonly least: number;
  /** The largest one. */
  readonly most: number;
}

/** One sort of persons in a group. What is constantly 0 is not drawn: it is that of GroupDef::bodies, or of the parameters where that is 0, too. */
export interface PeopleDef {
  /** Name for display: "Women over 50". */
  readonly name: string;
  /** Share of the group, above 0; shares are divided by their sum. */
  readonly share: number;
  /** Class, for roles; 0 for none. */
  readonly unitClass: number;
  /** Top speed in the open, 0 or 0.01 to 50 [m/s]. */
  readonly speed: Distribution;
  /** Radius of the body, 0 or 0.05 to 1.5 [m]. */
  readonly radius: Distribution;
  /** Time that it keeps from who is ahead, 0 or 0.02 to 5 [s]. */
  readonly headway: Distribution;
  /** Time until it sets out on its first order, 0 to 1e7 [s]. */
  readonly premovement: Distribution;
  /** Age, 0 or 5 to 90; above 0 it gives the top speed in the place of `speed`, as RiMEA has it [years]. */
  readonly age: Distribution;
  /** Speed up stairs as a share of that in the open, 0 or 0.01 to 1. */
  readonly upstairs: number;
  /** Speed down stairs as a share of that in the open, 0 or 0.01 to 1. */
  readonly downstairs: number;
}

/** How a group behaves, whatever its orders. */
export interface Conduct {
  /** Who makes room. */
  readonly stance: StanceWord;
  /** 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1]. */
  readonly cohesion: number;
  /** Share of its width that it may give up in narrow passages, [0, 1]; 0 for none. */
  readonly squeeze: number;
  /** True: its mesh gives way to other meshes and to moving obstacles (SPEC B3). */
  readonly avoids: boolean;
}

/** Characters of a class take their places in a part of the formation: as many as there are such characters. Roles choose in their order; who is of no role takes what is left. (Ranks by class: several roles in front.) */
export interface RoleDef {
  /** Where. */
  readonly area: RoleAreaWord;
  /** Who, 1 or more. */
  readonly unitClass: number;
}

/** The colour of a group. */
export interface GroupColour {
  /** Colour for display, 0xRRGGBB; none for the palette's. */
  readonly colour: number | null;
}

/** How the people of a group look. */
export interface GroupLook {
  /** Build of its drawn bodies; none for both, by the character's id. */
  readonly build: BodyBuildWord | null;
  /** How it walks and jogs; none for the plain manner. */
  readonly motions: MotionSetWord | null;
}

/** The body of a character. A number of 0 stands for the parameter of that name. */
export interface Body {
  /** Radius, 0 or 0.05 to 1.5 [m]. */
  readonly radius: number;
  /** Top speed in the open, 0 or 0.01 to 50 [m/s]. */
  readonly maxSpeed: number;
  /** Top acceleration, 0 or 0.01 to 1000 [m/s^2]. */
  readonly acceleration: number;
  /** Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less. */
  readonly mass: number;
  /** Units that it supplies to places (SPEC A1), above 0 and at most 1000. */
  readonly supply: number;
  /** Class, for roles; 0 for none. */
  readonly unitClass: number;
  /** Time that it keeps from who is ahead, 0 or 0.02 to 5 [s]. */
  readonly headway: number;
  /** Time from its first order until it sets out, 0 to 1e7; no parameter [s]. */
  readonly premovement: number;
  /** Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'. */
  readonly upstairs: number;
  /** Speed down stairs as a share of that in the open, 0.01 to 1; 0: the stairs'. */
  readonly downstairs: number;
}

/** Position and angle of a moving object at one time. */
export interface Waypoint {
  /** World time, 0 to 1e7 [s]. */
  readonly time: number;
  /** Offset from the object's defined position [m]. */
  readonly position: Vec2;
  /** Rotation about the object's centre of area, -1e5 to 1e5 [rad]. */
  readonly angle: number;
}

/** Piecewise linear motion through waypoints of strictly rising time. An obstacle whose path is over becomes ground: the world then holds it where it stands, without a path. */
export interface TimedPath {
  /** At least 1e-6 s apart; empty for an object that stands still. */
  readonly waypoints: readonly Waypoint[];
  /** True to start again after the last waypoint; false to stay there. */
  readonly loop: boolean;
}

/** One order of a group. */
export interface Order {
  /** What it asks for. */
  readonly kind: OrderKindWord;
  /** Centre of the formation at the end; of the rectangle for Guard [m]. */
  readonly target: Vec2;
  /** Heading at the end; none for that of the last stretch [rad]. */
  readonly facing: number | null;
  /** Width of the front of a formation in ranks (square, line, column), which becomes a square of so many files; 0 for its own. Other shapes keep theirs [m]. */
  readonly width: number;
  /** Drawn way to the target; followed as drawn, round obstacles [m]. */
  readonly route: readonly Vec2[];
  /** New formation, which is taken up on the way; none to keep it. */
  readonly formation: FormationDef | null;
  /** How it goes. */
  readonly manner: MannerWord;
  /** How it turns on a march. */
  readonly turn: TurnWord;
  /** Speed of a march; 0 for as fast as all can keep up with [m/s]. */
  readonly pace: number;
  /** Share of the group that must have arrived before the next order begins, (0, 1]. */
  readonly share: number;
  /** For Follow and Guard: the group to stay with; none for a character or a place. */
  readonly group: number;
  /** For Follow and Guard: id of the character to stay with; 0 for none. */
  readonly character: number;
  /** For Follow: from its centre to the formation's, in its axes [m]. */
  readonly offset: Vec2;
  /** For Guard: half the length and half the width of the rectangle [m]. */
  readonly halfSize: Vec2;
  /** For Guard: how the rectangle moves from `target` on. */
  readonly path: TimedPath;
  /** For Leave: by which exits; empty for all. */
  readonly exits: readonly number[];
  /** For Leave: by which of them each goes. */
  readonly choice: ExitChoiceWord;
  /** For Leave: seconds by which each of `exits` counts as nearer than it is, -1e6 to 1e6; empty for none [s]. */
  readonly attractions: readonly number[];
  /** For Leave: seconds by which an exit counts as nearer if all others nearby choose it, 0 to 1e6 [s]. */
  readonly herding: number;
  /** For Leave: deviation of the error by which each misjudges the time by an exit, drawn by the world's seed, 0 to 1e6 [s]. */
  readonly misjudgement: number;
  /** For Wait: the waiting area. */
  readonly area: number;
  /** For Wait: how long, from when its share has come, 0 to 1e9; 0 for no end [s]. */
  readonly seconds: number;
}

/** A group of characters with one mesh. */
export interface GroupDef {
  /** Name for display. */
  readonly name: string;
  /** Number of characters, 1 to 200,000, or 0 where a source sends some; at most 5,000 in all groups with exact plans. */
  readonly count: number;
  /** Shape and spacing of the places. */
  readonly formation: FormationDef;
  /** Centre of the formation [m]. */
  readonly position: Vec2;
  /** Heading, counter-clockwise from +x [rad]. */
  readonly angle: number;
  /** Initial positions of characters; empty to start on their places [m]. */
  readonly starts: readonly Vec2[];
  /** Largest random displacement of initial positions, 0 or more [m]. */
  readonly jitter: number;
  /** One for all, or one for each character; empty for the parameters'. */
  readonly bodies: readonly Body[];
  /** Which class stands where; empty for none. */
  readonly roles: readonly RoleDef[];
  /** Units of supply that each place demands; empty for 1 each. */
  readonly demands: readonly number[];
  /** How it behaves. */
  readonly conduct: Conduct;
  /** What it is to do at first, one after the other. */
  readonly orders: readonly Order[];
  /** True: orders that are done come last again. */
  readonly patrols: boolean;
  /** Colour for display, 0xRRGGBB; none for the palette's. */
  readonly colour: number | null;
  /** Build of its drawn bodies; none for both, by the character's id. */
  readonly build: BodyBuildWord | null;
  /** How it walks and jogs; none for the plain manner. */
  readonly motions: MotionSetWord | null;
  /** Sorts of persons, who also come by sources; empty for none. A number that a sort draws goes before that of `bodies`; what it does not draw, and acceleration, mass and supply, is that of `bodies`. */
  readonly people: readonly PeopleDef[];
}

/** Describes an obstacle, which nobody can walk through: a polygon or a disc. */
export interface ObstacleDef {
  /** Name for display; may be empty. */
  readonly name: string;
  /** Simple, convex or not; empty for a disc [m]. */
  readonly polygon: readonly Vec2[];
  /** Centre of the disc [m]. */
  readonly centre: Vec2;
  /** Radius of the disc, above 0; 0 for a polygon [m]. */
  readonly radius: number;
  /** Its motion; empty for an obstacle that stands still. */
  readonly path: TimedPath;
  /** Reach of its potential field, 0 or more; negative for the world's default [m]. */
  readonly range: number;
  /** Factor of its potential field, 0 or more; negative for the world's default. */
  readonly strength: number;
  /** Height for display only, above 0 [m]. */
  readonly height: number;
}

/** Describes a patch: ground with a motion clip of its own (SPEC C1). */
export interface PatchDef {
  /** Name for display: "Net", "Pool"... */
  readonly name: string;
  /** Corners of a simple polygon, convex or not [m]. */
  readonly polygon: readonly Vec2[];
  /** Its motion; empty for a patch that stands still. */
  readonly path: TimedPath;
  /** Clip played on it: an index into the world's clips. */
  readonly motion: number;
  /** Travel speed relative to running, above 0; negative for the clip's. */
  readonly speed: number;
  /** For stairs and ramps: heading of the way up, where `speed` is that of going up; none for level ground [rad]. */
  readonly ascent: number | null;
  /** For stairs and ramps: that of going down; negative for `speed`. */
  readonly speedDown: number;
}

/** An item, which a character collects by coming within its radius. */
export interface ItemDef {
  /** Centre [m]. */
  readonly position: Vec2;
  /** Radius, above 0 [m]. */
  readonly radius: number;
}

/** A disc that changes the formation of a group which passes it (SPEC M7). */
export interface CheckpointDef {
  /** Centre [m]. */
  readonly position: Vec2;
  /** Radius, above 0 [m]. */
  readonly radius: number;
  /** New formation of the group. */
  readonly formation: FormationDef;
  /** Index of the group that it applies to; -1 for all groups. */
  readonly group: number;
  /** True: it applies once per group. False: whenever a group enters. */
  readonly once: boolean;
  /** What passes it. */
  readonly trigger: CheckpointTriggerWord;
  /** For Crowd: share of the group, (0, 1]. */
  readonly share: number;
}

/** How many people a source has let in by a time. */
export interface Arrivals {
  /** Time of the world [s]. */
  readonly time: number;
  /** That come at this time. */
  readonly count: number;
}

/** Describes an area, where people leave the world, come into it, or wait. It is no obstacle. */
export interface AreaDef {
  /** Name for display: "Main exit". */
  readonly name: string;
  /** What it does. */
  readonly kind: AreaKindWord;
  /** Corners of a simple polygon, convex or not [m]. */
  readonly polygon: readonly Vec2[];
  /** False: nobody leaves or comes here for now. */
  readonly open: boolean;
  /** For Exit: the most people who leave in a second, 0 to 1000; 0 for as many as come. For Source: how many come in a second on average, at random times by the world's seed, 0 to 1000 [1/s]. */
  readonly rate: number;
  /** For Exit: a line in which people queue, from who is next to the last; empty for a crowd [m]. */
  readonly queue: readonly Vec2[];
  /** For Source in a WorldDef: index of the group whom its people join. */
  readonly group: number;
  /** For Exit: when it opens; for Source with a rate: when it begins [s]. */
  readonly from: number;
  /** For Exit: when it closes; for Source with a rate: when it ends [s]. */
  readonly until: number;
  /** For Source with a rate: how many come in all; 0 for no end. */
  readonly most: number;
  /** For Source: further people, by ascending times. */
  readonly timetable: readonly Arrivals[];
}

/** An order in a group's queue. */
export interface QueuedOrder {
  /** Unique in the world; it is not used again. */
  readonly id: number;
  /** What is to be done. */
  readonly order: Order;
}

/** A finger touches down, moves or lifts, or its control ends at once. One that comes down edits the group whose mesh is nearest within `input.reach`, or `group` if given; when it has lifted, its trajectory is still followed. */
export interface TouchCommand {
  readonly kind: 'touch';
  /** What it does. */
  readonly phase?: TouchPhaseWord;
  /** Number of the finger, unique per client while it is down. */
  readonly touch: number;
  /** For Down and Move: position in the world [m]. */
  readonly position: Vec2;
  /** World time stamp; not read for Cancel [s]. */
  readonly time: number;
  /** For Down: group to edit; none to pick it by position. */
  readonly group?: number;
}

/** Makes a control of all its points at once, for mouse and programs. Its points are then moved and lifted like touches. */
export interface AddControlCommand {
  readonly kind: 'control';
  /** Group whose mesh it controls. */
  readonly group: number;
  /** Kind of control, which must fit the number of touches. */
  readonly control?: ControlKindWord;
  /** Numbers of its fingers, 1 to 64. */
  readonly touches?: readonly number[];
  /** Positions in the world, one per touch [m]. */
  readonly positions?: readonly Vec2[];
  /** World time stamp [s]. */
  readonly time: number;
}

/** Pins a control at the end of its trajectory, releases it, or ends it at once. */
export interface EditControlCommand {
  readonly kind: 'editControl';
  /** Group that the control belongs to. */
  readonly group: number;
  /** Its id. */
  readonly control: number;
  /** What is done to it. */
  readonly edit: ControlEditWord;
}

/** A client has disconnected: all its fingers lift. */
export interface ReleaseClientCommand {
  readonly kind: 'release';
}

/** Changes what a group is. What is not given stays as it is. First comes the formation with its number of places, then the sorts of people, who joins or leaves, and all else. Where one of them cannot be, none is changed. */
export interface ChangeGroupCommand {
  readonly kind: 'changeGroup';
  /** Group to change. */
  readonly group: number;
  /** Its formation; none for the one that it has. */
  readonly formation?: Given<FormationDef | null>;
  /** Its number of characters: new ones join behind the mesh, those with the highest ids leave first; none for the number that it has. */
  readonly count?: number | null;
  /** Its sorts of persons, empty where all are as GroupDef::bodies say. Persons who join it are drawn by them from now on. Its present members are drawn again, as those who come at once: each number that neither the sorts before nor these draw stays as it is. A person who has heard an order sets out when it was to; none for the sorts that it has. */
  readonly people?: Given<readonly PeopleDef[] | null>;
  /** How it behaves; none for as it does. */
  readonly conduct?: Given<Conduct | null>;
  /** Which class stands where, in the order in which they choose places; none for the roles that it has. */
  readonly roles?: Given<readonly RoleDef[] | null>;
  /** How many units of supply each place demands (SPEC A1), 0 to 1000, of each place, or empty for 1 each; none for the demands that these have. */
  readonly demands?: readonly number[] | null;
  /** Its name, of at most 4,096 bytes; none for the one that it has. */
  readonly name?: string | null;
  /** Its colour; none for the one that it has. */
  readonly colour?: Given<GroupColour | null>;
  /** How its people look; none for as they do. */
  readonly look?: Given<GroupLook | null>;
}

/** Moves the mesh of a group at once; its places and its characters walk there, or stand there at once. Its orders and controls end. */
export interface SetPoseCommand {
  readonly kind: 'pose';
  /** Group to move. */
  readonly group: number;
  /** New centre of the mesh in the world [m]. */
  readonly position: Vec2;
  /** New heading, counter-clockwise from +x [rad]. */
  readonly angle?: number;
  /** True: its places and characters are there at once, and stand still. */
  readonly characters?: boolean;
}

/** Adds a group. */
export interface AddGroupCommand {
  readonly kind: 'group';
  /** Its definition. */
  readonly group: Given<GroupDef>;
}

/** Removes a group and its characters. */
export interface RemoveGroupCommand {
  readonly kind: 'removeGroup';
  /** Group to remove. */
  readonly group: number;
}

/** Puts a thing into the place, or gives one another definition. Exactly one of the five definitions says what it is. An item that is collected stays so, and a checkpoint stays passed by the groups that have passed it. */
export interface PutThingCommand {
  readonly kind: 'putThing';
  /** Thing that gets another definition; 0 to add one. */
  readonly id?: number;
  /** An obstacle; none for other things. */
  readonly obstacle?: Given<ObstacleDef | null>;
  /** A patch; none for other things. */
  readonly patch?: Given<PatchDef | null>;
  /** An item to collect; none for other things. */
  readonly item?: Given<ItemDef | null>;
  /** A formation checkpoint (SPEC M7), whose `group` is not read; none for other things. */
  readonly checkpoint?: Given<CheckpointDef | null>;
  /** An area, whose `group` is not read; none for other things. */
  readonly area?: Given<AreaDef | null>;
  /** Group that a checkpoint concerns, none for any, or that people of a source join. */
  readonly group?: number;
}

/** Removes a thing. People on their way to an area that is removed go to the other areas of their order, or stand. */
export interface RemoveThingCommand {
  readonly kind: 'removeThing';
  /** What it is. */
  readonly thing: ThingKindWord;
  /** Its id. */
  readonly id: number;
}

/** Changes the value of a parameter. */
export interface SetParameterCommand {
  readonly kind: 'parameter';
  /** Name in parameterTable(): "plan.exponent". */
  readonly name: string;
  /** New value, in the range of the parameter. */
  readonly value: number;
}

/** Puts an order into a group's queue. The event OrderGiven tells its id. */
export interface GiveOrderCommand {
  readonly kind: 'order';
  /** The group. */
  readonly group: number;
  /** Where the order stands in the queue. */
  readonly mode?: QueueModeWord;
  /** For Insert: before which order, counted from 0. */
  readonly index?: number;
  /** The order. */
  readonly order: Given<Order>;
}

/** Changes a group's queue. */
export interface EditQueueCommand {
  readonly kind: 'queue';
  /** The group. */
  readonly group: number;
  /** What is done to the queue. */
  readonly edit: QueueEditWord;
  /** For Cancel: the id of the order; 0 for all. */
  readonly order?: number;
}

/** Characters join a group where they stand; places are added to its formation. Events Joined tell their ids. */
export interface AddCharactersCommand {
  readonly kind: 'join';
  /** Group that they join. */
  readonly group: number;
  /** Where they stand; they part where they would stand in each other [m]. */
  readonly positions: readonly Vec2[];
  /** One for each, or one for all; empty for that of the group. */
  readonly bodies?: Given<readonly Body[]>;
}

/** Characters leave their groups for another one, or leave the world. Ids, positions and velocities stay. The ranks behind them close up; a group may become empty, and stays. */
export interface TransferCharactersCommand {
  readonly kind: 'transfer';
  /** Their ids. */
  readonly ids: readonly number[];
  /** Group that they join; none to leave the world. */
  readonly group?: number;
}

/** Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops, and all parts go on with the orders of the whole. */
export interface SplitGroupCommand {
  readonly kind: 'split';
  /** The group. */
  readonly group: number;
  /** How it is divided. */
  readonly by: SplitByWord;
  /** For Ids: the characters that leave. */
  readonly ids: readonly number[];
  /** For Line: two points; for Lasso: the corners of the polygon [m]. */
  readonly points?: readonly Vec2[];
  /** For Shares: of all parts, above 0; their sum counts as the whole. */
  readonly shares?: readonly number[];
  /** For Shares: parts lie side by side, not one behind the other. */
  readonly abreast?: boolean;
  /** Formation of the parts. */
  readonly shape?: PartShapeWord;
}

/** Joins groups to the first of them; the others end. */
export interface MergeGroupsCommand {
  readonly kind: 'merge';
  /** Two or more. */
  readonly groups: readonly number[];
  /** Smaller: the formation of the first for all; AsHeld: all places stay. */
  readonly shape?: PartShapeWord;
}

/** Changes what characters are. What is not given stays as it is. */
export interface ChangeCharactersCommand {
  readonly kind: 'changeCharacters';
  /** Their ids. */
  readonly ids: readonly number[];
  /** Their bodies, one for each or one for all; none for those that they have. */
  readonly bodies?: Given<readonly Body[] | null>;
  /** What moves them; none for what moves them now. */
  readonly driver?: DriverWord | null;
}

/** Where characters that are moved from outside are after this step. */
export interface WriteMotionCommand {
  readonly kind: 'motion';
  /** Their ids. */
  readonly ids: readonly number[];
  /** Where they are [m]. */
  readonly positions: readonly Vec2[];
  /** Their velocities; empty for what follows from the last positions [m/s]. */
  readonly velocities?: readonly Vec2[];
}

/** Reverses the orders of a group's queue: the last one begins, and what is under way comes last. */
export interface ReverseQueueCommand {
  readonly kind: 'reverseQueue';
  /** The group. */
  readonly group: number;
}

/** Any command. */
export type Command =
  | TouchCommand
  | AddControlCommand
  | EditControlCommand
  | ReleaseClientCommand
  | ChangeGroupCommand
  | SetPoseCommand
  | AddGroupCommand
  | RemoveGroupCommand
  | PutThingCommand
  | RemoveThingCommand
  | SetParameterCommand
  | GiveOrderCommand
  | EditQueueCommand
  | AddCharactersCommand
  | TransferCharactersCommand
  | SplitGroupCommand
  | MergeGroupsCommand
  | ChangeCharactersCommand
  | WriteMotionCommand
  | ReverseQueueCommand;
