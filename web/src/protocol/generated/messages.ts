// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.
import type {
  PlaybackAction,
  OverlayKind,
  MovingKind,
  TakeMarkKind,
  EditFindingKind,
  NoticeLevel,
  InputKind,
  PointerDevice,
  PointerButton,
  QuestionKind,
  StudyStage,
  StudyAct,
  SayAct,
  TrialEnd,
  WorldChange,
  TakeBlockKind,
  TrackEdit,
  ControlKind,
  TouchPhase,
  Stance,
  Standing,
  EventKind,
} from './choices';
import type {
  Command,
  Order,
  FormationDef,
  QueuedOrder,
  ObstacleDef,
  PatchDef,
  ItemDef,
  CheckpointDef,
  AreaDef,
  GroupDef,
  Given,
  Vec2,
} from './commands';

/** Somebody who is connected. */
export interface DirectorFrame {
  client: number;
  name: string;
  /** 0 to 15; no two have the same. */
  colour: number;
  /** Ids of the groups that they may direct; empty: all. */
  groups: Uint32Array;
}

/** One finger begins, moves, lifts or is lost, in world coordinates [m]. */
export interface TouchEvent {
  phase: TouchPhase;
  touch: number;
  x: number;
  y: number;
  /** Page clock [s]; the session maps it to world time. */
  time: number;
  /** 0: the nearest mesh within reach. */
  group: number;
}

/** A scenario that the server can load. */
export interface ScenarioInfo {
  /** File name without .json, after its folder's name and a slash. */
  name: string;
  title: string;
  description: string;
  characters: number;
}

/** A held vertex and the way drawn for it [m]. */
export interface ControlPointFrame {
  touch: number;
  down: boolean;
  x: number;
  y: number;
  /** x, y of the checkpoints ahead. */
  path: Float32Array;
}

/** A control on a mesh. */
export interface ControlFrame {
  id: number;
  kind: ControlKind;
  client: number;
  pinned: boolean;
  open: boolean;
  points: ControlPointFrame[];
  /** x, y. */
  supplementary: Float32Array;
}

/** An order that a group might get, or has in its queue, and where the group would begin it. */
export interface ForecastAsk {
  group: number;
  /** Id of an order in its queue; 0: that of asked. */
  order: number;
  /** None where it asks for an order of the queue. */
  asked: Given<Order> | null;
  /** It would begin at x, y, facing; else where the formation is. */
  placed: boolean;
  /** [m]. */
  x: number;
  y: number;
  /** [rad]. */
  facing: number;
}

/** What would come of an order. */
export interface ForecastFrame {
  group: number;
  /** As asked. */
  order: number;
  arrives: boolean;
  /** Infinite where it never arrives [s]. */
  seconds: number;
  /** Where the formation would stand: the target, or the nearest ground to it [m]. */
  x: number;
  y: number;
  /** x, y of its centre, both ends included. */
  way: Float32Array;
}

/** A formation that a group might take up, and where, or places on the ground. */
export interface PlacesAsk {
  group: number;
  /** None: the places are given. */
  formation: Given<FormationDef> | null;
  /** Where the formation's centre would be [m]. */
  x: number;
  y: number;
  /** [rad]. */
  facing: number;
  /** x, y of places on the ground, where there is no formation [m]. */
  places: Float64Array;
  /** People in the formation; 0: as many as the group has. */
  count: number;
}

/** Where each would stand. */
export interface PlacesFrame {
  group: number;
  /** x, y on the ground [m]. */
  places: Float32Array;
  /** Per place a Standing: 0 where it can be reached, else what keeps people from there. */
  unfit: Uint8Array;
  /** One sentence: why it is no formation; else empty. */
  problem: string;
}

/** Somebody who cannot be in its place. */
export interface StandingFrame {
  id: number;
  /** What keeps it from there. */
  standing: Standing;
  /** Where its formation wants it [m]. */
  x: number;
  y: number;
}

