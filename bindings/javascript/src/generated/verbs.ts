// Made by schema/generate.mjs from schema/api: change these, not this file.

import { Caller, Handle } from '../binding/handle.js';
import type { ProgressFunction, ReplayFunction } from '../binding/callbacks.js';
import type { Rows } from '../binding/rows.js';
import type { Status, FormationKind, EventKind, MotionIndex, ObstacleId, PatchId, GroupId, CharacterId, CommandKind, JointRole, Limb, ReplayFrom } from './enums.js';
import type { Vec2, MapDef, MapDefInit, TimedPathInit, ObstacleDef, ClipFacts, PatchDef, AreaDef, ItemDef, Body, Distribution, DistributionInit, PeopleDef, FormationDef, Order, OrderInit, QueuedOrder, Conduct, GroupDef, CheckpointDef, WorldDef, WorldDefInit, PathState, Forecast, ParameterInfo, Command, CommandInit, Characters, Group, Control, Obstacle, Patch, Area, Event, Rejection, Contacts, StageTime, Transform, Joint, BodyPose, LimbContact, Travel, Clip, ClipInit, ClipMeasures, MotionState, BvhContents, TakeContents, ReplayReport, ExportFormat, ExportDef, ExportDefInit } from './structs.js';

/** A map that was read, and the ground that it makes. */
export class GridMap extends Handle {
  /** Ends a map. Fails with NotFound where there is none. */
  destroy(): void {
    this.call_('muster_map_destroy');
  }

  /** The cells of a map, with scale and position of defaultMapDef(). Valid until the map is destroyed. */
  def(): MapDef {
    return this.call_('muster_map_def') as MapDef;
  }

  /**
   * Blocked cells (`@ O T W`) as few rectangular obstacles, which do not overlap and cover exactly these cells.
   * `placement` gives scale and position; its cells are not read. Valid until the next call for this map.
   */
  obstacles(placement: MapDefInit = {}): readonly ObstacleDef[] {
    return this.call_('muster_map_obstacles', placement) as readonly ObstacleDef[];
  }

  /** Swamp cells as few rectangular patches on which `motion` is played, as GridMap.obstacles(). */
  patches(placement: MapDefInit, motion: MotionIndex): readonly PatchDef[] {
    return this.call_('muster_map_patches', placement, motion) as readonly PatchDef[];
  }
}

/** Makes GridMap objects. */
export class GridMapMaker extends Caller {
  /** Reads the text of a `.map` file (type octile). Fails with ParseError, naming the line. */
  parse(text: string | Uint8Array): GridMap {
    return this.call_('muster_map_parse', text) as GridMap;
  }
}

/** A world. All functions fail with NotFound where it was destroyed or never was. */
export class World extends Handle {
  /** Ends a world. All its arrays become invalid. */
  destroy(): void {
    this.call_('muster_world_destroy');
  }

  /** True where the world is there. */
  isValid(): boolean {
    return this.call_('muster_world_is_valid') as boolean;
  }

  /**
   * Goes back to a snapshot of this world, or on to it, keeping what was computed and is still true. Fails as
   * World.restore(), changing nothing.
   */
  rewind(snapshot: Uint8Array): void {
    this.call_('muster_world_rewind', snapshot);
  }

  /**
   * Queues a command. Fails where it is malformed or its step has passed; whether it can be applied is only known
   * in its step: see World.rejections().
   */
  submit(command: CommandInit): void {
    this.call_('muster_world_submit', command);
  }

  /**
   * Advances by that many time steps. The engine reads no clock in any decision: the same commands give the same
   * bits, whatever the time of day and the speed of the machine.
   */
  step(count = 1): void {
    for (let k = 0; k < count; k += 1) this.call_('muster_world_step');
  }

  /** Hash of all state. */
  hash(): bigint {
    return this.call_('muster_world_hash') as bigint;
  }

  /** All state as bytes. */
  snapshot(): Uint8Array<ArrayBuffer> {
    return this.call_('muster_world_snapshot') as Uint8Array<ArrayBuffer>;
  }

  /** Number of steps done. */
  stepCount(): number {
    return this.call_('muster_world_step_count') as number;
  }

  /** Number of steps done times the time step [s]. */
  time(): number {
    return this.call_('muster_world_time') as number;
  }

