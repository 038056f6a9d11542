// What fingers draw that no frame of the server shows yet. While the world is paused nothing answers them: drafts show
// what they have drawn, until the next step takes it.

import { convexHull } from '../geometry/plane';
import { ControlKind } from '../protocol/messages';
import type { StudioFrame } from '../engine/studio_frame';
import type { GroundPoint } from '../view/camera_types';
import type { DraftControl } from '../view/mark_layer';

/** Where tools write down what they send. */
export interface DraftBook {
  /** The finger of this touch is at `at`; `time` as sent. */
  add(touch: number, group: number, at: GroundPoint, time: number): void;
  /** What it drew counts no more. */
  drop(touch: number): void;
  /** A new control was asked for, or let go. */
  changed(): void;
}

export const noDrafts: DraftBook = { add: () => undefined, drop: () => undefined, changed: () => undefined };

/** A new control that no frame shows yet. */
export interface AskedControl {
  readonly group: number;
  readonly kind: ControlKind;
  readonly fingers: readonly { readonly at: GroundPoint }[];
}

interface Way {
  readonly group: number;
  readonly points: { readonly at: GroundPoint; readonly time: number }[];
}

export class Drafts implements DraftBook {
  private readonly ways = new Map<number, Way>();
  private groups: readonly number[] = [];
  /** Where the paths end that the last frame shows, by touch. */
  private ends = new Map<number, GroundPoint>();
  private paused = false;
  private shown = false;
  private step = 0;

  /** `show` hears of every change; `asked` tells the controls that wait for an answer. */
  constructor(
    private readonly show: (drafts: readonly DraftControl[]) => void,
    private readonly asked: () => readonly AskedControl[],
    private readonly clientId: () => number,
  ) {}

  add(touch: number, group: number, at: GroundPoint, time: number): void {
    const way = this.ways.get(touch) ?? { group, points: [] };
    way.points.push({ at, time });
    this.ways.set(touch, way);
    if (this.paused) this.changed();
  }

  drop(touch: number): void {
    if (this.ways.delete(touch)) this.changed();
  }

  clear(): void {
    this.ways.clear();
    this.changed();
  }

  /** Forgets what this frame answers. */
  observe(frame: StudioFrame): void {
    this.groups = frame.groups.map(({ id }) => id);
    this.ends = endsOf(frame, this.clientId());
    // A replay takes nothing from fingers.
    this.paused = !frame.playing && !frame.replaying;
    // A world that began anew knows nothing of them.
    if (frame.step < this.step) this.ways.clear();
    this.step = frame.step;
    for (const [touch, { points }] of this.ways) {
      while (points.length > 0 && points[0]!.time <= frame.touchEcho) points.shift();
      if (points.length === 0) this.ways.delete(touch);
    }
    this.changed();
  }

  changed(): void {
    const drafts = [...(this.paused ? this.drawn() : []), ...this.asked().map((control) => this.draftOf(control))];
    if (drafts.length === 0 && !this.shown) return;
    this.shown = drafts.length > 0;
    this.show(drafts);
  }

  private drawn(): DraftControl[] {
    return [...this.ways].map(([touch, way]) => {
      const points = way.points.map(({ at }) => at);
      const end = this.ends.get(touch);
      const group = this.groups.indexOf(way.group);
      return end
        ? { group, points: [end, ...points], closed: false, handles: [] }
        : { group, points, closed: false, handles: points.slice(0, 1) };
    });
  }

  private draftOf({ group, kind, fingers }: AskedControl): DraftControl {
    const handles = fingers.map(({ at }) => at);
    const closed = kind === ControlKind.Area;
    return { group: this.groups.indexOf(group), points: closed ? convexHull(handles) : handles, closed, handles };
  }
}

/** Touches are numbered by each client. */
function endsOf(frame: StudioFrame, client: number): Map<number, GroundPoint> {
  const own = frame.groups.flatMap((group) => group.controls.filter((control) => control.client === client));
  const points = own.flatMap((control) => control.points);
  return new Map(points.map(({ touch, x, y, path }) => {
    const [lastX = x, lastY = y] = path.slice(-2);
    return [touch, { x: lastX, y: lastY }];
  }));
}