/** A group's mesh, places and controls [m]. */
export interface GroupFrame {
  id: number;
  meshVersion: number;
  /** Mean distance to places [m]. */
  lag: number;
  /** Of all walks, as the last plan knows them. */
  walkSum: number;
  /** Sum of their squares. */
  walkSquares: number;
  walkLongest: number;
  /** x, y of Vf. */
  vertices: Float32Array;
  /** Places with another offset than in the last frame sent. */
  moved: Uint32Array;
  /** x, y per such from their points of the mesh [cm]. */
  offsets: Int16Array;
  /** A bit per place, the lowest first, 1: no room for anyone; empty where unchanged. */
  unfit: Uint8Array;
  /** How many stand as each Standing tells, in its order; empty where unchanged. */
  standings: Uint32Array;
  controls: ControlFrame[];
  /** Where its formation has its centre [m]. */
  x: number;
  y: number;
  /** [rad]. */
  facing: number;
  /** Its queue follows; false: it is as in the last frame sent. */
  queued: boolean;
  /** Its queue, where it follows. */
  orders: QueuedOrder[];
  /** x, y: the rest of the way of the order that is carried out. */
  way: Float32Array;
  /** It waits; the queue stays. */
  held: boolean;
  /** Orders that are done come last again. */
  patrols: boolean;
  stance: Stance;
  /** 0 to 1. */
  cohesion: number;
  /** Share of its width that it may give up. */
  squeeze: number;
  /** Its mesh gives way to others. */
  avoids: boolean;
}

/** All characters, in some four bytes each: see docs/protocol.md. */
export interface CrowdFrame {
  count: number;
  /** Where x is 0 [m]. */
  x0: number;
  y0: number;
  /** What 1 is in x and y [m]; a power of two. */
  quantum: number;
  /** Of everybody, or empty where steps follow. */
  x: Uint16Array;
  y: Uint16Array;
  /** Since the last frame sent. */
  stepX: Int8Array;
  stepY: Int8Array;
  /** Indices of those who moved too far for a step. */
  jumped: Uint32Array;
  /** Where they are. */
  jumpedX: Uint16Array;
  jumpedY: Uint16Array;
  /** Whole 256ths of a turn. */
  heading: Uint8Array;
  /** 256ths of these; empty in large crowds. */
  headingFine: Uint8Array;
  /** Indices of those who play another clip than in the last frame sent. */
  changed: Uint32Array;
  /** Index into Motions: theirs, or everybody's where x is. */
  clip: Uint8Array;
  /** Whole 256ths of the clip. */
  phase: Uint8Array;
  /** 256ths of these; empty in large crowds. */
  phaseFine: Uint8Array;
  /** Indices of those who come with whole poses. */
  near: Uint32Array;
  /** Per such x, y [m], heading [rad]. */
  nearPlaces: Float32Array;
  /** Per such: hips x, y, z [mm], then three numbers per joint, for a body of size 1. */
  nearPoses: Int16Array;
}

/** Where an obstacle or a patch that moves stands now. */
export interface MovingFrame {
  kind: MovingKind;
  id: number;
  /** Offset from the defined placement. */
  x: number;
  y: number;
  angle: number;
}

/** What an exit or a source has seen. */
export interface AreaFrame {
  id: number;
  /** Who have left by it, or come by it. */
  passed: number;
  /** Of a source: for whom there is no room yet. */
  waiting: number;
}

/** A joint of the characters' skeleton in the rest pose; parents come before their children. */
export interface JointFrame {
  name: string;
  /** Index; its own for the first. */
  parent: number;
  /** Offset from the parent [m]. */
  x: number;
  y: number;
  z: number;
}

/** A motion clip as baked poses, in the character's own frame (x forward, y left, z up, on the ground below it). */
export interface ClipFrames {
  name: string;
  /** What it belongs to: run, crawl... */
  motion: string;
  /** Poses a second. */
  rate: number;
  /** After the last pose comes the first. */
  cyclic: boolean;
  poses: number;
  /** x, y, z per pose [m]. */
  hips: Float32Array;
  /** Per pose and joint x, y, z, w over 32767, relative to the parent. */
  rotations: Int16Array;
}

/** A part of a take that plays faster or slower. */
export interface SpeedPiece {
  /** Time of the take [s]. */
  from: number;
  to: number;
  /** 0.1 to 8. */
  speed: number;
  /** In which it comes and goes [s]. */
  ease: number;
}

/** Where the film camera of a take is at a moment. */
export interface CameraKey {
  step: number;
  /** The point on the ground that it looks at [m]. */
  x: number;
  y: number;
  /** From there [m]. */
  distance: number;
  /** [rad]. */
  turn: number;
  /** [rad]. */
  pitch: number;
  /** It is here at once; otherwise it comes from the one before. */
  cut: boolean;
}

/** Something that happens in a take, for its time line. */
export interface TakeMark {
  kind: TakeMarkKind;
  step: number;
  /** Steps that a finger is down. */
  length: number;
  /** In one or two words. */
  label: string;
}