  /** Step of the last applied command; 0 for none. */
  lastCommandStep(): number {
    return this.call_('muster_world_last_command_step') as number;
  }

  /** Current value of a parameter. Fails with NotFound, naming it. */
  parameter(name: string): number {
    return this.call_('muster_world_parameter', name) as number;
  }

  /** Characters of all groups. */
  characters(): Characters {
    return this.call_('muster_world_characters') as Characters;
  }

  /**
   * The way of a character, an index into World.characters(), to its place: corners round what stands still, both
   * ends included [m]. None for the unmatched and where there is no way. Valid also until the next call. Fails
   * with InvalidArgument for other indices.
   */
  wayAhead(character: number): Float64Array {
    return this.call_('muster_world_way_ahead', character) as Float64Array;
  }

  /**
   * The Standing of each character: whether it stands in its place, and if not, what keeps it from there. Valid
   * also until the next call.
   */
  standings(): Uint8Array {
    return this.call_('muster_world_standings') as Uint8Array;
  }

  /** Current number of groups. */
  groupCount(): number {
    return this.call_('muster_world_group_count') as number;
  }

  /** A group by its index; groups are in ascending order of ids. Fails with InvalidArgument for other indices. */
  group(index: number): Group {
    return this.call_('muster_world_group', index) as Group;
  }

  /** The index of the group of that id. Fails with NotFound. */
  groupIndex(group: GroupId): number {
    return this.call_('muster_world_group_index', group) as number;
  }

  /** Current name, count and formation of a group. Valid also until the next call. */
  groupDef(index: number): GroupDef {
    return this.call_('muster_world_group_def', index) as GroupDef;
  }

  /** Controls of a group in the order of creation. Valid also until the next call. */
  groupControls(index: number): readonly Control[] {
    return this.call_('muster_world_group_controls', index) as readonly Control[];
  }

  /** The queue of a group; the first order is carried out. Valid also until the next call. */
  groupOrders(index: number): readonly QueuedOrder[] {
    return this.call_('muster_world_group_orders', index) as readonly QueuedOrder[];
  }

  /**
   * What would come of an order that a group were given now, and nothing else changed. Nothing changes. Valid also
   * until the next call. Fails with NotFound where there is no such group, with InvalidArgument for an order that
   * is malformed.
   */
  forecast(group: GroupId, order: OrderInit): Forecast {
    return this.call_('muster_world_forecast', group, order) as Forecast;
  }

  /** Ids of all obstacles, ascending. */
  obstacleIds(): Uint32Array {
    return this.call_('muster_world_obstacle_ids') as Uint32Array;
  }

  /** The obstacle of that id. Valid also until the next call. Fails with NotFound. */
  obstacle(id: ObstacleId): Obstacle {
    return this.call_('muster_world_obstacle', id) as Obstacle;
  }

  /** Ids of all patches, ascending. */
  patchIds(): Uint32Array {
    return this.call_('muster_world_patch_ids') as Uint32Array;
  }

  /** The patch of that id. Valid also until the next call. Fails with NotFound. */
  patch(id: PatchId): Patch {
    return this.call_('muster_world_patch', id) as Patch;
  }

  /**
   * All items, with their ids, ascending, and 1 for each that is collected, else 0. Null for a pointer that is not
   * needed is fine, but for the number.
   */
  items(): { readonly items: readonly ItemDef[]; readonly ids: Uint32Array; readonly collected: Uint8Array } {
    return this.call_('muster_world_items') as { readonly items: readonly ItemDef[]; readonly ids: Uint32Array; readonly collected: Uint8Array };
  }

  /**
   * All formation checkpoints, with their ids, ascending, and the group that each concerns, 0 for any. Null for a
   * pointer that is not needed is fine, but for the number. Valid also until the next call.
   */
  checkpoints(): { readonly checkpoints: readonly CheckpointDef[]; readonly ids: Uint32Array; readonly groups: Uint32Array } {
    return this.call_('muster_world_checkpoints') as { readonly checkpoints: readonly CheckpointDef[]; readonly ids: Uint32Array; readonly groups: Uint32Array };
  }

