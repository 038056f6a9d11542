// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// Commands as events of gesture files: what a Commands message carries.

/** What has a form of its own: definitions, orders, conducts (docs/scenario-format.md). */
export type Fields = Readonly<Record<string, unknown>>;

/** The build of drawn bodies. In the order of values. */
// prettier-ignore
export const kBodyBuildWords = ['broad', 'narrow'] as const;
export type BodyBuildWord = (typeof kBodyBuildWords)[number];

/** A manner of walking and jogging, with clips of its own. Standing and what patches ask for is the same in all. In the order of values. */
// prettier-ignore
export const kMotionSetWords = ['march', 'weary'] as const;
export type MotionSetWord = (typeof kMotionSetWords)[number];

/** Kind of a control by its number of points: one, two, or three and more. In the order of values. */
// prettier-ignore
export const kControlKindWords = ['point', 'line', 'area'] as const;
export type ControlKindWord = (typeof kControlKindWords)[number];

/** What stands or lies in the place. In the order of values. */
// prettier-ignore
export const kThingKindWords = ['obstacle', 'patch', 'item', 'checkpoint', 'area'] as const;
export type ThingKindWord = (typeof kThingKindWords)[number];

/** Who moves a character. In the order of values. */
// prettier-ignore
export const kDriverWords = ['muster', 'outside'] as const;
export type DriverWord = (typeof kDriverWords)[number];

/** How a group is divided. In the order of values. */
// prettier-ignore
export const kSplitByWords = ['ids', 'line', 'lasso', 'shares'] as const;
export type SplitByWord = (typeof kSplitByWords)[number];

/** The formation of parts. In the order of values. */
// prettier-ignore
export const kPartShapeWords = ['asHeld', 'smaller'] as const;
export type PartShapeWord = (typeof kPartShapeWords)[number];

/** What an order asks for. In the order of values. */
// prettier-ignore
export const kOrderKindWords = ['move', 'face', 'follow', 'guard', 'leave', 'wait', 'walk'] as const;
export type OrderKindWord = (typeof kOrderKindWords)[number];

/** How a group goes to its target. In the order of values. */
// prettier-ignore
export const kMannerWords = ['march', 'free', 'continuum'] as const;
export type MannerWord = (typeof kMannerWords)[number];

/** How a marching formation takes its turns. In the order of values. */
// prettier-ignore
export const kTurnWords = ['wheel', 'reverse', 'keep', 'flow'] as const;
export type TurnWord = (typeof kTurnWords)[number];

/** Where a new order stands in a queue. In the order of values. */
// prettier-ignore
export const kQueueModeWords = ['replace', 'append', 'insert'] as const;
export type QueueModeWord = (typeof kQueueModeWords)[number];

/** Changes of a queue. In the order of values. */
// prettier-ignore
export const kQueueEditWords = ['cancel', 'hold', 'resume', 'patrol', 'endPatrol', 'stop'] as const;
export type QueueEditWord = (typeof kQueueEditWords)[number];

/** Who makes room where groups meet. In the order of values. */
// prettier-ignore
export const kStanceWords = ['normal', 'hold', 'yield'] as const;
export type StanceWord = (typeof kStanceWords)[number];

/** A finger touches down. It edits the group whose mesh is nearest within `input.reach`, or `group` if given. */
export interface TouchDownEvent {
  readonly kind: 'down';
  /** Number of the finger, unique per client while it is down. */
  readonly touch: number;
  /** Position in the world [m]. */
  readonly x: number;
  readonly y: number;
  /** Group to edit; none to pick it by position. */
  readonly group?: number;
}

/** A finger moves. */
export interface TouchMoveEvent {
  readonly kind: 'move';
  /** Number of the finger. */
  readonly touch: number;
  /** Position in the world [m]. */
  readonly x: number;
  readonly y: number;
}

/** A finger lifts; its trajectory is still followed. */
export interface TouchUpEvent {
  readonly kind: 'up';
  /** Number of the finger. */
  readonly touch: number;
}

/** The control of a finger ends at once. */
export interface TouchCancelEvent {
  readonly kind: 'cancel';
  /** Number of the finger. */
  readonly touch: number;
}

/** Makes a control of all its points at once, for mouse and programs. Its points are then moved and lifted like touches. */
export interface AddControlEvent extends Fields {
  readonly kind: 'control';
  /** Group whose mesh it controls. */
  readonly group: number;
  /** Kind of control, which must fit the number of touches. */
  readonly control?: ControlKindWord;
}

/** Pins a control at the end of its trajectory, or releases it. */
export interface PinControlEvent {
  readonly kind: 'pin';
  /** Group that the control belongs to. */
  readonly group: number;
  /** Its id. */
  readonly control: number;
  /** False to release it. */
  readonly pinned?: boolean;
}

/** Ends a control at once. */
export interface RemoveControlEvent {
  readonly kind: 'remove';
  /** Group that the control belongs to. */
  readonly group: number;
  /** Its id. */
  readonly control: number;
}

