// Made by schema/generate.mjs from schema/api: change these, not this file.

/** What kind of thing went wrong. */
export const Status = {
  /** Success. */
  Ok: 0,
  /** A value is outside its range or contradicts another. */
  InvalidArgument: 1,
  /** No object has this name or id; also for a handle that was destroyed. */
  NotFound: 2,
  /** Text or bytes that do not follow the format. */
  ParseError: 3,
  /** A file that cannot be read or written. */
  IoError: 4,
  /** A checksum or hash that does not match. */
  Corrupt: 5,
  /** Valid, but of a version or kind not known here. */
  Unsupported: 6,
  /** Too large, too many, too often. */
  LimitExceeded: 7,
  /** Memory could not be had. */
  OutOfMemory: 8,
  /** A fault of Muster itself. */
  Internal: 9,
} as const;
export type Status = (typeof Status)[keyof typeof Status];

/** Kinds of log messages. */
export const LogLevel = {
  /** Something that is good to know, as a command that was refused in its step. */
  Info: 0,
  /** A call failed; the text is its sentence. */
  Failure: 1,
} as const;
export type LogLevel = (typeof LogLevel)[keyof typeof LogLevel];

/** The library of shapes. */
export const FormationKind = {
  /** A filled square. */
  Square: 0,
  /** Two ranks abreast. */
  Line: 1,
  /** Two files along the heading. */
  Column: 2,
  /** A filled triangle with its tip in front. */
  Wedge: 3,
  /** Concentric circles round an open middle. */
  Ring: 4,
  /** A filled disc. */
  Circle: 5,
  /** Concentric arcs, open to the front. */
  Crescent: 6,
  /** A disc with a mouth to the front. */
  Pacman: 7,
  /** Any polygon with holes, scaled to hold the count at the spacing. */
  Outline: 8,
  /** Explicit places; the mesh is made round them. */
  Points: 9,
} as const;
export type FormationKind = (typeof FormationKind)[keyof typeof FormationKind];

/** The build of drawn bodies. */
export const BodyBuild = {
  /** Wide shoulders, short hair. */
  Broad: 0,
  /** Narrow shoulders, wider hips, tied hair. */
  Narrow: 1,
} as const;
export type BodyBuild = (typeof BodyBuild)[keyof typeof BodyBuild];

/** A manner of walking and jogging, with clips of its own. Standing and what patches ask for is the same in all. */
export const MotionSet = {
  /** Upright, with high knees and stiff arms. */
  March: 0,
  /** Stooped, with hanging arms and feet that are hardly lifted. */
  Weary: 1,
} as const;
export type MotionSet = (typeof MotionSet)[keyof typeof MotionSet];

/** The phase of the motion that a character performs (SPEC C1, C3, C4). */
export const MotionPhase = {
  /** It performs the motion of the ground it is on. */
  Steady: 0,
  /** It plays the transition into the motion. */
  Entering: 1,
  /** It plays the transition out of the motion. */
  Leaving: 2,
  /** It is within a single-step motion, which runs once per patch. */
  Locked: 3,
} as const;
export type MotionPhase = (typeof MotionPhase)[keyof typeof MotionPhase];

/** Kind of a control by its number of points: one, two, or three and more. */
export const ControlKind = {
  /** One point. */
  Point: 0,
  /** Two points. */
  Line: 1,
  /** Three points and more. */
  Area: 2,
} as const;
export type ControlKind = (typeof ControlKind)[keyof typeof ControlKind];

/** What an area does. */
export const AreaKind = {
  /** People who are to leave by it go there, and leave the world in it. */
  Exit: 0,
  /** People come into the world in it, where there is room. */
  Source: 1,
  /** People who are to wait in it spread in it and stand. */
  Waiting: 2,
} as const;
export type AreaKind = (typeof AreaKind)[keyof typeof AreaKind];

/** What stands or lies in the place. */
export const ThingKind = {
  /** Something in the way. */
  Obstacle: 0,
  /** Ground on which another motion is performed. */
  Patch: 1,
  /** Something to collect. */
  Item: 2,
  /** Where a formation is asked for. */
  Checkpoint: 3,
  /** An exit, a source or a waiting area. */
  Area: 4,
} as const;
export type ThingKind = (typeof ThingKind)[keyof typeof ThingKind];

/** What passes a checkpoint. */
export const CheckpointTrigger = {
  /** A share of the characters has been in it, or, up to a half, their middle is. */
  Crowd: 0,
  /** The centre of the group's mesh is in it. */
  Mesh: 1,
} as const;
export type CheckpointTrigger = (typeof CheckpointTrigger)[keyof typeof CheckpointTrigger];

