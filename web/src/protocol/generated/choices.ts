// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.

export const VERSION = 18;
/** Of the WebSocket. */
export const SUBPROTOCOL = 'muster.v18';

/** What a person wants of time. */
export const PlaybackAction = {
  Play: 0,
  Pause: 1,
  SingleStep: 2,
  Restart: 3,
  Demonstrate: 4,
  GoBack: 5,
  LeaveTake: 6,
} as const;
export type PlaybackAction = (typeof PlaybackAction)[keyof typeof PlaybackAction];

/** What the ground is coloured by. */
export const OverlayKind = {
  None: 0,
  Field: 1,
  Cost: 2,
  Density: 3,
  Reach: 4,
} as const;
export type OverlayKind = (typeof OverlayKind)[keyof typeof OverlayKind];

/** What moves. */
export const MovingKind = {
  Obstacle: 0,
  Patch: 1,
} as const;
export type MovingKind = (typeof MovingKind)[keyof typeof MovingKind];

/** What a mark of a take stands for. */
export const TakeMarkKind = {
  Touch: 0,
  Order: 1,
  Change: 2,
  Event: 3,
} as const;
export type TakeMarkKind = (typeof TakeMarkKind)[keyof typeof TakeMarkKind];

/** What is wrong with an edited path. */
export const EditFindingKind = {
  Person: 0,
  Obstacle: 1,
  Outside: 2,
  Speed: 3,
} as const;
export type EditFindingKind = (typeof EditFindingKind)[keyof typeof EditFindingKind];

/** How serious a notice is. */
export const NoticeLevel = {
  Info: 0,
  Warning: 1,
  Error: 2,
} as const;
export type NoticeLevel = (typeof NoticeLevel)[keyof typeof NoticeLevel];

/** What a person uses. */
export const InputKind = {
  Pointer: 0,
  Key: 1,
} as const;
export type InputKind = (typeof InputKind)[keyof typeof InputKind];

/** What points. */
export const PointerDevice = {
  Touch: 0,
  Pen: 1,
  Mouse: 2,
} as const;
export type PointerDevice = (typeof PointerDevice)[keyof typeof PointerDevice];

/** Buttons of a pointer. */
export const PointerButton = {
  Left: 0,
  Middle: 1,
  Right: 2,
} as const;
export type PointerButton = (typeof PointerButton)[keyof typeof PointerButton];

/** How a question is answered. */
export const QuestionKind = {
  Number: 0,
  Scale: 1,
  Choice: 2,
  Text: 3,
} as const;
export type QuestionKind = (typeof QuestionKind)[keyof typeof QuestionKind];

/** Where a run of the study stands. */
export const StudyStage = {
  Form: 0,
  Ready: 1,
  Trial: 2,
  Paused: 3,
  Thanks: 4,
  BrokenOff: 5,
  Elsewhere: 6,
  Replay: 7,
} as const;
export type StudyStage = (typeof StudyStage)[keyof typeof StudyStage];

/** What a person wants in a run of the study. */
export const StudyAct = {
  Start: 0,
  GoOn: 1,
  GiveUp: 2,
  BreakOff: 3,
} as const;
export type StudyAct = (typeof StudyAct)[keyof typeof StudyAct];

/** What is wanted of a sentence. */
export const SayAct = {
  Complete: 0,
  Preview: 1,
  Do: 2,
  Look: 3,
} as const;
export type SayAct = (typeof SayAct)[keyof typeof SayAct];

/** How a trial ended. */
export const TrialEnd = {
  None: 0,
  Done: 1,
  TimeOver: 2,
  GivenUp: 3,
  Practised: 4,
} as const;
export type TrialEnd = (typeof TrialEnd)[keyof typeof TrialEnd];

/** What a director did with the world of all. */
export const WorldChange = {
  None: 0,
  Opened: 1,
  Restarted: 2,
  Watched: 3,
  WentBack: 4,
} as const;
export type WorldChange = (typeof WorldChange)[keyof typeof WorldChange];

/** What a block of a take's time line stands for. */
export const TakeBlockKind = {
  Order: 0,
  Gesture: 1,
  Change: 2,
} as const;
export type TakeBlockKind = (typeof TakeBlockKind)[keyof typeof TakeBlockKind];

/** What is done to the blocks of the open take. */
export const TrackEdit = {
  Move: 0,
  Copy: 1,
  Remove: 2,
  Stretch: 3,
  Undo: 4,
  Redo: 5,
} as const;
export type TrackEdit = (typeof TrackEdit)[keyof typeof TrackEdit];

/** Kind of a control by its number of points: one, two, or three and more. */
export const ControlKind = {
  Point: 0,
  Line: 1,
  Area: 2,
} as const;
export type ControlKind = (typeof ControlKind)[keyof typeof ControlKind];

/** What a finger or a pointer does. */
export const TouchPhase = {
  Down: 0,
  Move: 1,
  Up: 2,
  Cancel: 3,
} as const;
export type TouchPhase = (typeof TouchPhase)[keyof typeof TouchPhase];

/** Who makes room where groups meet. */
export const Stance = {
  Normal: 0,
  Hold: 1,
  Yield: 2,
} as const;
export type Stance = (typeof Stance)[keyof typeof Stance];

/** Whether a character stands in its place, and if not, what keeps it from there. Of a place it is said where the formation wants it: people stand beside it where they cannot stand there. */
export const Standing = {
  InPlace: 0,
  OnTheWay: 1,
  Held: 2,
  Stuck: 3,
  Outside: 4,
  Obstacle: 5,
  Narrow: 6,
  NoWay: 7,
  Crowded: 8,
} as const;
export type Standing = (typeof Standing)[keyof typeof Standing];

/** Kinds of events. Those from Arrived on tell how orders get on and how groups change; each from Arrived to Partial comes once per order and version of the ground. An order is a pose, a formation, a count or a drawn way; the ground changes with every command that changes obstacles or patches. */
export const EventKind = {
  EnterPatch: 0,
  LeavePatch: 1,
  TransitionStart: 2,
  TransitionEnd: 3,
  SingleStep: 4,
  Collect: 5,
  FormationChange: 6,
  Swap: 7,
  Arrived: 8,
  Stuck: 9,
  Blocked: 10,
  Free: 11,
  NoPath: 12,
  Partial: 13,
  OrderGiven: 14,
  OrderBegun: 15,
  OrderDone: 16,
  OrderSkipped: 17,
  Passed: 18,
  GroupAdded: 19,
  GroupRemoved: 20,
  Joined: 21,
  Left: 22,
  Transferred: 23,
  Exited: 24,
  Entered: 25,
} as const;
export type EventKind = (typeof EventKind)[keyof typeof EventKind];
