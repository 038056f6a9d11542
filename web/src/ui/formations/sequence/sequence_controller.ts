// The formations that the active group takes up along its way: edits of its queue, and how it would stand at each.

import { lengthOf } from '../../../model/plane';
import { PanelLayout } from '../../widgets/panel_layout';
import { PlaybackAction, type PlacesFrame } from '../../../protocol/messages';
import type { Vec2 } from '../../../protocol/generated/commands';
import { problem } from '../../../protocol/problem';
import { savedShapes } from '../../../model/saved_shapes';
import {
  alongWay,
  arranged,
  formationKind,
  plainLegs,
  stationsOf,
  withStations,
  type FormationWords,
  type Station,
  type WayLeg,
} from '../../../model/sequence';
import { forCount } from '../../../model/shape_edit';
import { standOf, unfitCount, type Stand, type StandPose } from '../../../model/stand';
import type { StudioFrame, StudioGroup } from '../../../model/studio_frame';
import type { StudioStore } from '../../../model/studio_store';
import { legsOf } from '../../../scene/marks/order_marks';
import type { StudioScene } from '../../../scene/studio_scene';
import { kFormations } from '../formation_panel';
import { PlaceAsker, type PlacesLink } from '../../orders/place_asker';
import type { QueueController } from '../../orders/queue_controller';
import { SequencePanel, type SequenceRow } from './sequence_panel';
import '../../styles/sequence.css';

export interface SequenceParts {
  readonly client: PlacesLink & {
    on(event: 'frame', listener: () => void): void;
  };
  readonly store: StudioStore;
  readonly view: Pick<StudioScene, 'orders'>;
  readonly page: HTMLElement;
  readonly queues: QueueController;
  /** The newest one. */
  frame(): StudioFrame | null;
}

/** Formations of one group, at most. */
const kMostStations = 12;
/** How the group would stand is asked about again after so long [ms]. */
const kAgain = 1000;
const kSavedPrefix = 'saved:';
/** What the world does not answer is shown no longer than this [ms]. */
const kPatience = 1500;

/** An edit that no frame shows yet, and the queue that it was made of. */
interface Edit {
  readonly stations: readonly Station[];
  readonly key: string;
  readonly until: number;
  /** It was edited again since it was sent. */
  readonly more: boolean;
}

export class SequenceController {
  private readonly panel_: SequencePanel;
  private readonly asker_: PlaceAsker;
  private asked_ = -Infinity;
  /** How the group would stand is on the ground. */
  private shows_ = false;
  private unfit_: readonly (PlacesFrame | undefined)[] = [];
  /** The last edit. */
  private edited_: Edit | null = null;

  constructor(private readonly parts_: SequenceParts) {
    const { client, store, page } = parts_;
    this.asker_ = new PlaceAsker(client);
    this.panel_ = new SequencePanel(store, {
      close: () => store.set({ sequencing: false }),
      add: () => this.add(),
      place: (index, at) => this.change(index, (station) => ({ ...station, at })),
      choose: (index, name) => this.choose(index, name),
      earlier: (index) => this.swap(index),
      remove: (index) => this.edit(this.stations().filter((_, i) => i !== index)),
    });
    PanelLayout.of(page).add('sequence', this.panel_.root);
    client.on('frame', () => this.observe());
    store.watch(['sequencing', 'active'], ({ sequencing }) => (sequencing ? this.opened() : this.closed()));
  }

  private opened(): void {
    this.asked_ = -Infinity;
    this.unfit_ = [];
    this.show();
  }

  private closed(): void {
    this.panel_.root.hidden = true;
    this.edited_ = null;
    this.asker_.drop();
    if (this.shows_) this.parts_.view.orders.previewOrder(null);
    this.shows_ = false;
  }

  private observe(): void {
    const { sequencing, dialog } = this.parts_.store.state;
    if (!sequencing) return;
    if (this.legs().length === 0) return this.parts_.store.set({ sequencing: false });
    this.settle();
    if (dialog === 'none') this.show();
  }

  private group(): StudioGroup | undefined {
    const { groups, active } = this.parts_.store.state;
    return this.parts_.frame()?.groups.find(({ id }) => id === groups[active]?.id);
  }

  private legs(): WayLeg[] {
    const group = this.group();
    if (!group) return [];
    const ways = new Map([...this.parts_.queues.forecaster.known].map(([id, { way }]) => [id, way]));
    return legsOf(group, this.parts_.frame()?.groups ?? [], ways).map(({ points }, k) => ({
      order: group.orders[k]!,
      points,
    }));
  }

  private key(): string {
    return (this.group()?.orders ?? []).map(({ id }) => id).join();
  }

  /** As edited, or as the queue has them. */
  private stations(): readonly Station[] {
    return this.pending()?.stations ?? stationsOf(this.legs());
  }

  private way(legs = plainLegs(this.legs())) {
    return legs.flatMap(({ points }, k) => (k === 0 ? points : points.slice(1)));
  }

  private spacing(): number {
    const group = this.group();
    return (group && this.parts_.view.orders.scene(true).shapes.of(group.id)?.spacing) ?? 1;
  }

  // ---- Edits ----