  /** All exits, sources and waiting areas, in ascending order of ids. Valid also until the next call. */
  areas(): readonly Area[] {
    return this.call_('muster_world_areas') as readonly Area[];
  }

  /** True where the left and the right side of the world's box are joined. */
  ring(): boolean {
    return this.call_('muster_world_ring') as boolean;
  }

  /** Events of the last step. */
  events(): readonly Event[] {
    return this.call_('muster_world_events') as readonly Event[];
  }

  /** Commands that failed in the last step. Valid also until the next call. */
  rejections(): readonly Rejection[] {
    return this.call_('muster_world_rejections') as readonly Rejection[];
  }

  /** Overlaps after the last step. */
  contacts(): Contacts {
    return this.call_('muster_world_contacts') as Contacts;
  }

  /** Wall times of the stages of the last step, and of the whole step [ms]. Valid also until the next call. */
  stageTimes(): { readonly stages: readonly StageTime[]; readonly total: number } {
    return this.call_('muster_world_stage_times') as { readonly stages: readonly StageTime[]; readonly total: number };
  }
}

/** Makes World objects. */
export class WorldMaker extends Caller {
  /**
   * Builds a world that uses this number of threads (0 for all cores). Fails with InvalidArgument, naming the
   * faulty value.
   */
  create(def: WorldDefInit = {}, threads: number = 1): World {
    return this.call_('muster_world_create', def, threads) as World;
  }

  /**
   * Restores a world from a snapshot; it continues bit for bit. Fails with ParseError on other bytes, and with
   * Unsupported on a snapshot of another version.
   */
  restore(snapshot: Uint8Array, threads: number = 1): World {
    return this.call_('muster_world_restore', snapshot, threads) as World;
  }
}

/** A scenario in the library's memory. */
export class Scenario extends Handle {
  /** Ends a scenario. Fails with NotFound where there is none. */
  destroy(): void {
    this.call_('muster_scenario_destroy');
  }

  /** Its whole definition. Valid until the scenario is destroyed. */
  def(): WorldDef {
    return this.call_('muster_scenario_def') as WorldDef;
  }

  /** Builds a world of it, as World.create() with Scenario.def(). */
  createWorld(threads: number = 1): World {
    return this.call_('muster_scenario_create_world', threads) as World;
  }

  /** The whole definition as text with its map embedded: parsing it gives the same definition, bit for bit. */
  text(): string {
    return this.call_('muster_scenario_text') as string;
  }

  /** Writes the text to a file. Fails with IoError. */
  save(path: string): void {
    this.call_('muster_scenario_save', path);
  }

  /**
   * Lists what is valid but likely a mistake: one sentence each, at most `most`. Valid until the next call for
   * this scenario.
   */
  warnings(most: number = 100): readonly string[] {
    return this.call_('muster_scenario_warnings', most) as readonly string[];
  }
}

/** Makes Scenario objects. */
export class ScenarioMaker extends Caller {
  /** Reads a scenario file. Every failure is one sentence `FILE: JSON-PATH: found X, expected Y`. */
  load(path: string): Scenario {
    return this.call_('muster_scenario_load', path) as Scenario;
  }

  /**
   * The same from text. `sourceName` stands for the file in messages; `baseFolder` is where relative map files are
   * looked for (null or empty: files are refused, only embedded maps are allowed).
   */
  parse(text: string | Uint8Array, sourceName: string = 'scenario', baseFolder: string = ''): Scenario {
    return this.call_('muster_scenario_parse', text, sourceName, baseFolder) as Scenario;
  }

  /** A scenario of a definition. */
  fromDef(def: WorldDefInit = {}): Scenario {
    return this.call_('muster_scenario_from_def', def) as Scenario;
  }
}

/** A set of clips. */
export class ClipLibrary extends Handle {
  /** Ends the handle of a library; motions that play its clips keep them. */
  destroy(): void {
    this.call_('muster_clips_destroy');
  }

  /** All clips of a library. Valid until it is destroyed. */
  get(): readonly Clip[] {
    return this.call_('muster_clips_get') as readonly Clip[];
  }

  /** The index of the clip of that name. Fails with NotFound. */
  find(name: string): number {
    return this.call_('muster_clips_find', name) as number;
  }