/** A row of an open take: all that concerns one group. */
export interface TakeTrack {
  /** Id; 0: what concerns the place or nobody in particular. */
  group: number;
  name: string;
  /** Step in which the group comes. */
  from: number;
  /** In which it ends; the take's steps where it stays. */
  to: number;
}

/** One thing that a group does in the open take, with all commands that belong to it. */
export interface TakeBlock {
  /** Valid until the take changes. */
  id: number;
  group: number;
  kind: TakeBlockKind;
  /** Step of its first command. */
  begin: number;
  /** Step from which it is carried out: later for orders in a queue. */
  begun: number;
  end: number;
  /** As people say it: 'Move to Fountain'. */
  label: string;
  /** It can begin at another time, and be copied. */
  moves: boolean;
  /** It can take another time. */
  stretches: boolean;
}

/** Holds a path at another place at one moment of the own clock. */
export interface EditPin {
  /** On the own clock [s]. */
  time: number;
  /** How far from where they were then [m]. */
  x: number;
  y: number;
  /** So long before and after the path moves along [s]. */
  seconds: number;
}

/** A moment of the take at which another one of the recording is shown. */
export interface EditClock {
  /** [s]. */
  time: number;
  /** Time of the recording [s]. */
  own: number;
}

/** A time in which a clip is played. */
export interface EditClip {
  name: string;
  /** [s]. */
  from: number;
  to: number;
}

/** A time in which somebody looks at something. */
export interface EditLook {
  /** At whom; 0: at a point. */
  person: number;
  /** [m]. */
  x: number;
  y: number;
  height: number;
  /** [s]. */
  from: number;
  to: number;
}

/** What is changed afterwards in how some people of a take are shown. */
export interface PeopleEdit {
  /** In ascending order. */
  people: Uint32Array;
  pins: EditPin[];
  clock: EditClock[];
  clips: EditClip[];
  looks: EditLook[];
}

/** Something wrong with the path of an edited person. */
export interface EditFinding {
  person: number;
  kind: EditFindingKind;
  /** The other person, or the obstacle. */
  other: number;
  /** [s]. */
  from: number;
  to: number;
  /** Where it is worst [m]. */
  x: number;
  y: number;
  /** In words, without the person. */
  text: string;
}

/** What a person does with fingers, mouse and keys, before anything judges it. */
export interface RawInput {
  kind: InputKind;
  phase: TouchPhase;
  device: PointerDevice;
  /** The one that went down. */
  button: PointerButton;
  /** Number of the finger; the same from Down to Up. */
  pointer: number;
  /** '0' to '9', 'A' to 'Z', 27 for Escape, 127 for Delete. */
  key: number;
  /** From the upper left corner of the view [px]. */
  x: number;
  y: number;
  /** Page clock [s]; it is mapped to world time. */
  time: number;
  shift: boolean;
  /** Ctrl, or the command key. */
  control: boolean;
  alt: boolean;
}

/** A control scheme that a client may choose. */
export interface SchemeInfo {
  name: string;
  title: string;
  description: string;
  /** It takes hold of the mesh. */
  mesh: boolean;
}

/** One of the answers to choose from. */
export interface ChoiceFrame {
  text: string;
}

/** One question of a form. */
export interface QuestionFrame {
  name: string;
  text: string;
  kind: QuestionKind;
  low: number;
  high: number;
  /** Between the marks of a scale. */
  step: number;
  lowLabel: string;
  highLabel: string;
  choices: ChoiceFrame[];
  needed: boolean;
}

/** The answer to one question. */
export interface AnswerFrame {
  /** Of the question. */
  name: string;
  /** As given. */
  text: string;
  /** Where it is one. */
  number: number;
}

/** A stage of the step and how long it takes. */
export interface StageFrame {
  name: string;
  /** What it does, in one sentence. */
  about: string;
  milliseconds: number;
}

/** Something that happened. */
export interface EventFrame {
  kind: EventKind;
  subject: number;
  value: number;
  x: number;
  y: number;
}

/** How a sentence may go on. */
export interface SaidCompletion {
  /** What comes next, for people. */
  words: string;
  /** The sentence with it. */
  whole: string;
}

/** Numbers of a body for all present members of a group. */
export interface GroupBodyEdit {
  group: number;
  /** None to leave it as it is [m]. */
  radius: number | null;
  /** [m/s]. */
  maxSpeed: number | null;
  unitClass: number | null;
}