  private add(): void {
    const stations = this.stations();
    if (stations.length >= kMostStations) return;
    const length = lengthOf(this.way());
    const last = stations[stations.length - 1]?.at ?? 0;
    const used = stations[stations.length - 1]?.formation.kind ?? this.shapeNow();
    const kinds = kFormations.slice(0, 8).map(({ name }) => name);
    const kind = kinds[(kinds.indexOf(used) + 1) % kinds.length]!;
    const at = length - last > 1 ? (last + length) / 2 : length;
    this.edit([...stations, { at, formation: { kind: formationKind(kind), spacing: this.spacing() } }]);
  }

  private shapeNow(): string {
    const { groups, active } = this.parts_.store.state;
    return groups[active]?.formation ?? 'square';
  }

  private choose(index: number, name: string): void {
    const formation = name.startsWith(kSavedPrefix) ? this.saved(name.slice(kSavedPrefix.length)) : null;
    this.change(index, (station) => ({
      ...station,
      formation: formation ?? { kind: formationKind(name), spacing: this.spacing() },
    }));
  }

  private saved(name: string): FormationWords | null {
    const shape = savedShapes(() => window.localStorage).find((one) => one.name === name);
    const count = (this.group()?.places.length ?? 0) / 2;
    if (!shape) return null;
    const { spacing, places } = forCount(shape, count);
    const round = (value: number): number => Math.round(value * 1000) / 1000;
    return { kind: 'points', spacing, points: places.map(({ x, y }): Vec2 => [round(x), round(y)]) };
  }

  private change(index: number, to: (station: Station) => Station): void {
    this.edit(this.stations().map((station, i) => (i === index ? to(station) : station)));
  }

  /** The formations of two neighbours change places. */
  private swap(index: number): void {
    const stations = [...this.stations()];
    const [before, here] = [stations[index - 1], stations[index]];
    if (!before || !here) return;
    stations[index - 1] = { ...before, formation: here.formation };
    stations[index] = { ...here, formation: before.formation };
    this.edit(stations);
  }

  /** One edit is under way at a time: what comes meanwhile follows from the queue that it leads to. */
  private edit(stations: readonly Station[]): void {
    const wanted = arranged(stations, lengthOf(this.way()));
    const waits = this.pending() !== null;
    this.edited_ = waits
      ? { ...this.edited_!, stations: wanted, more: true }
      : { stations: wanted, key: this.key(), until: performance.now() + kPatience, more: false };
    if (!waits) this.send(wanted);
    this.unfit_ = [];
    this.asked_ = -Infinity;
    this.show();
  }

  private send(stations: readonly Station[]): void {
    const { client, queues, store } = this.parts_;
    const group = this.group();
    const queue = group && queues.queue(group.id);
    const legs = this.legs();
    if (!queue || legs.length === 0) return;
    queues.change(queue, { ...queue, orders: withStations(legs, stations) });
    // Who plans while the world waits sees what was planned.
    if (!store.state.playing) client.send({ type: 'Playback', action: PlaybackAction.SingleStep });
  }

  /** The edit that no frame shows yet. */
  private pending(): Edit | null {
    const { edited_: edited } = this;
    return edited && edited.key === this.key() && performance.now() < edited.until ? edited : null;
  }

  /** Goes on with what was edited meanwhile, once a frame shows the edit before. */
  private settle(): void {
    const { edited_: edited } = this;
    if (!edited || this.pending()) return;
    this.edited_ = null;
    if (edited.more) this.edit(edited.stations);
  }

  // ---- What is shown ----

  private show(): void {
    const [stations, way] = [this.stations(), this.way()];
    const rows = stations.map(({ at, formation }, i): SequenceRow => {
      const unfit = this.unfit_[i]?.unfit;
      return { at, formation, bad: unfit ? unfitCount(unfit) : 0, all: unfit?.length ?? 0 };
    });
    this.panel_.show(rows, lengthOf(way), stations.length < kMostStations);
    const now = performance.now();
    // An order that is being drawn is shown instead.
    const draws = this.parts_.view.orders.scene(true).forecasts.length > 0;
    if (draws || now - this.asked_ < kAgain) return;
    this.asked_ = now;
    this.ask(stations, way);
  }

  private ask(stations: readonly Station[], way: readonly { x: number; y: number }[]): void {
    const group = this.group();
    if (!group) return;
    const poses = stations.map(({ at }): StandPose => alongWay(way, at));
    const asks = stations.map(({ formation }, i) => ({
      group: group.id,
      formation,
      ...poses[i]!,
      places: new Float64Array(0),
      count: 0,
    }));
    if (asks.length === 0) return this.draw([]);
    this.asker_.ask(asks, (answers) => {
      this.unfit_ = answers;
      const failed = answers.find((answer) => answer.problem !== '');
      if (failed) this.parts_.store.set({ notice: problem('formation', failed.problem) });
      const index = this.parts_.frame()?.groups.findIndex(({ id }) => id === group.id) ?? -1;
      this.draw(
        answers.flatMap((answer, i) => (answer.problem || index < 0 ? [] : [standOf(answer, index, poses[i]!)])),
      );
    });
  }

  private draw(moves: readonly Stand[]): void {
    if (!this.parts_.store.state.sequencing) return;
    this.shows_ = true;
    this.parts_.view.orders.previewOrder({ moves, rectangle: [], route: [] });
  }
}
