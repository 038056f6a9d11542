// Gives orders: keeps who is chosen, and turns what was drawn into commands.

import type { MessageSender } from '../../link/studio_client';
import {
  conductCommand,
  followCommand,
  guardCommand,
  leaveCommand,
  moveCommand,
  mergeCommand,
  splitByLineCommand,
  waitCommand,
  type Command,
  type GiveOrderCommand,
  type ConductFacts,
  type OrderStyle,
} from '../../model/commands';
import type { Cut, Cuttable } from '../../model/cut';
import { areaAt } from '../../model/goals';
import { GroupShapes } from '../../model/group_shapes';
import type { OrderActions } from '../../model/order_actions';
import type { OrderedGroup, PlannedMove } from '../../model/order_plan';
import { convexHull, insidePolygon, pointsOf, type GroundPoint, type ScreenPoint } from '../../model/plane';
import type { StudioFrame } from '../../model/studio_frame';
import type { ToolName, UnitInfo } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { UnitNews } from '../../model/unit_news';
import type { GroupMesh } from '../../protocol/messages';
import type { BoxSink } from '../../tools/box_select';
import type { Contact } from '../../tools/contact';
import type { CutPreview, CutSink } from '../../tools/cut_tool';
import type { OrderPreview, OrderSink } from '../../tools/order_tools';
import { HistoryController } from './history_controller';
import { QueueController, type QueueScene } from './queue_controller';

/** What the controller shows on the scene. */
export interface OrderControllerScene {
  readonly orders: QueueScene & {
    previewOrder(preview: OrderPreview | null): void;
    /** The order was given: what is wrong with it is still told for a while. */
    gaveOrder(given: OrderPreview): void;
    previewCut(preview: CutPreview | null): void;
  };
  previewControl(groupIndex: number, points: readonly GroundPoint[] | null, closed: boolean): void;
  worldToScreen(point: GroundPoint): ScreenPoint;
}

type Keys = Pick<Contact, 'shift' | 'alt'>;

/** Forecasts do not depend on where in the queue an order is said to go. */
const kFirst = { mode: 'replace' } as const;
/** Of a rectangle to guard [m]. */
const kLeastHalf = 0.5;
const kNoKeys: Keys = { shift: false, alt: false };
/** Behind the middle of the group that is followed [m]. */
const kFollowGap = 2;
const kOnce: readonly ToolName[] = ['follow', 'guard', 'leave', 'wait'];
/** The group of a press is the one whose mesh is this near [m]. */
const kNear = 1.5;

export class OrderController implements OrderActions, OrderSink, CutSink, BoxSink {
  readonly shapes = new GroupShapes();
  readonly queues: QueueController;
  readonly history: HistoryController;
  private readonly news_ = new UnitNews((was, now) => this.queues.copied(was, now));
  private frame_: StudioFrame | null = null;

  constructor(
    private readonly client_: MessageSender,
    private readonly store_: StudioStore,
    private readonly scene_: OrderControllerScene,
    private readonly say_: (text: string) => void,
    held?: () => string | null,
  ) {
    this.queues = new QueueController(client_, store_, scene_.orders, this.news_, say_);
    this.history = new HistoryController(client_, store_, held);
  }

  setMesh(mesh: GroupMesh): void {
    this.shapes.setMesh(mesh);
  }

  forgetWorld(): void {
    this.shapes.clear();
    this.news_.clear();
    this.queues.forgetWorld();
    this.store_.set({ selected: [] });
  }

  /** Takes a frame; the state has its groups already. */
  observe(frame: StudioFrame): void {
    this.frame_ = frame;
    const made = this.news_.observe(frame.events);
    this.queues.observe(frame);
    this.chooseParts(made);
    const { groups, active, selected } = this.store_.state;
    if (selected.length === 0 && groups[active]) this.store_.set({ selected: [groups[active].id] });
  }

  /** The server refused commands. */
  refused(): void {
    this.news_.refused();
  }

  // ---- Who is chosen ----

  choose(index: number, add: boolean): void {
    const { groups, selected } = this.store_.state;
    const group = groups[index];
    if (!group || (add && selected.length === 1 && selected[0] === group.id)) return;
    if (add && selected.includes(group.id) && selected.length > 1) {
      const left = selected.filter((id) => id !== group.id);
      this.store_.set({ selected: left, active: groups.findIndex(({ id }) => id === left[0]) });
      return;
    }
    this.store_.set({ active: index, selected: add ? [...selected, group.id] : [group.id] });
    this.say_(`${group.name} chosen`);
  }

  chooseAll(): void {
    const { groups } = this.store_.state;
    this.store_.set({ selected: groups.map(({ id }) => id) });
    this.say_(`All ${groups.length} groups chosen`);
  }

