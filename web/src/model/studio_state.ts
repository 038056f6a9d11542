// What the panels show.

import type { OrderKindWord } from '../protocol/generated/words';
import type { FieldScale } from './field_scale';
import type { Layers, Theme } from './view_settings';
import {
  type Notice,
  OverlayKind,
  type ScenarioInfo,
  type SceneArea,
  type SceneParameter,
  type SchemeInfo,
} from '../protocol/messages';
import type { Layout } from './layout';
import type { Walks } from './objective';
import type { LinkState } from './link_state';
import type { ConductFacts, OrderStyle } from './commands';
import type { ClassCount } from './roles';
import type { StandWords } from './stand';
import type { AskedWish, Consent } from './consent';
import type { DirectorInfo, Invitation } from './directors';
import { kNothingShared, type SharedFacts } from './shared_news';

export type InputKind = 'touch' | 'mouse';

/** What presses on the scene do: steer formations, give orders, or divide and join groups; once: follow, guard, leave by an
 * exit, wait in an area, draw an outline for the formation, or put a new group down. */
export type ToolName = 'steer' | 'order' | 'cut' | 'follow' | 'guard' | 'leave' | 'wait' | 'draw' | 'place';

/** What the dialog of places shows. */
export type PlacesView = 'none' | 'shelf' | 'new' | 'import' | 'save';

export type DialogName = 'none' | 'text' | 'shape' | 'qr' | 'group';

/** What the hint of the first visit tells of. */
export const kHintSteps = ['point', 'line', 'area', 'camera'] as const;
export type HintStep = (typeof kHintSteps)[number];

/** Where a group is that is off screen. */
export interface CrowdArrow {
  readonly index: number;
  readonly id: number;
  /** Middle of the arrow [CSS px]. */
  readonly x: number;
  readonly y: number;
  /** Its direction on the screen, from the right, clockwise [rad]. */
  readonly angle: number;
}

export interface GroupInfo {
  readonly id: number;
  readonly name: string;
  readonly colour: number;
  readonly count: number;
  readonly formation: string;
}

export interface OrderInfo {
  readonly id: number;
  readonly kind: OrderKindWord;
}

/** An order in the list of the active group's queue. */
export interface QueueItem extends OrderInfo {
  readonly word: string;
  /** False where it cannot be reached. */
  readonly arrives: boolean;
  /** Until it is done, as 0:42; empty where that is not known. */
  readonly span: string;
}

/** A group's queue, conduct and classes; parallel to `groups`. */
export interface UnitInfo {
  readonly id: number;
  readonly orders: readonly OrderInfo[];
  readonly held: boolean;
  readonly patrols: boolean;
  readonly conduct: ConductFacts;
  readonly classes: readonly ClassCount[];
}

export interface CostFigures {
  readonly cost: number;
  readonly way: number;
  readonly straight: number;
}

/** What this director can take back and do again: how many steps, and what the next is called. */
export interface HistoryFacts {
  readonly undo: number;
  readonly undoLabel: string;
  readonly redo: number;
  readonly redoLabel: string;
}

