// The characters as shown just now: positions between frames, smoothed headings, gait and pose.

import { mix, mixAngle } from './blend';
import type { FrameBlend } from './frame_timeline';
import type { Numbers } from './frame_types';

/** How a body is held, per motion. */
export interface Pose {
  /** 0 upright to 1 lying. */
  readonly prone: number;
  /** 0 straight legs to 1 squatting. */
  readonly crouch: number;
  /** Feet above the ground [m]; negative in water. */
  readonly lift: number;
  /** 0 arms swing to 1 arms reach overhead. */
  readonly reach: number;
}

const kUpright: Pose = { prone: 0, crouch: 0, lift: 0, reach: 0 };
const kPoses: Readonly<Record<string, Pose>> = {
  duck: { prone: 0.38, crouch: 0.75, lift: 0, reach: 0 },
  crawl: { prone: 0.95, crouch: 1, lift: 0, reach: 0.25 },
  swim: { prone: 1, crouch: 0, lift: -0.8, reach: 1 },
  jump: { prone: 0.05, crouch: 0.45, lift: 0.55, reach: 0.35 },
  climb: { prone: 0.1, crouch: 0.3, lift: 0.9, reach: 0.8 },
};

/** The pose of a clip by its name; run, walk, idle and unknown ones are upright. */
export function poseOf(clip: string): Pose {
  return kPoses[clip] ?? kUpright;
}

/** Ground covered by one whole gait cycle [m]. */
const kStride = 1.5;
/** Speed at which limbs swing fully [m/s]. */
const kFullGait = 1.2;

/** How far this display frame goes towards what is wanted. */
interface Step {
  /** [s] */
  readonly dt: number;
  readonly first: boolean;
  readonly turn: number;
  readonly gait: number;
  readonly pose: number;
}

export class CrowdState {
  count = 0;
  ids = new Uint32Array(0);
  group = new Uint8Array(0);
  /** x, y, heading, gait phase per character. */
  placement = new Float32Array(0);
  /** Gait, prone, crouch, lift per character. */
  pose = new Float32Array(0);
  reach = new Float32Array(0);
  private poses_: readonly Pose[] = [];
  private started_ = false;

  /** The names of clips, by motion id. */
  setClips(names: readonly string[]): void {
    this.poses_ = names.map(poseOf);
  }

  clear(): void {
    this.setMembers([], []);
  }

  /** Takes the list of who is there; call when a frame brings one. */
  setMembers(ids: Numbers, group: Numbers): void {
    this.count = ids.length;
    this.ids = Uint32Array.from(ids);
    this.group = Uint8Array.from(group);
    this.placement = new Float32Array(4 * this.count);
    this.pose = new Float32Array(4 * this.count);
    this.reach = new Float32Array(this.count);
    for (let i = 0; i < this.count; ++i) this.placement[4 * i + 3] = ((this.ids[i] ?? 0) * 2.399963) % (2 * Math.PI);
    this.started_ = false;
  }

  /** Moves everyone to a moment between two frames, `dt` [s] of display time after the last call. */
  update(blend: FrameBlend, dt: number): void {
    const { from, to, alpha } = blend;
    const count = Math.min(this.count, to.x.length);
    const whole = from.x.length !== to.x.length ? 1 : alpha;
    const first = !this.started_;
    const step: Step = {
      dt, first, turn: first ? 1 : 1 - Math.exp(-10 * dt), gait: 1 - Math.exp(-6 * dt), pose: first ? 1 : 1 - Math.exp(-7 * dt),
    };
    for (let i = 0; i < count; ++i) {
      const bx = to.x[i] ?? 0;
      const by = to.y[i] ?? 0;
      const x = whole === 1 ? bx : mix(from.x[i] ?? bx, bx, whole);
      const y = whole === 1 ? by : mix(from.y[i] ?? by, by, whole);
      this.place(i, x, y, to.heading[i] ?? 0, step);
      this.hold(i, this.poses_[to.motion[i] ?? 0] ?? kUpright, step.pose);
    }
    this.started_ = count > 0;
  }

  private place(i: number, x: number, y: number, heading: number, step: Step): void {
    const p = this.placement;
    const at = 4 * i;
    const dx = x - (p[at] ?? x);
    const dy = y - (p[at + 1] ?? y);
    const walked = step.first ? 0 : Math.sqrt(dx * dx + dy * dy);
    p[at] = x;
    p[at + 1] = y;
    p[at + 2] = step.first ? heading : mixAngle(p[at + 2] ?? 0, heading, step.turn);
    // A jump in place (restart) is no walk.
    if (walked < 1) p[at + 3] = ((p[at + 3] ?? 0) + (walked / kStride) * 2 * Math.PI) % (2 * Math.PI);
    const speed = step.dt > 0 && walked < 1 ? walked / step.dt : 0;
    const before = this.pose[at] ?? 0;
    this.pose[at] = before + (Math.min(1, speed / kFullGait) - before) * step.gait;
  }

  private hold(i: number, pose: Pose, follow: number): void {
    const p = this.pose;
    const at = 4 * i;
    p[at + 1] = mix(p[at + 1] ?? 0, pose.prone, follow);
    p[at + 2] = mix(p[at + 2] ?? 0, pose.crouch, follow);
    p[at + 3] = mix(p[at + 3] ?? 0, pose.lift, follow);
    this.reach[i] = mix(this.reach[i] ?? 0, pose.reach, follow);
  }
}
