// Which marks are on screen and how old they are: handles grow in, bars and hulls fade in, what ended fades out.

import type { GroundPoint } from './camera_types';
import type { ControlView, GroupView } from './frame_types';

/** One control as it is drawn now. */
export interface ShownControl {
  readonly group: number;
  readonly control: ControlView;
  /** Where its handles are in the newest frame [m]. */
  readonly handles: readonly GroundPoint[];
  readonly born: number;
  /** When its kind last changed [ms]. */
  readonly kindSince: number;
  /** When it ended [ms]; 0 while it lives. */
  readonly ended: number;
}

export interface TouchRing {
  at: GroundPoint;
  group: number;
  since: number;
  /** When it lifted [ms]; 0 while down. */
  lifted: number;
}

const kFade = 160;
const kFadeReduced = 80;
/** A finger runs ahead of its path by no more than this [m]. */
const kFingerReach = 3;

export class ControlMarks {
  readonly rings = new Map<number, TouchRing>();
  private shown_ = new Map<string, ShownControl>();
  private reduced_ = false;

  set reducedMotion(reduced: boolean) {
    this.reduced_ = reduced;
  }

  /** How long things take to vanish [ms]. */
  get fade(): number {
    return this.reduced_ ? kFadeReduced : kFade;
  }

  get controls(): IterableIterator<ShownControl> {
    return this.shown_.values();
  }

  clear(): void {
    this.rings.clear();
    this.shown_.clear();
  }

  touch(id: number, at: GroundPoint | null, group: number, now: number): void {
    const ring = this.rings.get(id);
    if (!at) {
      if (ring && ring.lifted === 0) ring.lifted = now;
      return;
    }
    if (ring && ring.lifted === 0) {
      ring.at = at;
      ring.group = group;
    } else {
      this.rings.set(id, { at, group, since: now, lifted: 0 });
    }
  }

  /** Where the finger is that draws a path of this group ending at `end`: fingers and paths have numbers of their own. */
  fingerNear(group: number, end: GroundPoint): GroundPoint | null {
    let found: GroundPoint | null = null;
    let least = kFingerReach;
    for (const ring of this.rings.values()) {
      const away = Math.hypot(ring.at.x - end.x, ring.at.y - end.y);
      if (ring.lifted > 0 || ring.group !== group || away >= least) continue;
      least = away;
      found = ring.at;
    }
    return found;
  }

  /** Takes the controls of the newest frame: what is under a finger waits for no other. */
  update(groups: readonly GroupView[], now: number): void {
    for (const [id, ring] of this.rings) if (ring.lifted > 0 && now - ring.lifted > this.fade) this.rings.delete(id);
    const next = new Map<string, ShownControl>();
    groups.forEach((group, index) => {
      for (const control of group.controls) {
        const key = `${group.id}:${control.id}`;
        const old = this.shown_.get(key);
        const grown = old && old.control.kind !== control.kind;
        next.set(key, {
          group: index,
          control,
          handles: control.points.map(({ x, y }) => ({ x, y })),
          born: old && old.ended === 0 ? old.born : now,
          kindSince: !old || old.ended > 0 || grown ? now : old.kindSince,
          ended: 0,
        });
      }
    });
    for (const [key, old] of this.shown_) {
      if (next.has(key)) continue;
      const ended = old.ended === 0 ? now : old.ended;
      if (now - ended < this.fade) next.set(key, { ...old, ended });
    }
    this.shown_ = next;
  }

  /** 0 to 1 of an appearance that began at `since` and takes `duration` [ms]. */
  grown(since: number, now: number, duration: number): number {
    if (this.reduced_) return 1;
    return Math.min(1, Math.max(0, (now - since) / duration));
  }

  /** 1 while it lives, to 0 after its end. */
  left(ended: number, now: number): number {
    return ended === 0 ? 1 : Math.max(0, 1 - (now - ended) / this.fade);
  }
}