export interface StudioState {
  readonly layout: Layout;
  readonly theme: Theme;
  readonly input: InputKind;
  readonly link: LinkState;
  /** Whether a scene was ever seen. */
  readonly loaded: boolean;
  /** Of a body, as the world has it [m]. */
  readonly bodyRadius: number;
  readonly scenarios: readonly ScenarioInfo[];
  readonly scenario: string;
  readonly title: string;
  readonly credit: string;
  readonly groups: readonly GroupInfo[];
  /** Index into groups. */
  readonly active: number;
  /** Ids of the groups that get orders; the active one is among them. */
  readonly selected: readonly number[];
  readonly units: readonly UnitInfo[];
  readonly tool: ToolName;
  readonly style: OrderStyle;
  /** Of the active group. */
  readonly queue: readonly QueueItem[];
  /** The order that is chosen in that list; 0 for none. */
  readonly picked: number;
  /** The order before which the next one comes; 0 for none. */
  readonly insertBefore: number;
  /** What is said of the formation that is shown before it is taken up; null where none is. */
  readonly stand: StandWords | null;
  /** The formations along the active group's way are being edited. */
  readonly sequencing: boolean;
  /** A formation that waits on the ground to be taken up; the dialog is the one that it comes from. */
  readonly trying: { readonly title: string; readonly dialog: DialogName } | null;
  /** The name of a new group that the next press puts on the ground; empty for none. */
  readonly placing: string;
  readonly history: HistoryFacts;
  /** The engine in this browser, for when the server is lost: not there, ready, or asked to go on. */
  readonly standby: 'none' | 'ready' | 'wanted';
  readonly layers: Layers;
  readonly overlay: OverlayKind;
  /** Character whose cost is shown; -1 for none. */
  readonly chosen: number;
  readonly cost: CostFigures | null;
  readonly ramp: FieldScale | null;
  readonly playing: boolean;
  readonly replaying: boolean;
  /** The scenario carries touches to watch. */
  readonly demonstration: boolean;
  /** The scenario's touches are being played. */
  readonly demonstrating: boolean;
  /** The scenario that was last steered, not replayed. */
  readonly lastSteered: string;
  readonly speed: number;
  /** Negative: not recording. */
  readonly recorded: number;
  readonly characters: number;
  /** Things to collect, and how many are gone. */
  readonly items: number;
  readonly collected: number;
  /** How people stand, by groups; parallel to `groups`. */
  readonly standings: readonly (readonly number[])[];
  readonly stepMs: number;
  /** Seconds of the world per second; NaN where that is not known. */
  readonly pace: number;
  readonly lag: number;
  readonly swaps: number;
  readonly walks: Walks;
  /** Of the world. */
  readonly parameters: readonly SceneParameter[];
  /** Exits, sources and waiting areas of the world. */
  readonly areas: readonly SceneArea[];
  /** Number of frames taken, for the sparklines. */
  readonly frames: number;
  /** File of the visitor's own character; empty where Muster's characters are shown. */
  readonly ownCharacter: string;
  /** The camera goes along with the crowd. */
  readonly following: boolean;
  readonly topView: boolean;
  /** Without perspective. */
  readonly flatView: boolean;
  /** Nothing but the scene is shown: no marks, no panels. */
  readonly clean: boolean;
  readonly arrows: readonly CrowdArrow[];
  /** Everybody who is connected. */
  readonly directors: readonly DirectorInfo[];
  readonly invitation: Invitation;
  /** What directors have done with the world that all share. */
  readonly shared: SharedFacts;
  /** What another director would like; null for nothing. */
  readonly asked: AskedWish | null;
  /** What this director would like, where others are to be asked; null for nothing. */
  readonly consent: Consent | null;
  readonly notice: Notice | null;
  readonly hint: boolean;
  /** What the hint tells of and the visitor has done, in its order. */
  readonly tried: readonly HintStep[];
  /** The readout shows its figures, not only words. */
  readonly figures: boolean;
  readonly dialog: DialogName;
  /** Somebody builds the place. */
  readonly build: boolean;
  /** Somebody directs by words. */
  readonly words: boolean;
  /** What people do is measured, and shown. */
  readonly measures: boolean;
  /** Somebody changes paths of the open take. */
  readonly paths: boolean;
  /** The tracks of the open take are unfolded. */
  readonly tracks: boolean;
  readonly places: PlacesView;
  /** Files that wait to be opened or imported there. */
  readonly placeFiles: readonly File[];
  /** The shelf of takes is open. */
  readonly shelf: boolean;
  readonly help: boolean;
  /** Control schemes of the server. */
  readonly schemes: readonly SchemeInfo[];
  /** The one that judges this page's inputs; empty: the page itself. */
  readonly scheme: string;
  readonly schemesOpen: boolean;
}

export const kInitialState: StudioState = {
  layout: 'desktop',
  theme: 'light',
  input: 'mouse',
  link: { phase: 'connecting' },
  loaded: false,
  bodyRadius: 0.25,
  scenarios: [],
  scenario: '',
  title: '',
  credit: '',
  groups: [],
  active: 0,
  selected: [],
  units: [],
  tool: 'steer',
  style: { manner: 'march', turn: 'flow', mode: 'replace' },
  queue: [],
  picked: 0,
  insertBefore: 0,
  stand: null,
  trying: null,
  placing: '',
  sequencing: false,
  history: { undo: 0, undoLabel: '', redo: 0, redoLabel: '' },
  standby: 'none',
  layers: { mesh: true, places: true, paths: true },
  overlay: OverlayKind.None,
  chosen: -1,
  cost: null,
  ramp: null,
  playing: false,
  replaying: false,
  demonstration: false,
  demonstrating: false,
  lastSteered: '',
  speed: 1,
  recorded: -1,
  characters: 0,
  items: 0,
  collected: 0,
  standings: [],
  stepMs: 0,
  pace: NaN,
  lag: 0,
  swaps: 0,
  walks: { sum: 0, squares: 0, longest: 0 },
  parameters: [],
  areas: [],
  frames: 0,
  ownCharacter: '',
  following: false,
  topView: false,
  flatView: false,
  clean: false,
  arrows: [],
  directors: [],
  invitation: { links: [], code: [], site: '' },
  shared: kNothingShared,
  asked: null,
  consent: null,
  notice: null,
  hint: false,
  tried: [],
  figures: false,
  dialog: 'none',
  build: false,
  words: false,
  measures: false,
  paths: false,
  tracks: false,
  places: 'none',
  placeFiles: [],
  shelf: false,
  help: false,
  schemes: [],
  scheme: '',
  schemesOpen: false,
};

/** True where the connection is lost after a scene was seen: actions that need the server have no effect. */
export function isLost({ link, loaded }: Pick<StudioState, 'link' | 'loaded'>): boolean {
  return loaded && link.phase !== 'open';
}