/** Extent of the ground. */
export interface SceneBox {
  /** [m]. */
  min: Vec2;
  /** [m]. */
  max: Vec2;
}

/** A motion clip, which patches name by its index. */
export interface SceneClip {
  name: string;
  /** Travel speed relative to running. */
  speed: number;
}

/** An obstacle of the world. */
export interface SceneObstacle extends ObstacleDef {
  id: number;
}

/** A patch of the world. */
export interface ScenePatch extends PatchDef {
  id: number;
}

/** An item of the world. */
export interface SceneItem extends ItemDef {
  id: number;
}

/** A checkpoint of the world. */
export interface SceneCheckpoint extends CheckpointDef {
  id: number;
  /** Id of the group that it applies to; 0 for all groups. */
  group: number;
}

/** An area of the world. */
export interface SceneArea extends AreaDef {
  id: number;
  /** Of a source: id of the group whom its people join. */
  group: number;
}

/** What all in a group have in common; none of a number in which they differ. */
export interface GroupBody {
  /** [m]. */
  radius: number | null;
  /** [m/s]. */
  maxSpeed: number | null;
  /** 0 for none. */
  unitClass: number | null;
}

/** A group of the world. */
export interface SceneGroup {
  id: number;
  /** Index of the accent: blue, ember, green, plum, ochre, slate. */
  accent: number;
  /** Who are in it now. */
  count: number;
  /** What it is in now. */
  formation: string;
  /** The place has it; else it is a part of others. */
  placed: boolean;
  /** How the place has it: what another one like it begins as. */
  definition: GroupDef;
  body: GroupBody;
}

/** A parameter of behaviour. */
export interface SceneParameter {
  name: string;
  value: number;
}

/** The first message of a client. */
export interface Hello {
  type: 'Hello';
  /** Shown to others. */
  name: string;
}

/** Fingers, in the order they were seen. */
export interface Touches {
  type: 'Touches';
  events: TouchEvent[];
}

/** Play, pause, one step, from the start, from the start with the touches that the scenario carries, back to the world before, or to the one from which the take was opened. */
export interface Playback {
  type: 'Playback';
  action: PlaybackAction;
}

/** How much faster than real time. */
export interface SetSpeed {
  type: 'SetSpeed';
  /** 0.1 to 8. */
  factor: number;
}

/** Another world for everybody. */
export interface LoadScenario {
  type: 'LoadScenario';
  name: string;
}

/** Starts or stops the recording clock. */
export interface Record {
  type: 'Record';
  on: boolean;
}

/** What to colour the ground by. */
export interface SetOverlay {
  type: 'SetOverlay';
  kind: OverlayKind;
  /** Id, for Cost. */
  character: number;
}

/** Orders and changes of units, controls, counts and parameters. */
export interface Commands {
  type: 'Commands';
  /** In their order. The time of an AddControl is that of the page's clock. */
  commands: readonly Command[];
}

/** Where this client looks: the characters nearest to it come with whole poses. */
export interface Attend {
  type: 'Attend';
  /** [m]. */
  x: number;
  y: number;
  /** How many at most; 0 for none. */
  count: number;
}

/** Frame drawn; the next may come. */
export interface FrameAck {
  type: 'FrameAck';
  frame: number;
}

/** Asks for a Pong. */
export interface Ping {
  type: 'Ping';
  time: number;
}

/** Goes to a moment of the open take; playing goes on from there. */
export interface Seek {
  type: 'Seek';
  step: number;
}

/** Directs from the present moment of the open take on: a new take with its beginning. */
export interface TakeAgain {
  type: 'TakeAgain';
  /** What was recorded later goes on beneath what is directed now. */
  keep: boolean;
}

/** Another name, part or speed of the open take; kept with its file. */
export interface EditTake {
  type: 'EditTake';
  title: string;
  /** First step of the part that is shown. */
  from: number;
  /** Its last step; the largest number: the end. */
  to: number;
  /** Plays over and over; not kept. */
  loop: boolean;
  speeds: SpeedPiece[];
  /** Of its film, ascending. */
  camera: CameraKey[];
}

/** Would these orders arrive, by which way, when? Nothing changes. */
export interface AskForecasts {
  type: 'AskForecasts';
  /** Comes back with the answer. */
  number: number;
  asks: ForecastAsk[];
}

/** How the sender is called from now on. */
export interface SetName {
  type: 'SetName';
  /** At most 40 characters count; empty: a number. */
  name: string;
}

