// What fingers draw that no frame of the server shows yet. No frame answers them while the world is paused: drafts show
// what they have drawn until the next step takes it.

import { convexHull, type GroundPoint } from '../model/plane';
import { ControlKind } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import type { DraftControl } from '../scene/marks/draft_control';

/** Receives the touches that tools send. */
export interface DraftBook {
  /** The finger of this touch is at `at`; `time` as sent. */
  add(touch: number, group: number, at: GroundPoint, time: number): void;
  /** Forgets what this touch has drawn. */
  drop(touch: number): void;
  /** A new control was requested or released. */
  changed(): void;
}

export const kNoDrafts: DraftBook = { add: () => undefined, drop: () => undefined, changed: () => undefined };

/** A new control that no frame shows yet. */
export interface PendingControl {
  readonly group: number;
  readonly kind: ControlKind;
  readonly fingers: readonly { readonly at: GroundPoint }[];
}

interface DrawnPath {
  readonly group: number;
  readonly points: { readonly at: GroundPoint; readonly time: number }[];
}

export class Drafts implements DraftBook {
  private readonly paths_ = new Map<number, DrawnPath>();
  private groups_: readonly number[] = [];
  /** Where the paths end that the last frame shows, by touch. */
  private ends_ = new Map<number, GroundPoint>();
  private paused_ = false;
  private shown_ = false;
  private step_ = 0;

  /** `show` hears of every change; `pending` returns the controls that wait for an answer. */
  constructor(
    private readonly show_: (drafts: readonly DraftControl[]) => void,
    private readonly pending_: () => readonly PendingControl[],
    private readonly clientId_: () => number,
  ) {}

  add(touch: number, group: number, at: GroundPoint, time: number): void {
    const path = this.paths_.get(touch) ?? { group, points: [] };
    path.points.push({ at, time });
    this.paths_.set(touch, path);
    if (this.paused_) this.changed();
  }

  drop(touch: number): void {
    if (this.paths_.delete(touch)) this.changed();
  }

  clear(): void {
    this.paths_.clear();
    this.changed();
  }

  /** Forgets what this frame answers. */
  observe(frame: StudioFrame): void {
    this.groups_ = frame.groups.map(({ id }) => id);
    this.ends_ = endsOf(frame, this.clientId_());
    // A replay ignores fingers.
    this.paused_ = !frame.playing && !frame.replaying;
    // A world that began anew has no touches.
    if (frame.step < this.step_) this.paths_.clear();
    this.step_ = frame.step;
    for (const [touch, { points }] of this.paths_) {
      while (points.length > 0 && points[0]!.time <= frame.touchEcho) points.shift();
      if (points.length === 0) this.paths_.delete(touch);
    }
    this.changed();
  }

  changed(): void {
    const drafts = [...(this.paused_ ? this.drawn() : []), ...this.pending_().map((control) => this.draftOf(control))];
    if (drafts.length === 0 && !this.shown_) return;
    this.shown_ = drafts.length > 0;
    this.show_(drafts);
  }

  private drawn(): DraftControl[] {
    return [...this.paths_].map(([touch, path]) => {
      const points = path.points.map(({ at }) => at);
      const end = this.ends_.get(touch);
      const group = this.groups_.indexOf(path.group);
      return end
        ? { group, points: [end, ...points], closed: false, handles: [] }
        : { group, points, closed: false, handles: points.slice(0, 1) };
    });
  }

  private draftOf({ group, kind, fingers }: PendingControl): DraftControl {
    const handles = fingers.map(({ at }) => at);
    const closed = kind === ControlKind.Area;
    return { group: this.groups_.indexOf(group), points: closed ? convexHull(handles) : handles, closed, handles };
  }
}

/** Touches are numbered by each client. */
function endsOf(frame: StudioFrame, client: number): Map<number, GroundPoint> {
  const own = frame.groups.flatMap((group) => group.controls.filter((control) => control.client === client));
  const points = own.flatMap((control) => control.points);
  return new Map(
    points.map(({ touch, x, y, path }) => {
      const [lastX = x, lastY = y] = path.slice(-2);
      return [touch, { x: lastX, y: lastY }];
    }),
  );
}