  chooseWithin(from: ScreenPoint, to: ScreenPoint): void {
    const inside = ({ x, y }: ScreenPoint): boolean => (x - from.x) * (x - to.x) <= 0 && (y - from.y) * (y - to.y) <= 0;
    const within = (this.frame_?.groups ?? []).filter(({ places, vertices }) =>
      pointsOf(places.length > 0 ? places : vertices).some((place) => inside(this.scene_.worldToScreen(place))),
    );
    const first = within[0];
    if (!first) return;
    const { groups } = this.store_.state;
    this.store_.set({
      active: groups.findIndex(({ id }) => id === first.id),
      selected: within.map(({ id }) => id),
    });
    this.say_(within.length === 1 ? `${this.nameOf(first.id)} chosen` : `${within.length} groups chosen`);
  }

  groups(): readonly OrderedGroup[] {
    const { selected } = this.store_.state;
    return (this.frame_?.groups ?? []).flatMap(({ id, x, y, facing }, index) => {
      const shape = this.shapes.of(id);
      return shape && shape.places.length > 0 && selected.includes(id)
        ? [{ id, index, at: { x, y }, facing, shape }]
        : [];
    });
  }

  /** True where a chosen group's mesh lies under the point. */
  isChosenAt(at: GroundPoint): boolean {
    const { selected } = this.store_.state;
    return this.formations().some(({ group, outline }) => selected.includes(group) && insidePolygon(at, outline));
  }

  // ---- What was drawn ----

  previewOrder(preview: OrderPreview | null, keys: Keys = kNoKeys): void {
    this.scene_.orders.previewOrder(preview);
    this.queues.drawn(preview ? this.ordersOf(preview, keys) : [], keys.shift);
  }

  previewCut(preview: CutPreview | null): void {
    this.scene_.orders.previewCut(preview);
  }

  previewBox(corners: readonly GroundPoint[] | null): void {
    this.scene_.previewControl(-1, corners, true);
  }

  move(moves: readonly PlannedMove[], keys: Keys): void {
    const style = this.styleOf(keys);
    this.give(moves.map((move) => moveCommand(move.group, move, style, this.queues.spotOf(move.group, keys.shift))));
    this.say_('Order given');
    this.scene_.orders.gaveOrder({ moves, rectangle: [], route: [] });
  }

  guard(centre: GroundPoint, halfSize: GroundPoint, facing: number, keys: Keys): void {
    this.give(
      this.groups().map(({ id }) => guardCommand(id, centre, halfSize, facing, this.queues.spotOf(id, keys.shift))),
    );
  }

  follow(at: GroundPoint, keys: Keys): void {
    const leader = this.formations().find(({ outline }) => insidePolygon(at, outline)) ?? this.nearest(at);
    const followers = this.groups().filter(({ id }) => id !== leader?.group);
    if (!leader || followers.length === 0) {
      this.say_('Press on another group, which they shall follow');
      return;
    }
    const behind = (group: OrderedGroup): GroundPoint => ({
      x: -this.depths(group.id, leader.group) - kFollowGap,
      y: 0,
    });
    this.give(
      followers.map((group) =>
        followCommand(group.id, leader.group, behind(group), this.queues.spotOf(group.id, keys.shift)),
      ),
    );
    this.say_(`Follows ${this.nameOf(leader.group)}`);
  }

  leave(at: GroundPoint, keys: Keys): void {
    const { areas, selected } = this.store_.state;
    if (!areas.some(({ kind }) => kind === 'exit')) return this.say_('There is no exit to leave by');
    const exit = areaAt(areas, 'exit', at);
    const exits = exit ? [exit.id] : [];
    this.give(selected.map((id) => leaveCommand(id, exits, this.queues.spotOf(id, keys.shift))));
    this.say_(exit ? `Leaves by ${exit.name || 'the exit'}` : 'Leaves by all exits');
  }

  wait(at: GroundPoint, keys: Keys): void {
    const { areas, selected } = this.store_.state;
    const area = areaAt(areas, 'waiting', at);
    if (!area) return this.say_('Press on the area where they shall wait');
    this.give(selected.map((id) => waitCommand(id, area.id, this.queues.spotOf(id, keys.shift))));
    this.say_(`Waits in ${area.name || 'the area'}`);
  }

  formations(): readonly Cuttable[] {
    return (this.frame_?.groups ?? []).map((group, index) => ({
      group: group.id,
      index,
      outline: convexHull(pointsOf(group.vertices)),
      places: pointsOf(group.places),
    }));
  }

  split(cut: Cut): void {
    this.news_.splitAsked(cut.group);
    this.send([splitByLineCommand(cut.group, cut.from, cut.to)]);
    this.say_(`${this.nameOf(cut.group)} divided: ${cut.left} leave, ${cut.right} stay`);
  }

  merge(into: number, dragged: number): void {
    if (into === dragged) return;
    this.send([mergeCommand([into, dragged], 'smaller')]);
    const { groups } = this.store_.state;
    const index = groups.findIndex(({ id }) => id === into);
    if (index >= 0) this.store_.set({ active: index, selected: [into] });
    this.say_(`${this.nameOf(dragged)} joins ${this.nameOf(into)}`);
  }

  missed(reason: string): void {
    this.say_(reason);
    this.store_.set({
      notice: { type: 'Notice', level: 0, code: 'cut', text: `${reason}.`, hasPlace: false, x: 0, y: 0 },
    });
  }

  // ---- Buttons and keys ----

