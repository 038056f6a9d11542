// Where the camera looks: at all that happens in a file, or at the crowd as it goes.

import type { LoadedCrowd } from '../file/loaded_crowd';
import { Extent, type Aim, type ViewCamera } from './view_camera';

/** Between two moments at which the crowd is looked at [s]. */
const kEvery = 0.5;
/** The camera follows as smoothly as a bell of this width [s]. */
const kSmooth = 1.2;
const kReach = 3 * kSmooth;
/** It keeps away, so that there is room round the crowd: farther than needed, and at least so far [m]. */
const kRoom = 1.5;
const kLeast = 30;

function extentOf({ head, crowd }: LoadedCrowd, from: number, to: number): Extent {
  const extent = new Extent();
  for (let k = crowd.first[from]!; k < crowd.first[Math.min(to, head.frames)]!; ++k)
    extent.add(crowd.x[k]!, crowd.y[k]!);
  return extent;
}

function middle({ head }: LoadedCrowd): Aim {
  const [left, near, right, far] = head.box;
  return { x: (left + right) / 2, y: (near + far) / 2, distance: 2 * Math.max(right - left, far - near) };
}

const kWhole = new WeakMap<LoadedCrowd, Extent>();

/** Where to look to see all that happens. */
export function wholeAim(loaded: LoadedCrowd, camera: ViewCamera): Aim {
  const extent = kWhole.get(loaded) ?? extentOf(loaded, 0, loaded.head.frames);
  kWhole.set(loaded, extent);
  return camera.fit(extent) ?? middle(loaded);
}

/** Where to look to see the crowd at each time. */
export class Follower {
  private readonly aims_: readonly Aim[];

  constructor(loaded: LoadedCrowd, camera: ViewCamera) {
    const { head, duration } = loaded;
    const count = Math.max(1, Math.ceil(duration / kEvery) + 1);
    let last = wholeAim(loaded, camera);
    const roomy = (aim: Aim): Aim => ({ ...aim, distance: Math.max(kLeast, kRoom * aim.distance) });
    this.aims_ = Array.from({ length: count }, (_, k) => {
      const frame = Math.min(head.frames - 1, Math.round(k * kEvery * head.fps));
      last = camera.fit(extentOf(loaded, frame, frame + 1)) ?? last;
      return roomy(last);
    });
  }

  at(time: number): Aim {
    let [weight, x, y, distance] = [0, 0, 0, 0];
    const [from, to] = [Math.floor((time - kReach) / kEvery), Math.ceil((time + kReach) / kEvery)];
    for (let k = from; k <= to; ++k) {
      const aim = this.aims_[Math.min(this.aims_.length - 1, Math.max(0, k))]!;
      const bell = Math.exp(-(((k * kEvery - time) / kSmooth) ** 2));
      weight += bell;
      x += bell * aim.x;
      y += bell * aim.y;
      distance += bell * Math.log(aim.distance);
    }
    return { x: x / weight, y: y / weight, distance: Math.exp(distance / weight) };
  }
}