/** How a number is spread over persons. */
export const Spread = {
  /** All have `a`. */
  Constant: 0,
  /** Evenly from `a` to `b`. */
  Uniform: 1,
  /** Mean `a`, standard deviation `b`. */
  Normal: 2,
  /** Its logarithm has the mean `a` and the standard deviation `b`. */
  LogNormal: 3,
  /** Shape `a`, at most 10,000, scale `b`. */
  Gamma: 4,
  /** Scale `a`, shape `b`. */
  Weibull: 5,
} as const;
export type Spread = (typeof Spread)[keyof typeof Spread];

/** Parts of a formation. */
export const RoleArea = {
  /** The foremost places. */
  Front: 0,
  /** The hindmost. */
  Rear: 1,
  /** Those nearest to the outline. */
  Rim: 2,
  /** Those nearest to the middle. */
  Centre: 3,
  /** Those farthest to the left. */
  LeftFlank: 4,
  /** Those farthest to the right. */
  RightFlank: 5,
  /** Those farthest from the middle line. */
  Flanks: 6,
} as const;
export type RoleArea = (typeof RoleArea)[keyof typeof RoleArea];

/** Who moves a character. */
export const Driver = {
  /** Steering and contacts. */
  Muster: 0,
  /** Somebody else, by WriteMotion. Others keep clear of it. */
  Outside: 1,
} as const;
export type Driver = (typeof Driver)[keyof typeof Driver];

/** How a group is divided. */
export const SplitBy = {
  /** Those with the given ids leave. */
  Ids: 0,
  /** Those to the left of a line leave, as their places lie. */
  Line: 1,
  /** Those whose places lie in a polygon leave. */
  Lasso: 2,
  /** Parts of given shares, front to back, or left to right. */
  Shares: 3,
} as const;
export type SplitBy = (typeof SplitBy)[keyof typeof SplitBy];

/** The formation of parts. */
export const PartShape = {
  /** The places that they held. */
  AsHeld: 0,
  /** The shape of the whole, for fewer. */
  Smaller: 1,
} as const;
export type PartShape = (typeof PartShape)[keyof typeof PartShape];

/** What an order asks for. */
export const OrderKind = {
  /** Go to `target`, by `route` if one is given. */
  Move: 0,
  /** Turn to `facing` where it stands. */
  Face: 1,
  /** Keep at `offset` from a group or a character, until the next order. */
  Follow: 2,
  /** Stand round a rectangle, which may move, until the next order. */
  Guard: 3,
  /** Leave the world by exits. Nobody has a place meanwhile. */
  Leave: 4,
  /** Go to a waiting area and stand there. Nobody has a place meanwhile. */
  Wait: 5,
  /** Walk on towards `facing` without end. Nobody has a place meanwhile. */
  Walk: 6,
} as const;
export type OrderKind = (typeof OrderKind)[keyof typeof OrderKind];

/** By which exit each leaves. */
export const ExitChoice = {
  /** Where it will have left soonest, with the wait before it. */
  Quickest: 0,
  /** The one with the quickest way. */
  Nearest: 1,
} as const;
export type ExitChoice = (typeof ExitChoice)[keyof typeof ExitChoice];

/** How a group goes to its target. */
export const Manner = {
  /** In formation: the shape goes along the way and waits for the last. */
  March: 0,
  /** Each by the shortest way; the shape at the end. */
  Free: 1,
  /**
   * All to `target` itself, by one cost field that the crowd raises (Treuille et al. 2006): no shape, no places.
   * Those who have come near stand where there is room.
   */
  Continuum: 2,
} as const;
export type Manner = (typeof Manner)[keyof typeof Manner];

/** How a marching formation takes its turns. */
export const Turn = {
  /** It faces along its way, and turns at a bounded rate. */
  Wheel: 0,
  /** As Wheel, but where the way leads back its rear becomes its front, and nobody changes files. */
  Reverse: 1,
  /** It faces one way until it has arrived, and then turns to `facing`. */
  Keep: 2,
  /**
   * Everybody heads for the place that is nearest for all, and the formation flows where the way narrows. In the
   * open nothing arrives sooner.
   */
  Flow: 3,
} as const;
export type Turn = (typeof Turn)[keyof typeof Turn];

/** What a finger or a pointer does. */
export const TouchPhase = {
  /** It comes down. */
  Down: 0,
  /** It moves. */
  Move: 1,
  /** It lifts. */
  Up: 2,
  /** It is lost: its control ends at once. */
  Cancel: 3,
} as const;
export type TouchPhase = (typeof TouchPhase)[keyof typeof TouchPhase];

/** Changes of a control. */
export const ControlEdit = {
  /** It stays at the end of its trajectory. */
  Pin: 0,
  /** It is no longer pinned. */
  Release: 1,
  /** It ends at once. */
  Remove: 2,
} as const;
export type ControlEdit = (typeof ControlEdit)[keyof typeof ControlEdit];