  /** Measures of the clip of an index. Fails with InvalidArgument for other indices, as all that follow. */
  clipMeasures(clip: number): ClipMeasures {
    return this.call_('muster_clip_measures', clip) as ClipMeasures;
  }

  /** The pose at a time [s], which wraps in cyclic clips and is clamped to the clip in others. */
  clipSample(clip: number, time: number): BodyPose {
    return this.call_('muster_clip_sample', clip, time) as BodyPose;
  }

  /** The travel at a time [s]; cyclic clips go on travelling for times of any sign. */
  clipTravelAt(clip: number, time: number): Travel {
    return this.call_('muster_clip_travel_at', clip, time) as Travel;
  }

  /** The contact of a limb at a time [s]; null where none. Valid until the library is destroyed. */
  clipContactAt(clip: number, limb: Limb, time: number): LimbContact | null {
    return this.call_('muster_clip_contact_at', clip, limb, time) as LimbContact | null;
  }

  /** The clip as the text of a BVH file, in centimetres, Y up, facing +Z. */
  clipBvh(clip: number): string {
    return this.call_('muster_clip_bvh', clip) as string;
  }
}

/** Makes ClipLibrary objects. */
export class ClipLibraryMaker extends Caller {
  /** All of Muster's own clips, made once at the first call (a tenth of a second). */
  own(): ClipLibrary {
    return this.call_('muster_clips_own') as ClipLibrary;
  }

  /**
   * A library of given clips. Fails with InvalidArgument, naming the clip and the faulty value, also where two
   * have one name.
   */
  create(clips: readonly ClipInit[]): ClipLibrary {
    return this.call_('muster_clips_create', clips) as ClipLibrary;
  }
}

/** The motion of all characters of a world. */
export class Motion extends Handle {
  /** Ends a motion. Fails with NotFound where there is none. */
  destroy(): void {
    this.call_('muster_motion_destroy');
  }

  /** Forgets all characters; the next update starts their motion again. */
  restart(): void {
    this.call_('muster_motion_restart');
  }

  /**
   * Call after every step of the world. The motion of new characters, and of those that were moved by a command,
   * starts again.
   */
  update(world: World): void {
    this.call_('muster_motion_update', world);
  }

  /** Ids of the characters that get whole poses from the next update on, in any order; unknown ids are ignored. */
  setNear(ids: ArrayLike<number>): void {
    this.call_('muster_motion_set_near', ids);
  }

  /** The clip and time of each character, in the world's order. Valid until the next update. */
  states(): Rows<MotionState> {
    return this.call_('muster_motion_states') as Rows<MotionState>;
  }

  /** Indices of characters with whole poses, ascending. Valid until the next update. */
  near(): Uint32Array {
    return this.call_('muster_motion_near') as Uint32Array;
  }

  /**
   * The pose of the k-th of Motion.near(), with locked feet, for a body of size 1. In the world it is scaled by
   * `size`, rotated by `yaw` and moved to `position`. Fails with InvalidArgument for other k.
   */
  pose(k: number): BodyPose {
    return this.call_('muster_motion_pose', k) as BodyPose;
  }

  /** The id of the k-th of Motion.near(). */
  nearId(k: number): CharacterId {
    return this.call_('muster_motion_near_id', k) as CharacterId;
  }

  /** True while that limb of the k-th of Motion.near() is locked in a contact. */
  locked(k: number, limb: Limb): boolean {
    return this.call_('muster_motion_locked', k, limb) as boolean;
  }

  /** The joints of the k-th of Motion.near() in the world [m]: writes JointRole.Count transforms. */
  joints(k: number): Float32Array {
    return this.call_('muster_motion_joints', k) as Float32Array;
  }

  /** All that later motion depends on, to go back to together with a snapshot of the world. */
  moment(): MotionMoment {
    return this.call_('muster_motion_moment') as MotionMoment;
  }

  /** Goes back, or on, to a moment of a motion by the same library. Fails with InvalidArgument for another. */
  goBack(moment: MotionMoment): void {
    this.call_('muster_motion_go_back', moment);
  }
}

