// Edits of queues: where new orders go, which ones are moved, cancelled or skipped, and their forecasts.

import type { MessageSender } from '../../link/studio_client';
import {
  queueCommand,
  type Command,
  type GiveOrderCommand,
  type QueueEditWord,
  type QueueSpot,
} from '../../model/commands';
import { drawnAsk, formatSpan, secondsUntil, type Forecast } from '../../model/forecast';
import type { GroundPoint } from '../../model/plane';
import { queueChange, reordered, skipped, type QueueState } from '../../model/queue_edit';
import type { StudioFrame, StudioGroup } from '../../model/studio_frame';
import type { QueueItem, ToolName } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { UnitNews } from '../../model/unit_news';
import type { FormationKindWord, OrderKindWord } from '../../protocol/generated/words';
import type { Forecasts } from '../../protocol/messages';
import { Forecaster } from './forecaster';

/** What a drawn order would come to, on the scene. */
interface ShownForecast {
  readonly index: number;
  readonly way: readonly GroundPoint[];
  readonly arrives: boolean;
  readonly text: string;
}

type Ways = ReadonlyMap<number, readonly GroundPoint[]>;

export interface QueueScene {
  previewForecasts(forecasts: readonly ShownForecast[]): void;
  setWays(ways: Ways, returns: Ways): void;
  setPicked(order: number): void;
}

const kOrderWords: Readonly<Record<OrderKindWord, string>> = {
  move: 'Move',
  face: 'Face',
  follow: 'Follow',
  guard: 'Guard',
  leave: 'Leave',
  wait: 'Wait',
  walk: 'Walk on',
};
/** Shapes that are no part of the library. */
const kOwnWords: Readonly<Record<string, string>> = { outline: 'drawn', points: 'own shape' };

export class QueueController {
  readonly forecaster: Forecaster;
  private frame_: StudioFrame | null = null;
  /** Groups of the drawn order: index into the frame's groups, and the orders that come before. */
  private drawn_: { readonly id: number; readonly index: number; readonly before: number }[] = [];

  /** In hand before an order was to be inserted. */
  private toolBefore_: ToolName = 'steer';

  constructor(
    private readonly client_: MessageSender,
    private readonly store_: StudioStore,
    private readonly scene_: QueueScene,
    private readonly news_: UnitNews,
    private readonly say_: (text: string) => void,
  ) {
    this.forecaster = new Forecaster(
      client_,
      (forecasts) => this.showDrawn(forecasts),
      () => this.showWays(),
    );
    store_.watch(['picked'], ({ picked }) => scene_.setPicked(picked));
  }