/** What a director may direct: one group and its parts, or everything. */
export interface GiveGroup {
  type: 'GiveGroup';
  client: number;
  /** 0: everything. */
  group: number;
}

/** Inputs shall be judged by this control scheme; empty: by the page itself. */
export interface SetScheme {
  type: 'SetScheme';
  name: string;
}

/** How the ground is seen from now on. */
export interface SetView {
  type: 'SetView';
  /** Nine numbers by rows: from (x, y, 1) on the ground [m] to homogeneous pixels. */
  matrix: Float64Array;
  /** Of the view [px]. */
  width: number;
  height: number;
  /** Of the display. */
  mmPerPixel: number;
}

/** Raw inputs, in the order they were seen, for the client's control scheme. */
export interface Inputs {
  type: 'Inputs';
  events: RawInput[];
}

/** Begins a run of the study, or goes on with one. */
export interface EnterStudy {
  type: 'EnterStudy';
  /** As StudyState gave it; empty for a new run. */
  token: string;
}

/** The answers to the form that waits. */
export interface AnswerForm {
  type: 'AnswerForm';
  instrument: string;
  answers: AnswerFrame[];
}

/** Where a group or a character goes in the open take. */
export interface AskPath {
  type: 'AskPath';
  /** Id. */
  group: number;
  /** Id; 0: the group as a whole. */
  character: number;
}

/** Moves that path, and simulates everything again as another take, which opens. */
export interface BendPath {
  type: 'BendPath';
  group: number;
  character: number;
  /** Where the path is taken hold of. */
  step: number;
  /** How far it is moved there [m]. */
  dx: number;
  dy: number;
  /** So long before and after it moves along, ever less: 0.5 to 60. */
  seconds: number;
}

/** A change of the place that is being made, which its director can undo. */
export interface Edit {
  type: 'Edit';
  /** What was done, for the undo: 'Move wall'; at most 80 bytes. */
  label: string;
  /** Edits of one director in a row with the same number are undone together; 0: alone. */
  gesture: number;
  /** Each thing at most once. */
  commands: readonly Command[];
  /** Instead of commands: each group at most once. */
  bodies: GroupBodyEdit[];
}

/** Takes back the last thing that the sender did to the place or the crowd, or does it again, by commands at the present step. */
export interface UndoEdit {
  type: 'UndoEdit';
  redo: boolean;
}

/** What a person wants in a run of the study. */
export interface DoInStudy {
  type: 'DoInStudy';
  act: StudyAct;
}

/** Where would everybody stand, and which of these places could they not reach? Nothing changes. */
export interface AskPlaces {
  type: 'AskPlaces';
  /** Comes back with the answer. */
  number: number;
  asks: PlacesAsk[];
}

/** Whether the sender wants to know how long the stages of steps take. */
export interface WatchStages {
  type: 'WatchStages';
  on: boolean;
}

/** Who cannot be in its place, and why? */
export interface AskStandings {
  type: 'AskStandings';
  /** Comes back with the answer. */
  number: number;
}

/** Would the others mind? Who does not answer in time agrees. */
export interface AskOthers {
  type: 'AskOthers';
  /** What the sender would like: 'open Market square'; at most 100 letters count. Empty: never mind. */
  request: string;
}

/** Whether the sender minds. */
export interface AnswerAsk {
  type: 'AnswerAsk';
  /** Of the question. */
  number: number;
  allow: boolean;
}

/** Begins or ends building: the world waits meanwhile, and goes on if it went on before. */
export interface Build {
  type: 'Build';
  on: boolean;
}

/** Keeps the place under that name, which it has from now on. */
export interface KeepPlace {
  type: 'KeepPlace';
  title: string;
}

/** A sentence that directs: what would it do, or do it; how may it go on; or what is there to see? */
export interface Say {
  type: 'Say';
  /** Comes back with the answer. */
  number: number;
  act: SayAct;
  /** At most 1,000 bytes; not read for Look. */
  text: string;
  /** Ids of the groups that it is about where it names none. */
  chosen: Uint32Array;
}

/** Whether the sender wants to know the tracks of the open take. */
export interface WatchTracks {
  type: 'WatchTracks';
  on: boolean;
}

/** Changes a block of the open take and simulates everything again as another take, which opens; or takes such a change back. */
export interface EditTrack {
  type: 'EditTrack';
  /** Of the TakeTracks that the block is from. */
  revision: number;
  edit: TrackEdit;
  /** Its id. */
  block: number;
  /** Where it begins then; for Stretch, where it ends. */
  step: number;
  /** For Copy: whose the copy is; 0: the same group's. */
  group: number;
}