/** Makes Motion objects. */
export class MotionMaker extends Caller {
  /**
   * Motion by the clips of a library; by an empty one all characters are shown in the rest pose. `allNear`: all
   * characters get whole poses until Motion.setNear() is called, else none does.
   */
  create(library: ClipLibrary, allNear: boolean = false): Motion {
    return this.call_('muster_motion_create', library, allNear) as Motion;
  }
}

/** The motion of a crowd at one moment. */
export class MotionMoment extends Handle {
  /** The memory of a moment [bytes]. */
  size(): number {
    return this.call_('muster_motion_moment_size') as number;
  }

  /** Ends a moment. Fails with NotFound where there is none. */
  destroy(): void {
    this.call_('muster_motion_moment_destroy');
  }
}

/** A BVH file in the library's memory. */
export class Bvh extends Handle {
  /** What the file holds. Valid until it is destroyed. */
  get(): BvhContents {
    return this.call_('muster_bvh_get') as BvhContents;
  }

  /** Ends a file. Fails with NotFound where there is none. */
  destroy(): void {
    this.call_('muster_bvh_destroy');
  }
}

/** Makes Bvh objects. */
export class BvhMaker extends Caller {
  /**
   * Reads BVH text. `unit` is the length of one unit of the file [m], 1e-6 to 1e3; 0 to guess it from the body
   * height. Fails, as `sourceName:LINE: found X, expected Y`, on anything that is not a complete BVH file.
   */
  parse(text: string | Uint8Array, sourceName: string = 'bvh', unit: number = 0): Bvh {
    return this.call_('muster_bvh_parse', text, sourceName, unit) as Bvh;
  }

  /** The same from a file. */
  read(path: string, unit: number = 0): Bvh {
    return this.call_('muster_bvh_read', path, unit) as Bvh;
  }
}

/** A take that is being recorded. */
export class TakeWriter extends Handle {
  /** Appends a command. Call in the order of submission, before the step that applies it. */
  command(command: CommandInit): void {
    this.call_('muster_take_writer_command', command);
  }

  /** Call after every step: appends the events of orders, and frames and a mark whenever they are due. */
  observe(world: World): void {
    this.call_('muster_take_writer_observe', world);
  }

  /** Appends the end record and closes the file, synchronised with the disk. The writer ends, also where it fails. */
  finish(world: World): void {
    this.call_('muster_take_writer_finish', world);
  }

  /** Ends a writer without an end record: the take is unfinished. */
  destroy(): void {
    this.call_('muster_take_writer_destroy');
  }
}

/** Makes TakeWriter objects. */
export class TakeWriterMaker extends Caller {
  /** Makes the file. Fails with IoError, also where it exists and `overwrite` is false. */
  create(path: string, def: WorldDefInit = {}, overwrite: boolean = false): TakeWriter {
    return this.call_('muster_take_writer_create', path, def, overwrite) as TakeWriter;
  }
}

/** A take in the library's memory. */
export class Take extends Handle {
  /** Ends a take. Fails with NotFound where there is none. */
  destroy(): void {
    this.call_('muster_take_destroy');
  }

  /** What the take holds. Valid until it is destroyed. */
  get(): TakeContents {
    return this.call_('muster_take_get') as TakeContents;
  }

  /** Seconds of the take per second that it is shown, at that time of the take [s]. */
  speedAt(seconds: number): number {
    return this.call_('muster_take_speed_at', seconds) as number;
  }

  /** Whether this Muster simulates the take as it was recorded, up to its first mark. */
  simulatesAlike(threads: number = 1): boolean {
    return this.call_('muster_take_simulates_alike', threads) as boolean;
  }

  /**
   * Simulates the take again and compares every mark and event. Fails with Corrupt naming the step of the first
   * mark that differs. With ReplayFrom.Frames nothing is compared, and it fails with Unsupported where the take
   * has no stored frames. `observe` may be null.
   */
  replay(threads: number = 1, from: ReplayFrom = 0, observe: ReplayFunction | null = null): ReplayReport {
    return this.call_('muster_take_replay', threads, from, observe) as ReplayReport;
  }

  /**
   * Replays a take, its characters moved by the clips of `library`, and writes `path` in the format of that name.
   * `def` may be null for the defaults, `progress` null for none. Where `progress` gives false the export fails
   * with Unsupported. A failed export leaves no file.
   */
  exportTake(library: ClipLibrary, format: string, path: string, def: ExportDefInit = {}, progress: ProgressFunction | null = null): void {
    this.call_('muster_export_take', library, format, path, def, progress);
  }
}