  forgetWorld(): void {
    this.frame_ = null;
    this.forecaster.clear();
    this.showWays();
    this.store_.set({ queue: [], picked: 0, insertBefore: 0 });
  }

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
    this.forecaster.observe(frame.groups, frame.sceneRevision, frame.time);
    this.showList();
  }

  /** Asks what is to be asked. `now` [ms]. */
  tick(now: number): void {
    this.forecaster.tick(now);
  }

  answered(message: Forecasts, now: number): void {
    this.forecaster.answered(message, now);
  }

  /** Picked orders and places to insert keep to orders that go on under other ids. */
  copied(was: number, now: number): void {
    const { picked, insertBefore } = this.store_.state;
    if (picked === was) this.store_.set({ picked: now });
    if (insertBefore === was) this.store_.set({ insertBefore: now });
  }

  // ---- Where new orders go ----

  /** Where a group's new order goes; `add`: the keys ask for it to come last. */
  spotOf(group: number, add: boolean): QueueSpot {
    const { insertBefore, style } = this.store_.state;
    const index = this.queue(group)?.orders.findIndex(({ id }) => id === insertBefore) ?? -1;
    if (insertBefore !== 0 && index >= 0) return { mode: 'insert', index };
    return { mode: add ? 'append' : style.mode };
  }

  /** The next order comes before this one; again, or 0: it does not. */
  insertBefore(order: number): void {
    const { insertBefore, tool, groups, active } = this.store_.state;
    const group = groups[active];
    if (order === 0 || order === insertBefore || !group) return this.store_.set({ insertBefore: 0 });
    const index = this.queue(group.id)?.orders.findIndex(({ id }) => id === order) ?? -1;
    if (index < 0) return;
    if (insertBefore === 0) this.toolBefore_ = tool;
    this.store_.set({
      insertBefore: order,
      selected: [group.id],
      ...(tool === 'steer' || tool === 'cut' ? { tool: 'order' } : {}),
    });
    this.say_(`The next order comes before order ${index + 1}`);
  }

  /** After an order was given. */
  given(): void {
    if (this.store_.state.insertBefore !== 0) this.store_.set({ insertBefore: 0, picked: 0, tool: this.toolBefore_ });
  }

  // ---- Edits ----

  pick(order: number): void {
    this.store_.set({ picked: this.store_.state.picked === order ? 0 : order, insertBefore: 0 });
  }

  cancel(order: number): void {
    const queue = this.activeQueue();
    const index = queue?.orders.findIndex(({ id }) => id === order) ?? -1;
    if (!queue || index < 0) return;
    this.send([queueCommand(queue.group, 'cancel', order)]);
    if (this.store_.state.picked === order) this.store_.set({ picked: 0 });
    this.say_(`Order ${index + 1} cancelled`);
  }

  moveTo(order: number, index: number): void {
    const queue = this.activeQueue();
    if (!queue || index < 0 || index >= queue.orders.length || queue.orders[index]?.id === order) return;
    this.change(queue, reordered(queue, order, index));
    this.say_(`Now order ${index + 1}`);
  }

  skip(): void {
    const queue = this.activeQueue();
    if (!queue || queue.orders.length === 0) return this.say_('There is no order to skip');
    this.change(queue, skipped(queue));
    this.say_('Skipped');
  }

  /** The same edit for several groups. */
  edit(groups: readonly number[], edit: QueueEditWord): void {
    this.send(groups.map((id) => queueCommand(id, edit)));
  }

  queue(group: number): QueueState | undefined {
    const found = this.frame_?.groups.find(({ id }) => id === group);
    return found && { group, orders: found.orders, held: found.held, patrols: found.patrols };
  }

  /** Gives the commands that lead from one queue to another. */
  change(now: QueueState, wanted: QueueState): void {
    const { commands, copied } = queueChange(now, wanted);
    this.news_.copiesAsked(now.group, copied);
    this.send(commands);
  }

  private send(commands: readonly Command[]): void {
    if (commands.length > 0) this.client_.send({ type: 'Commands', commands });
  }

  private activeGroup(): StudioGroup | undefined {
    const { groups, active } = this.store_.state;
    const id = groups[active]?.id;
    return this.frame_?.groups.find((group) => group.id === id);
  }

  private activeQueue(): QueueState | undefined {
    const group = this.activeGroup();
    return group && this.queue(group.id);
  }

  // ---- Forecasts ----

  /** Asks what would come of orders that are drawn, one for each group; none where the drawing has ended. */
  drawn(orders: readonly GiveOrderCommand[], add: boolean): void {
    const groups = this.frame_?.groups ?? [];
    const asks = [];
    this.drawn_ = [];
    for (const { group, order } of orders) {
      const index = groups.findIndex(({ id }) => id === group);
      const before = this.countBefore(group, add);
      if (index < 0) continue;
      this.drawn_.push({ id: group, index, before });
      asks.push(drawnAsk(groups[index]!, before, order, this.forecaster.known));
    }
    this.forecaster.draw(asks.length > 0 ? asks : null);
  }

  /** How many orders a group's new one would come after. */
  private countBefore(group: number, add: boolean): number {
    const spot = this.spotOf(group, add);
    if (spot.mode === 'insert') return spot.index;
    return spot.mode === 'append' ? (this.queue(group)?.orders.length ?? 0) : 0;
  }

  private showDrawn(forecasts: readonly Forecast[]): void {
    const waits: (number | null)[] = [];
    const shown = forecasts.flatMap(({ group, arrives, seconds, way }): ShownForecast[] => {
      const drawn = this.drawn_.find(({ id }) => id === group);
      const asker = drawn && this.frame_?.groups[drawn.index];
      if (!asker) return [];
      const before = secondsUntil(asker, drawn.before, this.forecaster.known);
      waits.push(arrives ? (before === null ? null : before + seconds) : Infinity);
      return [{ index: drawn.index, way, arrives, text: '' }];
    });
    // One label tells of all.
    this.scene_.previewForecasts(shown.map((one, k) => (k === 0 ? { ...one, text: arrivalText(waits) } : one)));
  }

  private showWays(): void {
    const { known, returns } = this.forecaster;
    const ways = new Map<number, readonly GroundPoint[]>();
    for (const { order, way } of known.values()) if (way.length > 1) ways.set(order, way);
    this.scene_.setWays(ways, new Map([...returns].map(([group, { way }]) => [group, way])));
    this.showList();
  }

  /** The active group's queue, with the times until its orders are done. */
  private showList(): void {
    const group = this.activeGroup();
    const { known } = this.forecaster;
    const gone = group && this.frame_ ? this.frame_.time - this.forecaster.since(group.id) : 0;
    const items = (group?.orders ?? []).map(({ id, kind, formation }, k): QueueItem => {
      const seconds = secondsUntil(group!, k + 1, known);
      const arrives = known.get(id)?.arrives ?? true;
      const isKnown = seconds !== null && Number.isFinite(seconds) && !group!.held;
      return {
        id,
        kind,
        word: wordOf(kind, formation?.kind ?? 'square'),
        arrives,
        span: arrives && isKnown ? formatSpan(seconds - gone) : '',
      };
    });
    const { queue, picked, insertBefore } = this.store_.state;
    if (JSON.stringify(items) !== JSON.stringify(queue)) this.store_.set({ queue: items });
    const there = (order: number): boolean => order === 0 || items.some(({ id }) => id === order);
    if (!there(picked)) this.store_.set({ picked: 0 });
    if (!there(insertBefore)) this.store_.set({ insertBefore: 0 });
  }
}

/** What an order is, and the formation that it takes up. */
function wordOf(kind: OrderKindWord, formation: FormationKindWord): string {
  const word = kOrderWords[kind];
  return formation === 'square' ? word : `${word}, ${kOwnWords[formation] ?? formation}`;
}

/** When groups would arrive: null where that is not known, infinite where it never is [s]. */
export function arrivalText(waits: readonly (number | null)[]): string {
  const lost = waits.filter((wait) => wait === Infinity).length;
  if (waits.length > 0 && lost === waits.length) return 'Cannot be reached';
  const times = waits.filter((wait) => wait !== null && wait !== Infinity) as number[];
  const spans = [...new Set([Math.min(...times), Math.max(...times)].map(formatSpan))];
  const when = times.length > 0 ? `in ${spans.join(' to ')}` : 'arrives';
  return lost > 0 ? `${when}, ${lost} cannot` : when;
}