  setTool(tool: ToolName): void {
    if (this.store_.state.tool === tool) return;
    // Without a tool in hand nothing is inserted.
    this.store_.set(tool === 'steer' || tool === 'cut' ? { tool, insertBefore: 0 } : { tool });
    this.say_(kToolWords[tool]);
  }

  toggleTool(tool: ToolName): void {
    this.setTool(this.store_.state.tool === tool ? 'steer' : tool);
  }

  setStyle(style: Partial<OrderStyle>): void {
    this.store_.set({ style: { ...this.store_.state.style, ...style } });
  }

  toggleWords(): void {
    this.store_.set({ words: !this.store_.state.words });
  }

  stop(): void {
    this.queues.edit(this.store_.state.selected, 'stop');
    this.say_('Stop');
  }

  toggleHold(): void {
    const held = this.activeUnit()?.held ?? false;
    this.queues.edit(this.store_.state.selected, held ? 'resume' : 'hold');
    this.say_(held ? 'Goes on' : 'Holds');
  }

  togglePatrol(): void {
    const patrols = this.activeUnit()?.patrols ?? false;
    this.queues.edit(this.store_.state.selected, patrols ? 'endPatrol' : 'patrol');
    this.say_(patrols ? 'Ends the patrol' : 'Patrols');
  }

  pickOrder(order: number): void {
    this.queues.pick(order);
  }

  insertBefore(order: number): void {
    this.queues.insertBefore(order);
  }

  moveOrder(order: number, index: number): void {
    this.queues.moveTo(order, index);
  }

  skipOrder(): void {
    this.queues.skip();
  }

  cancelOrder(order: number): void {
    this.queues.cancel(order);
  }

  setConduct(conduct: Partial<ConductFacts>): void {
    const { units, selected } = this.store_.state;
    const chosen = units.filter(({ id }) => selected.includes(id));
    this.send(chosen.map((unit) => conductCommand(unit.id, { ...unit.conduct, ...conduct })));
  }

  undo(redo = false): void {
    this.history.undo(redo);
  }

  /** Orders, at most one for each group. */
  private give(orders: readonly GiveOrderCommand[]): void {
    this.send(orders);
    this.once();
    this.queues.given();
  }

  private send(commands: readonly Command[]): void {
    if (commands.length > 0) this.client_.send({ type: 'Commands', commands });
  }

  /** Tools that are meant for one order are put away. */
  private once(): void {
    if (kOnce.includes(this.store_.state.tool)) this.store_.set({ tool: 'steer' });
  }

  /** The orders that would be given. */
  private ordersOf({ moves, rectangle }: OrderPreview, keys: Keys): GiveOrderCommand[] {
    const style = this.styleOf(keys);
    const [a, , b] = rectangle;
    if (!a || !b) return moves.map((move) => moveCommand(move.group, move, style, kFirst));
    const centre = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    const half = { x: Math.abs(b.x - a.x) / 2, y: Math.abs(b.y - a.y) / 2 };
    if (half.x < kLeastHalf || half.y < kLeastHalf) return [];
    return this.groups().map(({ id }) => guardCommand(id, centre, half, 0, kFirst));
  }

  private styleOf(keys: Keys): OrderStyle {
    const { style } = this.store_.state;
    return { ...style, manner: keys.alt ? 'free' : style.manner };
  }

  private activeUnit(): UnitInfo | undefined {
    return this.store_.state.units[this.store_.state.active];
  }

  private nameOf(group: number): string {
    return this.store_.state.groups.find(({ id }): boolean => id === group)?.name ?? 'the group';
  }

  /** Half the depth of both, one behind the other [m]. */
  private depths(a: number, b: number): number {
    const half = (group: number): number => {
      const along = (this.shapes.of(group)?.places ?? []).map(({ x }) => Math.abs(x));
      return Math.max(0, ...along);
    };
    return half(a) + half(b);
  }

  private nearest(at: GroundPoint): Cuttable | undefined {
    const reach = (one: Cuttable): number =>
      Math.min(...one.places.map((place) => Math.hypot(place.x - at.x, place.y - at.y)));
    const sorted = this.formations()
      .filter((one) => one.places.length > 0)
      .map((one) => ({ one, away: reach(one) }))
      .sort((a, b) => a.away - b.away);
    return sorted[0] && sorted[0].away < kNear ? sorted[0].one : undefined;
  }

  /** The parts of a split of ours are chosen, to get orders at once. */
  private chooseParts(made: readonly number[]): void {
    const { groups } = this.store_.state;
    const index = groups.findIndex(({ id }) => id === made[0]);
    if (index >= 0) this.store_.set({ active: index, selected: [...made] });
  }
}

const kToolWords: Readonly<Record<ToolName, string>> = {
  steer: 'Steering: fingers shape the formation',
  order: 'Orders: drag on the ground for place and front',
  cut: 'Cutting: draw across a formation',
  follow: 'Press on the group to follow',
  guard: 'Drag the rectangle to guard',
  leave: 'Press on the exit to leave by; elsewhere: by all exits',
  wait: 'Press on the area where they shall wait',
  draw: 'Draw an outline on the ground',
  place: 'Press on the ground for the new group',
};