/** Makes Take objects. */
export class TakeMaker extends Caller {
  /**
   * Reads a take. A torn last record is left out and counted in `tornBytes`. Fails with Corrupt, naming the
   * offset, where anything before it does not match its checksum; with ParseError or Unsupported on other files.
   */
  read(path: string): Take {
    return this.call_('muster_take_read', path) as Take;
  }

  /** The same from bytes; `sourceName` stands for the file in messages. */
  parse(bytes: Uint8Array, sourceName: string = 'take'): Take {
    return this.call_('muster_take_parse', bytes, sourceName) as Take;
  }
}

/** What belongs to no object. */
export class MusterFunctions extends Caller {
  /** The name of a code: "ok", "invalid argument"... "unknown" for other numbers. */
  statusName(status: Status): string {
    return this.call_('muster_status_name', status) as string;
  }

  /** The version of the library, "MAJOR.MINOR.PATCH". */
  version(): string {
    return this.call_('muster_version') as string;
  }

  /** True where the library was built with that component: "core", "motion" or "io". Null is none. */
  hasComponent(component: string): boolean {
    return this.call_('muster_has_component', component) as boolean;
  }

  /** No cells, 1 m each. */
  defaultMapDef(): MapDef {
    return this.call_('muster_default_map_def') as MapDef;
  }

  /** No shape yet, of the world's range and strength. */
  defaultObstacleDef(): ObstacleDef {
    return this.call_('muster_default_obstacle_def') as ObstacleDef;
  }

  /** A cyclic clip without a name, as fast as running. */
  defaultClipFacts(): ClipFacts {
    return this.call_('muster_default_clip_facts') as ClipFacts;
  }

  /** No shape yet, on which people run. */
  defaultPatchDef(): PatchDef {
    return this.call_('muster_default_patch_def') as PatchDef;
  }

  /** An exit without a shape yet, open, for as many as come. */
  defaultAreaDef(): AreaDef {
    return this.call_('muster_default_area_def') as AreaDef;
  }

  /** Half a metre round the origin. */
  defaultItemDef(): ItemDef {
    return this.call_('muster_default_item_def') as ItemDef;
  }

  /** A body by the parameters, of mass and supply 1. */
  defaultBody(): Body {
    return this.call_('muster_default_body') as Body;
  }

  /** 0 for all, which stands for a parameter. */
  defaultDistribution(): Distribution {
    return this.call_('muster_default_distribution') as Distribution;
  }

  /** One sort, by the parameters. */
  defaultPeopleDef(): PeopleDef {
    return this.call_('muster_default_people_def') as PeopleDef;
  }

  /** A square at 1 m. */
  defaultFormationDef(): FormationDef {
    return this.call_('muster_default_formation_def') as FormationDef;
  }

  /** A move to the origin. */
  defaultOrder(): Order {
    return this.call_('muster_default_order') as Order;
  }

  /** Everybody at their own pace, any squeeze. */
  defaultConduct(): Conduct {
    return this.call_('muster_default_conduct') as Conduct;
  }

  /** 36 characters in a square at the origin. */
  defaultGroupDef(): GroupDef {
    return this.call_('muster_default_group_def') as GroupDef;
  }

  /** 2 m round the origin, for half of any group. */
  defaultCheckpointDef(): CheckpointDef {
    return this.call_('muster_default_checkpoint_def') as CheckpointDef;
  }

  /** 32 m by 32 m of empty ground round the origin, with Muster's own clips. */
  defaultWorldDef(): WorldDef {
    return this.call_('muster_default_world_def') as WorldDef;
  }

  /**
   * Reads a path at `time` [s]. Fails with InvalidArgument, naming the waypoint, where times do not rise or a
   * number is out of range.
   */
  timedPathAt(path: TimedPathInit, time: number): PathState {
    return this.call_('muster_timed_path_at', path, time) as PathState;
  }

  /** The name of a kind as files spell it: "square", "line"... Null for other numbers. */
  formationName(kind: FormationKind): string | null {
    return this.call_('muster_formation_name', kind) as string | null;
  }