/** How these people of the open take are shown from now on; each of them leaves the edit that it had. Everybody else keeps everything. */
export interface EditPeople {
  type: 'EditPeople';
  /** Without pins, clock, clips and looks: as recorded. */
  edit: PeopleEdit;
  /** Edits in a row with the same number are undone together; 0: alone. */
  gesture: number;
  /** The hand has lifted: it is kept with the take's file. */
  kept: boolean;
  /** Pins are moved out of obstacles. */
  clear: boolean;
}

/** The first answer; again with another number where a take is taken up. */
export interface Welcome {
  type: 'Welcome';
  client: number;
  version: string;
  scenarios: ScenarioInfo[];
  schemes: SchemeInfo[];
}

/** What stands still or is known for good; again whenever it changes. */
export interface Scene {
  type: 'Scene';
  revision: number;
  /** Rises with each world that begins; ids begin again then, in the same order. */
  world: number;
  /** The scenario's file name without .json; in folders FOLDER/NAME. */
  name: string;
  title: string;
  description: string;
  credit: string;
  /** There are touches to watch. */
  demonstration: boolean;
  box: SceneBox;
  /** Edge of a ground cell [m]. */
  cell: number;
  /** Of a character's body [m]. */
  radius: number;
  /** The left and the right side of the box are joined. */
  ring: boolean;
  clips: SceneClip[];
  obstacles: SceneObstacle[];
  patches: ScenePatch[];
  items: SceneItem[];
  checkpoints: SceneCheckpoint[];
  areas: SceneArea[];
  groups: SceneGroup[];
  parameters: SceneParameter[];
}

/** Skeleton and clips that frames refer to by index; before the first frame that does, again whenever they change. */
export interface Motions {
  type: 'Motions';
  joints: JointFrame[];
  clips: ClipFrames[];
}

/** Topology of a group's mesh; before the first frame of that version. */
export interface GroupMesh {
  type: 'GroupMesh';
  group: number;
  version: number;
  formation: string;
  /** Between neighbouring places [m]. */
  spacing: number;
  /** x, y of the vertices before anything deforms them, in the group's axes: it faces x [m]. */
  rest: Float32Array;
  triangles: Uint32Array;
  /** Loops: length, then vertices. */
  boundary: Uint32Array;
  /** Per place, index of the triangle it lies in. */
  placeTriangles: Uint32Array;
  /** Per place, of that triangle's first and second vertex; the third's makes 1. */
  placeWeights: Float32Array;
}

/** The world after a step. */
export interface Frame {
  type: 'Frame';
  frame: number;
  step: number;
  time: number;
  playing: boolean;
  speed: number;
  /** Negative: not recording. */
  recordedSeconds: number;
  replaying: boolean;
  /** Touches that the scenario carries are still to come. */
  demonstrating: boolean;
  /** Newest page clock among touches that this frame shows; 0 for none. */
  touchEcho: number;
  sceneRevision: number;
  /** Of characters; empty where unchanged since the last frame sent. */
  ids: Uint32Array;
  /** Index into groups. */
  group: Uint16Array;
  /** Of characters, where ids are known; empty: all are of none. */
  unitClass: Uint8Array;
  /** Of characters, where ids are known [cm]; empty: all have the usual one. */
  radius: Uint8Array;
  crowd: CrowdFrame;
  groups: GroupFrame[];
  moving: MovingFrame[];
  collected: Uint8Array;
  areas: AreaFrame[];
  stepMs: number;
  lagP95: number;
  /** Per character. */
  swapsPerSecond: number;
  /** Since the last frame sent. */
  events: EventFrame[];
}

/** The values asked for, at most five a second. */
export interface Overlay {
  type: 'Overlay';
  kind: OverlayKind;
  character: number;
  /** Centre of the first cell. */
  x: number;
  y: number;
  cell: number;
  width: number;
  height: number;
  /** Row-major from the lower left; not finite: not reached. */
  values: Float32Array;
  /** From here, for Cost. */
  cost: number;
  /** Length of the path [m]. */
  way: number;
  /** [m]. */
  straight: number;
  /** x, y from the character to its place. */
  path: Float32Array;
  /** For Reach: x, y and width [m] of each gap between obstacles that is too narrow for anybody. */
  gaps: Float32Array;
}

