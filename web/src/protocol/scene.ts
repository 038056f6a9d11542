// The static facts of a world: the JSON inside the Scene message (docs/protocol.md). Lengths in metres, angles in
// radians; points are [x, y] with y to the north.

export type Point2 = readonly [number, number];

export interface SceneBox {
  readonly min: Point2;
  readonly max: Point2;
}

/** A way along which something moves, as offsets from where it is defined. */
export interface ScenePath {
  readonly waypoints: readonly { readonly t: number; readonly x: number; readonly y: number; readonly angle: number }[];
  readonly loop: boolean;
}

/** As in scenario files. */
export interface SceneShape {
  readonly kind: string;
  readonly spacing?: number;
}

/** A polygon, or a disc where it has a radius. */
export interface SceneObstacle {
  readonly id: number;
  readonly name: string;
  /** Corners counter-clockwise; absent for a disc. */
  readonly polygon?: readonly Point2[];
  readonly centre?: Point2;
  readonly radius?: number;
  readonly height: number;
  readonly moving: boolean;
  readonly path?: ScenePath;
  readonly range?: number;
  readonly strength?: number;
}

export interface ScenePatch {
  readonly id: number;
  readonly name: string;
  readonly polygon: readonly Point2[];
  /** Index into `clips`. */
  readonly motion: number;
  /** Travel speed relative to running. */
  readonly speed: number;
  readonly moving: boolean;
  readonly path?: ScenePath;
  /** Where it has another travel speed than its clip. */
  readonly ownSpeed?: number;
  /** Of stairs and ramps: heading of the way up [rad], and the travel speed on the way down. */
  readonly ascent?: number;
  readonly speedDown?: number;
}

export type AreaKind = 'exit' | 'source' | 'waiting';

/** Where people leave, come, or wait. */
export interface SceneArea {
  readonly id: number;
  readonly name?: string;
  readonly kind: AreaKind;
  readonly polygon: readonly Point2[];
  /** False: nobody leaves or comes here for now. */
  readonly open: boolean;
  /** Of an exit: the most who leave, 0 for as many as come; of a source: how many come on average [1/s]. */
  readonly rate: number;
  /** Of an exit: the line in which people queue, from who is next. */
  readonly queue?: readonly Point2[];
  /** Of a source: id of the group whom its people join. */
  readonly group?: number;
  /** Of a source with a rate [s]. */
  readonly from?: number;
  readonly until?: number;
  readonly most?: number;
  readonly timetable?: readonly { readonly t: number; readonly count: number }[];
}

export interface SceneClip {
  readonly name: string;
  readonly speed: number;
  readonly cyclic: boolean;
}

/** What all in a group have in common; what they differ in is absent. */
export interface SceneGroupBody {
  readonly radius?: number;
  /** In the open [m/s]. */
  readonly maxSpeed?: number;
  /** 0 for none. */
  readonly class?: number;
}

/** Where a class stands in a formation, as in scenario files. */
export interface SceneRole {
  readonly area: string;
  readonly class: number;
}

export type BodyBuild = 'broad' | 'narrow';
export type MotionSet = 'march' | 'weary';

export interface SceneGroup {
  readonly id: number;
  readonly name: string;
  readonly count: number;
  readonly formation: string;
  /** Index of the accent: blue, ember, green, plum, ochre, slate. */
  readonly colour: number;
  /** `#rrggbb`, where somebody has chosen it. */
  readonly chosenColour?: string;
  /** Of the drawn bodies; absent for both. */
  readonly build?: BodyBuild;
  /** How they walk; absent for the plain manner. */
  readonly motions?: MotionSet;
  /** How the place has it; absent for parts of others. */
  readonly start?: {
    readonly count?: number;
    readonly position: Point2;
    readonly angle: number;
    readonly formation: SceneShape;
    readonly body?: SceneGroupBody;
    readonly roles?: readonly SceneRole[];
    /** Sorts of persons, as in scenario files. */
    readonly people?: unknown;
  };
}

export interface SceneItem {
  readonly id: number;
  readonly position: Point2;
  readonly radius: number;
}

export interface SceneCheckpoint {
  readonly id: number;
  readonly position: Point2;
  readonly radius: number;
  readonly formation: string;
  readonly shape: SceneShape;
  /** Id of the group it concerns; 0 for any. */
  readonly group: number;
  readonly once: boolean;
  readonly trigger: string;
  readonly share: number;
}

export interface SceneParameter {
  readonly name: string;
  readonly value: number;
}

export interface SceneFacts {
  /** Rises with each world that begins; ids begin anew then, in the same order. */
  readonly world: number;
  /** File name without .json; in folders FOLDER/NAME. */
  readonly name: string;
  readonly title: string;
  readonly description: string;
  readonly credit: string;
  /** There are touches to watch. */
  readonly demonstration: boolean;
  readonly box: SceneBox;
  /** Edge of a ground cell. */
  readonly cell: number;
  /** Of a character's body. */
  readonly radius: number;
  readonly obstacles: readonly SceneObstacle[];
  readonly patches: readonly ScenePatch[];
  readonly clips: readonly SceneClip[];
  readonly groups: readonly SceneGroup[];
  readonly items: readonly SceneItem[];
  readonly checkpoints: readonly SceneCheckpoint[];
  readonly areas: readonly SceneArea[];
  /** The left and the right side of the box are joined. */
  readonly ring: boolean;
  readonly parameters: readonly SceneParameter[];
}

/** True where both are the same place, whatever stands in it: the view need not open anew. */
export function isSameWorld(a: SceneFacts, b: SceneFacts): boolean {
  const corners = ({ box }: SceneFacts): string => [...box.min, ...box.max].join();
  return a.name === b.name && corners(a) === corners(b);
}

/** What a scene has where its JSON says nothing; the title is its name then. */
const kAbsent: Omit<SceneFacts, 'box' | 'title'> = {
  world: 0,
  name: '',
  description: '',
  credit: '',
  demonstration: false,
  cell: 0.25,
  radius: 0.25,
  obstacles: [],
  patches: [],
  clips: [],
  groups: [],
  items: [],
  checkpoints: [],
  areas: [],
  ring: false,
  parameters: [],
};

/** The text that was read last, because several read each scene. */
let last: { readonly json: string; readonly facts: SceneFacts } | null = null;

/** Reads the JSON of a Scene message; absent lists are empty. Throws where it is no JSON object with a box. */
export function parseScene(json: string): SceneFacts {
  if (last?.json === json) return last.facts;
  const raw: unknown = JSON.parse(json);
  if (typeof raw !== 'object' || raw === null || !('box' in raw)) throw new Error('The scene has no box.');
  const found = { ...kAbsent, ...(raw as Partial<SceneFacts> & { box: SceneBox }) };
  const facts = { ...found, title: found.title ?? found.name };
  last = { json, facts };
  return facts;
}