  /** The kind with that name. Fails with NotFound, listing the names. */
  formationKind(name: string): FormationKind {
    return this.call_('muster_formation_kind', name) as FormationKind;
  }

  /**
   * The clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order. Valid for
   * ever.
   */
  ownClipFacts(): readonly ClipFacts[] {
    return this.call_('muster_own_clip_facts') as readonly ClipFacts[];
  }

  /** Takes up a front from `left` to `right` [m]: its middle, width and facing. */
  orderToLine(left: Vec2, right: Vec2): Order {
    return this.call_('muster_order_to_line', left, right) as Order;
  }

  /**
   * The value below which a share of persons lie, in (0, 1). Fails with InvalidArgument for other shares, and for
   * a kind that is not known.
   */
  distributionQuantile(distribution: DistributionInit, share: number): number {
    return this.call_('muster_distribution_quantile', distribution, share) as number;
  }

  /** Adults: free speeds of mean 1.34 m/s and deviation 0.26 m/s, cut off at 0.5 and 2.2 m/s. */
  adults(): PeopleDef {
    return this.call_('muster_adults') as PeopleDef;
  }

  /** The mean free speed of persons by age [m/s], 5 to 90 years. */
  walkingSpeedAtAge(years: number): number {
    return this.call_('muster_walking_speed_at_age', years) as number;
  }

  /** Number of parameters. */
  parameterCount(): number {
    return this.call_('muster_parameter_count') as number;
  }

  /** The parameter of an index. Its texts are valid for ever. Fails with InvalidArgument for other indices. */
  parameterInfo(index: number): ParameterInfo {
    return this.call_('muster_parameter_info', index) as ParameterInfo;
  }

  /** The value of a parameter in a preset: "units" (the defaults), "people" or "paper". Fails with NotFound. */
  presetValue(preset: string, name: string): number {
    return this.call_('muster_preset_value', preset, name) as number;
  }

  /** A command of that kind with the defaults of its body, for step 0. Of kind 0 where there is no such kind. */
  defaultCommand(kind: CommandKind): Command {
    return this.call_('muster_default_command', kind) as Command;
  }

  /** The kind as a word, for logs: "Touch". Null for other numbers. */
  commandName(kind: CommandKind): string | null {
    return this.call_('muster_command_name', kind) as string | null;
  }

  /** Checks what does not depend on the world. Fails with InvalidArgument, naming the value. */
  commandValidate(command: CommandInit): void {
    this.call_('muster_command_validate', command);
  }

  /** Encodes a command as bytes, for messages and files: the same as those of takes. */
  commandEncode(command: CommandInit): Uint8Array<ArrayBuffer> {
    return this.call_('muster_command_encode', command) as Uint8Array<ArrayBuffer>;
  }

  /**
   * Decodes one command. Fails with ParseError where there are too few or too many bytes, the kind is unknown or a
   * value is out of its range.
   */
  commandDecode(bytes: Uint8Array): Command[] {
    return this.call_('muster_command_decode', bytes) as Command[];
  }

  /** The name of a kind: "enterPatch", "arrived"... Null for other numbers. */
  eventName(kind: EventKind): string | null {
    return this.call_('muster_event_name', kind) as string | null;
  }

  /** The JSON Schema (draft 2020-12) of scenario files. */
  scenarioSchema(): string {
    return this.call_('muster_scenario_schema') as string;
  }

  /**
   * Reads a gestures file into commands for a world of that step time [s], ordered by (step, client, sequence).
   * Fails as Scenario.load() does.
   */
  gesturesLoad(path: string, stepTime: number): Command[] {
    return this.call_('muster_gestures_load', path, stepTime) as Command[];
  }

  /** The same from text. */
  gesturesParse(text: string | Uint8Array, sourceName: string, stepTime: number): Command[] {
    return this.call_('muster_gestures_parse', text, sourceName, stepTime) as Command[];
  }

  /** The same from the text of a single event or of an array of events: `t` may be left out and is 0 then. */
  gesturesParseCommands(text: string | Uint8Array, sourceName: string, stepTime: number): Command[] {
    return this.call_('muster_gestures_parse_commands', text, sourceName, stepTime) as Command[];
  }

