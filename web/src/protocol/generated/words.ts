// Made by schema/generate.mjs from schema/enumerations.txt: change these, not this file.
/** The library of shapes. In the order of values. */
// prettier-ignore
export const kFormationKindWords = ['square', 'line', 'column', 'wedge', 'ring', 'circle', 'crescent', 'pacman', 'outline', 'points'] as const;
export type FormationKindWord = (typeof kFormationKindWords)[number];

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

/** What an area does. In the order of values. */
// prettier-ignore
export const kAreaKindWords = ['exit', 'source', 'waiting'] as const;
export type AreaKindWord = (typeof kAreaKindWords)[number];

/** What stands or lies in the place. In the order of values. */
// prettier-ignore
export const kThingKindWords = ['obstacle', 'patch', 'item', 'checkpoint', 'area'] as const;
export type ThingKindWord = (typeof kThingKindWords)[number];

/** What passes a checkpoint. In the order of values. */
// prettier-ignore
export const kCheckpointTriggerWords = ['crowd', 'mesh'] as const;
export type CheckpointTriggerWord = (typeof kCheckpointTriggerWords)[number];

/** How a number is spread over persons. In the order of values. */
// prettier-ignore
export const kSpreadWords = ['constant', 'uniform', 'normal', 'logNormal', 'gamma', 'weibull'] as const;
export type SpreadWord = (typeof kSpreadWords)[number];

/** Parts of a formation. In the order of values. */
// prettier-ignore
export const kRoleAreaWords = ['front', 'rear', 'rim', 'centre', 'leftFlank', 'rightFlank', 'flanks'] as const;
export type RoleAreaWord = (typeof kRoleAreaWords)[number];

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

/** By which exit each leaves. In the order of values. */
// prettier-ignore
export const kExitChoiceWords = ['quickest', 'nearest'] as const;
export type ExitChoiceWord = (typeof kExitChoiceWords)[number];

/** How a group goes to its target. In the order of values. */
// prettier-ignore
export const kMannerWords = ['march', 'free', 'continuum'] as const;
export type MannerWord = (typeof kMannerWords)[number];

/** How a marching formation takes its turns. In the order of values. */
// prettier-ignore
export const kTurnWords = ['wheel', 'reverse', 'keep', 'flow'] as const;
export type TurnWord = (typeof kTurnWords)[number];

/** What a finger or a pointer does. In the order of values. */
// prettier-ignore
export const kTouchPhaseWords = ['down', 'move', 'up', 'cancel'] as const;
export type TouchPhaseWord = (typeof kTouchPhaseWords)[number];

/** Changes of a control. In the order of values. */
// prettier-ignore
export const kControlEditWords = ['pin', 'release', 'remove'] as const;
export type ControlEditWord = (typeof kControlEditWords)[number];

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

/** By name. */
export const kWords: Readonly<Record<string, readonly string[]>> = {
  FormationKind: kFormationKindWords,
  BodyBuild: kBodyBuildWords,
  MotionSet: kMotionSetWords,
  ControlKind: kControlKindWords,
  AreaKind: kAreaKindWords,
  ThingKind: kThingKindWords,
  CheckpointTrigger: kCheckpointTriggerWords,
  Spread: kSpreadWords,
  RoleArea: kRoleAreaWords,
  Driver: kDriverWords,
  SplitBy: kSplitByWords,
  PartShape: kPartShapeWords,
  OrderKind: kOrderKindWords,
  ExitChoice: kExitChoiceWords,
  Manner: kMannerWords,
  Turn: kTurnWords,
  TouchPhase: kTouchPhaseWords,
  ControlEdit: kControlEditWords,
  QueueMode: kQueueModeWords,
  QueueEdit: kQueueEditWords,
  Stance: kStanceWords,
};