/** Something to tell the person. */
export interface Notice {
  type: 'Notice';
  level: NoticeLevel;
  code: string;
  /** One sentence. */
  text: string;
  /** It concerns a spot on the ground. */
  hasPlace: boolean;
  /** [m]. */
  x: number;
  y: number;
}

/** Gives back the time of a Ping. */
export interface Pong {
  type: 'Pong';
  time: number;
}

/** The path that was asked for, as soon as the take has been read. */
export interface TakePath {
  type: 'TakePath';
  group: number;
  character: number;
  /** Steps from one point to the next. */
  spacing: number;
  /** x, y from the beginning of the take [m]; the last one stands for what follows. */
  points: Float32Array;
}

/** What the client can undo and redo; whenever it changes. */
export interface EditHistory {
  type: 'EditHistory';
  /** Steps that can be taken back. */
  undo: number;
  /** Of the first of them. */
  undoLabel: string;
  redo: number;
  redoLabel: string;
  /** The place differs from what was opened. */
  edited: boolean;
}

/** The answers, as far as group and order are still there. */
export interface Forecasts {
  type: 'Forecasts';
  number: number;
  answers: ForecastFrame[];
}

/** The open take; again whenever it changes, and once with open 0 when it is left. */
export interface TakeState {
  type: 'TakeState';
  open: boolean;
  /** Of its file on the shelf; empty: it lies elsewhere. */
  name: string;
  title: string;
  steps: number;
  /** [s]. */
  stepTime: number;
  from: number;
  /** Not beyond steps. */
  to: number;
  loop: boolean;
  /** This Muster simulates it otherwise: it plays from its stored frames and cannot be changed. */
  stored: boolean;
  speeds: SpeedPiece[];
  camera: CameraKey[];
  marks: TakeMark[];
  /** Title of the world from which it was opened, which LeaveTake brings back; empty: there is none. */
  beneath: string;
}

/** How far the open take has been read: seeks up to there are quick. */
export interface TakeReady {
  type: 'TakeReady';
  steps: number;
}

/** A recording has ended and is kept. */
export interface TakeKept {
  type: 'TakeKept';
  /** Of its file on the shelf; empty: kept in memory only. */
  name: string;
  seconds: number;
  /** Its title. */
  scenario: string;
}

/** Everybody who is connected, in the order in which they came; again whenever that changes. */
export interface Directors {
  type: 'Directors';
  directors: DirectorFrame[];
}

/** What a control scheme shows of what is being done; whenever it changes. */
export interface Marks {
  type: 'Marks';
  /** Empty: the page judges inputs itself. */
  scheme: string;
  /** Ids of characters, ascending. */
  selected: Uint32Array;
  /** x, y: the box that is being drawn [m]. */
  rectangle: Float32Array;
  /** x, y: what a finger draws that moves nothing yet. */
  stroke: Float32Array;
  /** x, y: where the selected are on their way to. */
  goals: Float32Array;
  /** x, y: what is down, in the replay of a trial. */
  pointers: Float32Array;
  /** What the last gesture missed; empty for nothing. */
  notice: string;
}

/** The form that waits. */
export interface StudyForm {
  type: 'StudyForm';
  instrument: string;
  title: string;
  text: string;
  /** Where verbatim items come from. */
  source: string;
  /** The control that it is about; empty for none. */
  schemeTitle: string;
  questions: QuestionFrame[];
}

/** Where a run of the study stands; whenever it changes. */
export interface StudyState {
  type: 'StudyState';
  stage: StudyStage;
  /** By which a page goes on with the run. */
  token: string;
  /** Its number in the database; 0 before consent. */
  run: number;
  /** It tests the page and counts for nothing. */
  test: boolean;
  /** Which one of all waits or goes on, from 1. */
  trial: number;
  trials: number;
  practice: boolean;
  environment: string;
  environmentText: string;
  scheme: string;
  schemeTitle: string;
  schemeText: string;
  /** It is for fingers. */
  touch: boolean;
  /** It takes hold of the mesh. */
  mesh: boolean;
  items: number;
  /** The trial ends then [s]. */
  limit: number;
  /** It may be ended from then on [s]. */
  least: number;
  /** Of the display; 0 where unknown. */
  mmPerPixel: number;
  /** How the trial before this one ended. */
  ended: TrialEnd;
  /** How long it took [s]. */
  seconds: number;
  /** Items collected in it. */
  collected: number;
}

/** The answers, as far as the group is still there. */
export interface Places {
  type: 'Places';
  number: number;
  answers: PlacesFrame[];
}