  /** The touches that a scenario carries which was read from `scenarioPath`. Empty where it carries none. */
  gesturesOfScenario(scenarioPath: string, scenario: Scenario): Command[] {
    return this.call_('muster_gestures_of_scenario', scenarioPath, scenario) as Command[];
  }

  /** The JSON Schema of gesture files. */
  gesturesSchema(): string {
    return this.call_('muster_gestures_schema') as string;
  }

  /** Commands as the text of a gestures file: reading it gives the same commands, numbered again per client. */
  gesturesText(commands: readonly CommandInit[], stepTime: number): string {
    return this.call_('muster_gestures_text', commands, stepTime) as string;
  }

  /** Writes that text to a file. Fails with IoError. */
  gesturesSave(commands: readonly CommandInit[], stepTime: number, path: string): void {
    this.call_('muster_gestures_save', commands, stepTime, path);
  }

  /** The JointRole.Count joints of the skeleton of a person 1.75 m tall. Valid for ever. */
  skeleton(): readonly Joint[] {
    return this.call_('muster_skeleton') as readonly Joint[];
  }

  /** Body size of the character with that id, as a factor of the skeleton: uniform in 0.96 to 1.04. */
  characterSize(character: number): number {
    return this.call_('muster_character_size', character) as number;
  }

  /** The rest pose. */
  restPose(): BodyPose {
    return this.call_('muster_rest_pose') as BodyPose;
  }

  /** Forward kinematics: writes JointRole.Count transforms. `root` transforms body axes to the world. */
  jointTransforms(pose: BodyPose, root: Transform): Float32Array {
    return this.call_('muster_joint_transforms', pose, root) as Float32Array;
  }

  /** Interpolates between two poses; t = 0 gives `a`, t = 1 gives `b`. */
  blendPoses(a: BodyPose, b: BodyPose, t: number): BodyPose {
    return this.call_('muster_blend_poses', a, b, t) as BodyPose;
  }

  /** The name of a limb: "left foot"... Null for other numbers. */
  limbName(limb: Limb): string | null {
    return this.call_('muster_limb_name', limb) as string | null;
  }

  /** The joint that stays in place during a contact of the limb. JointRole.Count for other numbers. */
  limbJoint(limb: Limb): JointRole {
    return this.call_('muster_limb_joint', limb) as JointRole;
  }

  /** Composition: `then` begins at the position and yaw at which `first` ends. */
  travelCompose(first: Travel, then: Travel): Travel {
    return this.call_('muster_travel_compose', first, then) as Travel;
  }

  /** A cyclic clip without poses, at 60 poses per second. */
  defaultClip(): Omit<Clip, 'copy'> {
    return this.call_('muster_default_clip') as Omit<Clip, 'copy'>;
  }

  /** All formats of this build. Valid for ever. */
  exportFormats(): readonly ExportFormat[] {
    return this.call_('muster_export_formats') as readonly ExportFormat[];
  }

  /** The format of that name. Fails with NotFound, naming all formats. */
  exportFormat(name: string): ExportFormat {
    return this.call_('muster_export_format', name) as ExportFormat;
  }

  /** The whole take at 30 frames per second. */
  defaultExportDef(): ExportDef {
    return this.call_('muster_default_export_def') as ExportDef;
  }

  /** Makes GridMap objects. */
  readonly GridMap = new GridMapMaker(this.invoke_);
  /** Makes World objects. */
  readonly World = new WorldMaker(this.invoke_);
  /** Makes Scenario objects. */
  readonly Scenario = new ScenarioMaker(this.invoke_);
  /** Makes ClipLibrary objects. */
  readonly ClipLibrary = new ClipLibraryMaker(this.invoke_);
  /** Makes Motion objects. */
  readonly Motion = new MotionMaker(this.invoke_);
  /** Makes Bvh objects. */
  readonly Bvh = new BvhMaker(this.invoke_);
  /** Makes TakeWriter objects. */
  readonly TakeWriter = new TakeWriterMaker(this.invoke_);
  /** Makes Take objects. */
  readonly Take = new TakeMaker(this.invoke_);
}

/** The classes of handles by their names. */
export const kHandleClasses = { GridMap, World, Scenario, ClipLibrary, Motion, MotionMoment, Bvh, TakeWriter, Take };