/** A client has disconnected: all its fingers lift. */
export interface ReleaseClientEvent {
  readonly kind: 'release';
}

/** The group takes another formation. */
export interface SetFormationEvent {
  readonly kind: 'formation';
  /** Group to change. */
  readonly group: number;
  /** Its new definition. */
  readonly formation: Fields;
}

/** Changes the number of characters. New ones join behind the mesh; those with the highest ids leave first. */
export interface SetCountEvent {
  readonly kind: 'count';
  /** Group to change. */
  readonly group: number;
  /** New number of characters. */
  readonly count: number;
}

/** Moves the mesh at once; its places travel there. */
export interface SetPoseEvent {
  readonly kind: 'pose';
  /** Group to move. */
  readonly group: number;
  /** New centre of the mesh in the world [m]. */
  readonly x: number;
  readonly y: number;
  /** New heading, counter-clockwise from +x [rad]. */
  readonly angle?: number;
}

/** Adds a group. */
export interface AddGroupEvent {
  readonly kind: 'group';
  /** Its definition. */
  readonly definition: Fields;
}

/** Removes a group and its characters. */
export interface RemoveGroupEvent {
  readonly kind: 'removeGroup';
  /** Group to remove. */
  readonly group: number;
}

/** Puts a thing into the place, or gives one another definition. Exactly one of the five definitions says what it is. An item that is collected stays so, and a checkpoint stays passed by the groups that have passed it. */
export interface PutThingEvent {
  readonly kind: 'putThing';
  /** Thing that gets another definition; 0 to add one. */
  readonly id?: number;
  /** An obstacle; none for other things. */
  readonly obstacle?: Fields;
  /** A patch; none for other things. */
  readonly patch?: Fields;
  /** An item to collect; none for other things. */
  readonly item?: Fields;
  /** A formation checkpoint (SPEC M7), whose `group` is not read; none for other things. */
  readonly checkpoint?: Fields;
  /** An area, whose `group` is not read; none for other things. */
  readonly area?: Fields;
  /** For a checkpoint: the group that it concerns, none for any. For a source: the group that its people join. */
  readonly group?: number;
}

/** Removes a thing. People on their way to an area that is removed go to the other areas of their order, or stand. */
export interface RemoveThingEvent {
  readonly kind: 'removeThing';
  /** What it is. */
  readonly thing: ThingKindWord;
  /** Its id. */
  readonly id: number;
}

/** Changes the value of a parameter. */
export interface SetParameterEvent {
  readonly kind: 'parameter';
  /** Name in parameterTable(): "plan.exponent". */
  readonly name: string;
  /** New value, in the range of the parameter. */
  readonly value: number;
}

/** Puts an order into a group's queue. The event OrderGiven tells its id. */
export interface GiveOrderEvent extends Fields {
  readonly kind: OrderKindWord;
  /** The group. */
  readonly group: number;
  /** Where the order stands in the queue. */
  readonly mode?: QueueModeWord;
  /** For Insert: before which order, counted from 0. */
  readonly index?: number;
}

/** Changes a group's queue. */
export interface EditQueueEvent {
  readonly kind: 'queue';
  /** The group. */
  readonly group: number;
  /** What is done to the queue. */
  readonly edit: QueueEditWord;
  /** For Cancel: the id of the order; 0 for all. */
  readonly order?: number;
}

/** Tells a group how to behave. */
export interface SetConductEvent extends Fields {
  readonly kind: 'conduct';
  /** The group. */
  readonly group: number;
}

/** Characters join a group where they stand; places are added to its formation. Events Joined tell their ids. */
export interface AddCharactersEvent {
  readonly kind: 'join';
  /** Group that they join. */
  readonly group: number;
  /** Where they stand; they part where they would stand in each other [m]. */
  readonly positions: readonly (readonly [number, number])[];
  /** One for each, or one for all; empty for that of the group. */
  readonly bodies?: readonly Fields[];
}

/** Characters leave the world; the ranks behind them close up. A group may become empty, and stays. */
export interface RemoveCharactersEvent {
  readonly kind: 'leave';
  /** Their ids. */
  readonly ids: readonly number[];
}

/** Characters leave their groups for another one. Ids, positions and velocities stay. */
export interface TransferCharactersEvent {
  readonly kind: 'transfer';
  /** Their ids. */
  readonly ids: readonly number[];
  /** Group that they join. */
  readonly group: number;
}

/** Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops, and all parts go on with the orders of the whole. */
export interface SplitGroupEvent {
  readonly kind: 'split';
  /** The group. */
  readonly group: number;
  /** How it is divided. */
  readonly by: SplitByWord;
  /** For Ids: the characters that leave. */
  readonly ids?: readonly number[];
  /** For Line: two points; for Lasso: the corners of the polygon [m]. */
  readonly points?: readonly (readonly [number, number])[];
  /** For Shares: of all parts, above 0; their sum counts as the whole. */
  readonly shares?: readonly number[];
  /** For Shares: parts lie side by side, not one behind the other. */
  readonly abreast?: boolean;
  /** Formation of the parts. */
  readonly shape?: PartShapeWord;
}