/** Where a new order stands in a queue. */
export const QueueMode = {
  /** It takes the place of all others. */
  Replace: 0,
  /** It comes last. */
  Append: 1,
  /** It comes before the order of a given index. */
  Insert: 2,
} as const;
export type QueueMode = (typeof QueueMode)[keyof typeof QueueMode];

/** Changes of a queue. */
export const QueueEdit = {
  /** Drops one order, or all. */
  Cancel: 0,
  /** The group waits where it is; the queue stays. */
  Hold: 1,
  /** It goes on. */
  Resume: 2,
  /** Orders that are done come last again. */
  Patrol: 3,
  /** They do not. */
  EndPatrol: 4,
  /** Drops all orders, ends all controls, and the group stands where it is. */
  Stop: 5,
} as const;
export type QueueEdit = (typeof QueueEdit)[keyof typeof QueueEdit];

/** Who makes room where groups meet. */
export const Stance = {
  /** Each as much as the other. */
  Normal: 0,
  /** It holds its ground: others go round it. */
  Hold: 1,
  /** It makes room for others. */
  Yield: 2,
} as const;
export type Stance = (typeof Stance)[keyof typeof Stance];

/**
 * Whether a character stands in its place, and if not, what keeps it from there. Of a place it is said where the
 * formation wants it: people stand beside it where they cannot stand there.
 */
export const Standing = {
  /** It stands within 0.5 m of where its formation wants it. */
  InPlace: 0,
  /** It is on its way, or its place is. */
  OnTheWay: 1,
  /** Its group was ordered to hold, or it has not set out yet. */
  Held: 2,
  /** It has not got on for 5 s. */
  Stuck: 3,
  /** Its place lies outside the ground. */
  Outside: 4,
  /** Its place lies in an obstacle. */
  Obstacle: 5,
  /** Its place is too narrow for its body. */
  Narrow: 6,
  /** No way leads to its place. */
  NoWay: 7,
  /** Others have taken the room at its place. */
  Crowded: 8,
  /** Their number. */
  Count: 9,
} as const;
export type Standing = (typeof Standing)[keyof typeof Standing];

/**
 * Kinds of events. Those from Arrived on tell how orders get on and how groups change; each from Arrived to
 * Partial comes once per order and version of the ground. An order is a pose, a formation, a count or a drawn way;
 * the ground changes with every command that changes obstacles or patches.
 */
export const EventKind = {
  /** `value` is the id of the patch. */
  EnterPatch: 0,
  /** `value` is the id of the patch. */
  LeavePatch: 1,
  /** A transition into or out of a motion begins; `value` is the motion id. */
  TransitionStart: 2,
  /** A transition has ended; `value` is the motion id. */
  TransitionEnd: 3,
  /** A jump or climb begins; `value` is the motion id. */
  SingleStep: 4,
  /** An item was collected; `value` is the index of the item. */
  Collect: 5,
  /** A group has another formation; `subject` is the id of the group. */
  FormationChange: 6,
  /** A character's place changed without a command; `value` is the new place. */
  Swap: 7,
  /**
   * All of a group's characters that have a place are within 0.5 m of it for 1 s, and the places stand where the
   * order wants them; `value` is their number.
   */
  Arrived: 8,
  /**
   * A character is not at its place and has moved less than 0.25 m over the last 5 s, and not in a queue that
   * moves on; `value` is the place. Raised again only once it has moved.
   */
  Stuck: 9,
  /**
   * The ground cut off the way of `value` characters of a group, or for 2 s a moving obstacle did, as a gate that
   * closes. One that only passes gives no event.
   */
  Blocked: 10,
  /** All of a group have their way again; `value` is how many had none. */
  Free: 11,
  /**
   * No place of the group's order can be reached, or not by its largest members, who stay behind; `value` is the
   * number of those concerned.
   */
  NoPath: 12,
  /** `value` places of the group's order cannot be reached; the others can. */
  Partial: 13,
  /** A group was given the order of id `value`. */
  OrderGiven: 14,
  /** It begins the order of id `value`. */
  OrderBegun: 15,
  /** It has carried out the order of id `value`. */
  OrderDone: 16,
  /** It passes over the order of id `value`, whose target cannot be reached. */
  OrderSkipped: 17,
  /** A group has passed the checkpoint of index `value`. */
  Passed: 18,
  /** A group is new; `value` is the id of the group that it was split off, 0 for none. */
  GroupAdded: 19,
  /** A group has ended; `value` is the id of the group that it was merged into, 0 for none. */
  GroupRemoved: 20,
  /** A character is new; `value` is the id of its group. */
  Joined: 21,
  /** A character has left the world; `value` is the id of its group. */
  Left: 22,
  /** A character has changed groups; `value` is the id of its new group. */
  Transferred: 23,
  /** A character has left the world by an exit; `value` is the id of that area. */
  Exited: 24,
  /** A character has come into the world by a source; `value` is the id of that area. */
  Entered: 25,
  /** Their number. */
  Count: 26,
} as const;
export type EventKind = (typeof EventKind)[keyof typeof EventKind];

