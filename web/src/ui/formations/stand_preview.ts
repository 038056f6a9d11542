// Shows a formation before the crowd moves: every place where it would stand on the ground, at the group or where its
// orders lead, with those marked that nobody can get to.

import { standAfter, type Forecast } from '../../model/forecast';
import { distance } from '../../model/plane';
import type { FormationWords } from '../../model/sequence';
import { standOf, unfitWords, type Stand, type StandPose, type StandWords } from '../../model/stand';
import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import type { OrderPreview } from '../../tools/order_tools';
import { PlaceAsker, type PlacesLink } from '../orders/place_asker';

/** What is shown on the scene. */
export interface StandScene {
  previewOrder(drawn: (Omit<OrderPreview, 'moves'> & { moves: readonly Stand[]; note?: StandWords }) | null): void;
}

export interface StandHost {
  readonly client: PlacesLink;
  readonly store: StudioStore;
  readonly orders: StandScene;
  /** Forecasts of orders that wait, by their ids. */
  known(): ReadonlyMap<number, Forecast>;
  say(text: string): void;
}

interface Wanted {
  readonly formation: FormationWords;
  /** Null for where the group, or the last of its orders, is. */
  readonly at: StandPose | null;
  /** Somebody hears of the answer. */
  readonly told: boolean;
}

/** A formation is asked about again where its group has moved so far [m], or turned [rad]. */
const kMoved = { metres: 0.3, radians: 0.1 };

export class StandPreview {
  private readonly asker_: PlaceAsker;
  private frame_: StudioFrame | null = null;
  private wanted_: Wanted | null = null;
  private asked_: StandPose | null = null;

  constructor(private readonly host_: StandHost) {
    this.asker_ = new PlaceAsker(host_.client);
  }

  observe(frame: StudioFrame): void {
    this.frame_ = frame;
    const { wanted_: wanted, asked_: asked } = this;
    if (!wanted || !asked || wanted.at) return;
    const pose = this.pose();
    const turned = pose ? Math.abs(Math.sin((pose.facing - asked.facing) / 2)) * 2 : 0;
    if (!pose) this.hide();
    else if (distance(pose, asked) > kMoved.metres || turned > kMoved.radians) this.ask({ ...wanted, told: false });
  }

  /** The active group's places in a formation, without `at` where it will stand. */
  show(formation: FormationWords, at: StandPose | null = null, told = true): void {
    this.wanted_ = { formation, at, told };
    this.ask(this.wanted_);
  }

  hide(): void {
    if (!this.wanted_) return;
    this.wanted_ = this.asked_ = null;
    this.asker_.drop();
    this.host_.orders.previewOrder(null);
    this.host_.store.set({ stand: null });
  }

  /** Where the active group will stand: after its orders, if it has any. */
  private pose(): StandPose | null {
    const group = this.group();
    if (!group) return null;
    const { x, y, facing, orders, patrols } = group;
    return patrols ? { x, y, facing } : standAfter(group, orders.length, this.host_.known());
  }

  private group() {
    const { groups, active } = this.host_.store.state;
    const id = groups[active]?.id;
    return this.frame_?.groups.find((group) => group.id === id);
  }

  private ask(wanted: Wanted): void {
    const group = this.group();
    const pose = wanted.at ?? this.pose();
    if (!group || !pose) return;
    this.asked_ = pose;
    const { formation } = wanted;
    const { x, y, facing } = pose;
    this.asker_.ask(
      [{ group: group.id, formation, x, y, facing, places: new Float64Array(0), count: 0 }],
      ([answer]) => {
        const index = this.frame_?.groups.findIndex(({ id }) => id === group.id) ?? -1;
        if (!answer || index < 0 || !this.wanted_) return;
        const failed = answer.problem !== '';
        const words = failed ? { text: `${sentence(answer.problem)}`, warns: true } : unfitWords([answer.unfit]);
        const moves = failed ? [] : [standOf(answer, index, pose)];
        const { trying, dialog } = this.host_.store.state;
        // The bar, or the dialog, says it already.
        const note = trying || dialog !== 'none' ? {} : { note: words };
        this.host_.orders.previewOrder({ moves, rectangle: [], route: [], ...note });
        this.host_.store.set({ stand: words });
        if (wanted.told) this.host_.say(words.text);
      },
    );
  }
}

function sentence(problem: string): string {
  return problem.charAt(0).toUpperCase() + problem.slice(1);
}