/** Joins groups to the first of them; the others end. */
export interface MergeGroupsEvent {
  readonly kind: 'merge';
  /** Two or more. */
  readonly groups: readonly number[];
  /** Smaller: the formation of the first for all; AsHeld: all places stay. */
  readonly shape?: PartShapeWord;
}

/** Gives characters other bodies. */
export interface SetBodiesEvent {
  readonly kind: 'bodies';
  /** Their ids. */
  readonly ids: readonly number[];
  /** One for each, or one for all. */
  readonly bodies: readonly Fields[];
}

/** Says which class stands where in a formation. */
export interface SetRolesEvent {
  readonly kind: 'roles';
  /** The group. */
  readonly group: number;
  /** In the order in which they choose places; empty for none. */
  readonly roles?: readonly Fields[];
}

/** Says how many units of supply each place demands (SPEC A1). */
export interface SetDemandsEvent {
  readonly kind: 'demands';
  /** The group. */
  readonly group: number;
  /** Of each place, 0 to 1000; empty for 1 each. */
  readonly demands: readonly number[];
}

/** Says what moves characters. */
export interface SetDriverEvent {
  readonly kind: 'driver';
  /** Their ids. */
  readonly ids: readonly number[];
  /** What moves them. */
  readonly driver: DriverWord;
}

/** Where characters that are moved from outside are after this step. */
export interface WriteMotionEvent {
  readonly kind: 'motion';
  /** Their ids. */
  readonly ids: readonly number[];
  /** Where they are [m]. */
  readonly positions: readonly (readonly [number, number])[];
  /** Their velocities; empty for what follows from the last positions [m/s]. */
  readonly velocities?: readonly (readonly [number, number])[];
}

/** Puts a group elsewhere at once: its mesh, its places, and its characters, who stand still there. Its orders and controls end. (SetPose moves the mesh alone, and characters walk.) */
export interface PlaceGroupEvent {
  readonly kind: 'placeGroup';
  /** The group. */
  readonly group: number;
  /** New centre of the formation [m]. */
  readonly x: number;
  readonly y: number;
  /** New heading, counter-clockwise from +x [rad]. */
  readonly angle?: number;
}

/** Gives a group another name. */
export interface NameGroupEvent {
  readonly kind: 'nameGroup';
  /** The group. */
  readonly group: number;
  /** At most 4,096 bytes. */
  readonly name: string;
}

/** Gives a group another colour. */
export interface ColourGroupEvent {
  readonly kind: 'colourGroup';
  /** The group. */
  readonly group: number;
  /** 0xRRGGBB; none for the palette's, by the group's id. */
  readonly colour?: string;
}

/** Gives the people of a group another appearance. */
export interface SetAppearanceEvent {
  readonly kind: 'appearance';
  /** The group. */
  readonly group: number;
  /** Build of its drawn bodies; none for both, by the character's id. */
  readonly build?: BodyBuildWord;
  /** How it walks and jogs; none for the plain manner. */
  readonly motions?: MotionSetWord;
}

/** Gives a group other sorts of persons. Persons who join it by number or by a source are drawn by them from now on. Its present members are drawn again, as those who come at once: each number that neither the sorts before nor these draw stays as it is. A person who has heard an order sets out when it was to. */
export interface SetPeopleEvent extends Fields {
  readonly kind: 'people';
  /** The group. */
  readonly group: number;
}

/** Reverses the orders of a group's queue: the last one begins, and what is under way comes last. */
export interface ReverseQueueEvent {
  readonly kind: 'reverseQueue';
  /** The group. */
  readonly group: number;
}

/** Any command, as the page writes it. */
export type CommandEvent =
  | TouchDownEvent
  | TouchMoveEvent
  | TouchUpEvent
  | TouchCancelEvent
  | AddControlEvent
  | PinControlEvent
  | RemoveControlEvent
  | ReleaseClientEvent
  | SetFormationEvent
  | SetCountEvent
  | SetPoseEvent
  | AddGroupEvent
  | RemoveGroupEvent
  | PutThingEvent
  | RemoveThingEvent
  | SetParameterEvent
  | GiveOrderEvent
  | EditQueueEvent
  | SetConductEvent
  | AddCharactersEvent
  | RemoveCharactersEvent
  | TransferCharactersEvent
  | SplitGroupEvent
  | MergeGroupsEvent
  | SetBodiesEvent
  | SetRolesEvent
  | SetDemandsEvent
  | SetDriverEvent
  | WriteMotionEvent
  | PlaceGroupEvent
  | NameGroupEvent
  | ColourGroupEvent
  | SetAppearanceEvent
  | SetPeopleEvent
  | ReverseQueueEvent;