/** How long the stages of a step take: means of 60 steps, to clients that watch them. */
export interface StageTimes {
  type: 'StageTimes';
  /** The last of the steps. */
  step: number;
  /** Of whole steps [ms]. */
  total: number;
  /** In the order of the step. */
  stages: StageFrame[];
}

/** All who cannot be in their places: neither there, nor on their way, nor held. */
export interface Standings {
  type: 'Standings';
  number: number;
  people: StandingFrame[];
}

/** What directors have done with the world that all of them share; whenever it changes. */
export interface SharedWorld {
  type: 'SharedWorld';
  /** Who paused it; 0: nobody who is here. */
  pausedBy: number;
  /** Who is building: the world waits. */
  builders: Uint32Array;
  /** What was done last. */
  change: WorldChange;
  /** By whom; 0: somebody who has left. */
  changedBy: number;
  /** Their name. */
  changer: string;
  /** Title of the world before, to which anybody can go back; empty: there is none. */
  before: string;
}

/** What another director would like; an empty request: nothing any more. */
export interface Ask {
  type: 'Ask';
  number: number;
  client: number;
  /** As in AskOthers. */
  request: string;
  /** So long an answer is waited for [s]. */
  seconds: number;
}

/** The answer to AskOthers. */
export interface AskAnswered {
  type: 'AskAnswered';
  allowed: boolean;
  /** Who minds; 0: nobody. */
  client: number;
}

/** The scenarios, where they differ from those of Welcome. */
export interface Scenarios {
  type: 'Scenarios';
  scenarios: ScenarioInfo[];
}

/** The answer to KeepPlace. */
export interface PlaceKept {
  type: 'PlaceKept';
  /** What the place is called now; empty: it was not kept. */
  title: string;
  /** As LoadScenario takes it; empty: the server keeps no places. */
  name: string;
  /** Why it was not kept: one sentence. */
  problem: string;
}

/** What a sentence does or would do. */
export interface Said {
  type: 'Said';
  number: number;
  act: SayAct;
  /** What each group does, a line each; for Look what is there. */
  sentences: string;
  /** One sentence: what is not understood, or cannot be; else empty. */
  problem: string;
  /** For Complete and Preview: how it may go on. */
  completions: SaidCompletion[];
  /** For Preview: what would come of the first order of each part. */
  forecasts: ForecastFrame[];
  /** For Preview: where they would stand. */
  places: PlacesFrame[];
}

/** Everything that somebody does in the open take, as soon as it has been read; again whenever it changes. */
export interface TakeTracks {
  type: 'TakeTracks';
  revision: number;
  /** In the order of their ids. */
  tracks: TakeTrack[];
  /** In the order in which they begin. */
  blocks: TakeBlock[];
  /** What the last change was; empty: there is none to take back. */
  undo: string;
  /** What can be done again. */
  redo: string;
}

/** The edits of people in the open take; again whenever they change. */
export interface TakeEdits {
  type: 'TakeEdits';
  edits: PeopleEdit[];
  /** As soon as the take has been read. */
  findings: EditFinding[];
  /** The findings are complete. */
  checked: boolean;
  /** Names of the clips that can be chosen. */
  clips: string[];
}

/** Any message of the page. */
export type ClientMessage =
  | Hello
  | Touches
  | Playback
  | SetSpeed
  | LoadScenario
  | Record
  | SetOverlay
  | Commands
  | Attend
  | FrameAck
  | Ping
  | Seek
  | TakeAgain
  | EditTake
  | AskForecasts
  | SetName
  | GiveGroup
  | SetScheme
  | SetView
  | Inputs
  | EnterStudy
  | AnswerForm
  | AskPath
  | BendPath
  | Edit
  | UndoEdit
  | DoInStudy
  | AskPlaces
  | WatchStages
  | AskStandings
  | AskOthers
  | AnswerAsk
  | Build
  | KeepPlace
  | Say
  | WatchTracks
  | EditTrack
  | EditPeople;

/** Any message of the server. */
export type ServerMessage =
  | Welcome
  | Scene
  | Motions
  | GroupMesh
  | Frame
  | Overlay
  | Notice
  | Pong
  | TakePath
  | EditHistory
  | Forecasts
  | TakeState
  | TakeReady
  | TakeKept
  | Directors
  | Marks
  | StudyForm
  | StudyState
  | Places
  | StageTimes
  | Standings
  | SharedWorld
  | Ask
  | AskAnswered
  | Scenarios
  | PlaceKept
  | Said
  | TakeTracks
  | TakeEdits;
