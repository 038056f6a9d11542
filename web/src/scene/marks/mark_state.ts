// The marks on the screen and their age: handles grow in, bars and hulls fade in, ended marks fade out.

import type { DirectorInfo } from '../../model/directors';
import type { ControlView, GroupView } from '../../model/frame_view';
import type { GroundPoint } from '../../model/plane';

/** One control as it is drawn now. */
export interface ShownControl {
  readonly group: number;
  readonly control: ControlView;
  /** Where its handles are in the newest frame [m]. */
  readonly handles: readonly GroundPoint[];
  readonly born: number;
  /** Time of the last change of its kind [ms]. */
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

export class MarkState {
  /** By touch, where the ring is a finger's that draws. */
  readonly rings = new Map<number, TouchRing>();
  /** Fingers of other clients, by client and touch, at the position that the server last received. */
  readonly others = new Map<string, TouchRing>();
  /** Names and colours, by client. */
  directors: ReadonlyMap<number, Pick<DirectorInfo, 'name' | 'colour'>> = new Map();
  /** Our number at the server. Our own rings are drawn before the server receives them. */
  client = 0;
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
    this.others.clear();
    this.shown_.clear();
  }

  touch(id: number, at: GroundPoint | null, group: number, now: number): void {
    const ring = this.rings.get(id);
    if (at) putRing(this.rings, id, at, group, now);
    else if (ring && ring.lifted === 0) ring.lifted = now;
  }

  /** Where the finger of this touch is now; null where it is another client's, or lifted. */
  fingerOf(client: number, touch: number): GroundPoint | null {
    const ring = client === this.client ? this.rings.get(touch) : undefined;
    return ring && ring.lifted === 0 ? ring.at : null;
  }

  /** Takes the controls of the newest frame. They are not interpolated, as they follow fingers. */
  update(groups: readonly GroupView[], now: number): void {
    this.forgetLifted(this.rings, now);
    this.followOthers(groups, now);
    this.forgetLifted(this.others, now);
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

  private forgetLifted<Key>(rings: Map<Key, TouchRing>, now: number): void {
    for (const [key, ring] of rings) if (ring.lifted > 0 && now - ring.lifted > this.fade) rings.delete(key);
  }

  private followOthers(groups: readonly GroupView[], now: number): void {
    const down = new Set<string>();
    groups.forEach((group, index) => {
      for (const control of group.controls) {
        if (control.client === this.client) continue;
        for (const point of control.points) {
          if (!point.down) continue;
          const key = `${control.client}:${point.touch}`;
          down.add(key);
          putRing(this.others, key, fingerOf(point), index, now);
        }
      }
    });
    for (const [key, ring] of this.others) if (ring.lifted === 0 && !down.has(key)) ring.lifted = now;
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

/** A ring moves with its finger; one whose finger had lifted begins anew. */
function putRing<Key>(rings: Map<Key, TouchRing>, key: Key, at: GroundPoint, group: number, now: number): void {
  const ring = rings.get(key);
  if (ring && ring.lifted === 0) {
    ring.at = at;
    ring.group = group;
  } else {
    rings.set(key, { at, group, since: now, lifted: 0 });
  }
}

/** Where the finger that holds a point is: at the end of what it drew. */
function fingerOf({ x, y, path }: ControlView['points'][number]): GroundPoint {
  const end = path.length - 2;
  return end < 0 ? { x, y } : { x: path[end] ?? x, y: path[end + 1] ?? y };
}