/** Index of a motion clip in the world's table of clips; 0 is running in the open. */
export type MotionIndex = number;

/** Names an obstacle of a world; 0 for none. It is not used again. */
export type ObstacleId = number;

/** Names a patch of a world; 0 for none. */
export type PatchId = number;

/** Names a group of a world; 0 for none. */
export type GroupId = number;

/** Names an item of a world; 0 for none. */
export type ItemId = number;

/** Names a formation checkpoint of a world; 0 for none. */
export type CheckpointId = number;

/** Names an exit, a source or a waiting area; 0 for none. */
export type AreaId = number;

/** Names a control of a world; 0 for none. */
export type ControlId = number;

/** Names a character of a world; 0 for none. */
export type CharacterId = number;

/** Names an order in a queue; 0 for none. */
export type OrderId = number;

/** Kinds of commands. */
export const CommandKind = {
  /** Its body is `touch`. */
  Touch: 0,
  /** Its body is `addControl`. */
  AddControl: 1,
  /** Its body is `editControl`. */
  EditControl: 2,
  /** Its body is `releaseClient`. */
  ReleaseClient: 3,
  /** Its body is `changeGroup`. */
  ChangeGroup: 4,
  /** Its body is `setPose`. */
  SetPose: 5,
  /** Its body is `addGroup`. */
  AddGroup: 6,
  /** Its body is `removeGroup`. */
  RemoveGroup: 7,
  /** Its body is `putThing`. */
  PutThing: 8,
  /** Its body is `removeThing`. */
  RemoveThing: 9,
  /** Its body is `setParameter`. */
  SetParameter: 10,
  /** Its body is `giveOrder`. */
  GiveOrder: 11,
  /** Its body is `editQueue`. */
  EditQueue: 12,
  /** Its body is `addCharacters`. */
  AddCharacters: 13,
  /** Its body is `transferCharacters`. */
  TransferCharacters: 14,
  /** Its body is `splitGroup`. */
  SplitGroup: 15,
  /** Its body is `mergeGroups`. */
  MergeGroups: 16,
  /** Its body is `changeCharacters`. */
  ChangeCharacters: 17,
  /** Its body is `writeMotion`. */
  WriteMotion: 18,
  /** Its body is `reverseQueue`. */
  ReverseQueue: 19,
  /** Number of kinds. */
  Count: 20,
} as const;
export type CommandKind = (typeof CommandKind)[keyof typeof CommandKind];

/** The joints, parents before children. The values are indices into every array of joints. */
export const JointRole = {
  /** The hips. */
  Hips: 0,
  /** The spine. */
  Spine: 1,
  /** The chest. */
  Chest: 2,
  /** The neck. */
  Neck: 3,
  /** The head. */
  Head: 4,
  /** The left shoulder. */
  LeftShoulder: 5,
  /** The left arm. */
  LeftArm: 6,
  /** The left fore arm. */
  LeftForeArm: 7,
  /** The left hand. */
  LeftHand: 8,
  /** The right shoulder. */
  RightShoulder: 9,
  /** The right arm. */
  RightArm: 10,
  /** The right fore arm. */
  RightForeArm: 11,
  /** The right hand. */
  RightHand: 12,
  /** The left up leg. */
  LeftUpLeg: 13,
  /** The left leg. */
  LeftLeg: 14,
  /** The left foot. */
  LeftFoot: 15,
  /** The left toe base. */
  LeftToeBase: 16,
  /** The right up leg. */
  RightUpLeg: 17,
  /** The right leg. */
  RightLeg: 18,
  /** The right foot. */
  RightFoot: 19,
  /** The right toe base. */
  RightToeBase: 20,
  /** Their number. */
  Count: 21,
} as const;
export type JointRole = (typeof JointRole)[keyof typeof JointRole];

/** The part of a body that touches something in a contact. */
export const Limb = {
  /** The left foot. */
  LeftFoot: 0,
  /** The right foot. */
  RightFoot: 1,
  /** The left hand. */
  LeftHand: 2,
  /** The right hand. */
  RightHand: 3,
  /** The left knee. */
  LeftKnee: 4,
  /** The right knee. */
  RightKnee: 5,
  /** Their number. */
  Count: 6,
} as const;
export type Limb = (typeof Limb)[keyof typeof Limb];

/** Where a replay takes positions from. */
export const ReplayFrom = {
  /** The world simulates everything again. */
  Simulation: 0,
  /** Characters are put where the stored frames say; nothing is compared. */
  Frames: 1,
} as const;
export type ReplayFrom = (typeof ReplayFrom)[keyof typeof ReplayFrom];
