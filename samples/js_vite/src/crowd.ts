// The crowd: a world, orders to it, and steps as time passes.

import { CommandKind, FormationKind, loadMuster, Manner, type Muster, type Vec2, type World } from 'muster-engine';

const kStep = 1 / 60;
/** Where drawing is slow, the crowd slows down as well, and does not get stuck in steps. */
const kMostStepsAtOnce = 4;

export const kBox = { min: { x: -24, y: -16 }, max: { x: 24, y: 16 } };
export const kPillars = [
  { centre: { x: 0, y: 6 }, radius: 2.5 },
  { centre: { x: 1, y: -6 }, radius: 3 },
  { centre: { x: -9, y: 1 }, radius: 1.5 },
];

export class Crowd {
  readonly world: World;
  private readonly group_: number;
  private sent_ = 0;
  private due_ = 0;

  private constructor(private readonly muster_: Muster) {
    this.world = muster_.World.create({
      box: kBox,
      obstacles: kPillars,
      groups: [
        {
          count: 100,
          position: { x: -16, y: 0 },
          formation: { kind: FormationKind.Square, spacing: 1 },
        },
      ],
    });
    this.group_ = this.world.group(0).id;
  }

  static async make(): Promise<Crowd> {
    return new Crowd(await loadMuster());
  }

  /** Sends the crowd to a point, or, where two are given, to the front between them, as seen from behind. */
  send(left: Vec2, right: Vec2): void {
    const wide = Math.hypot(right.x - left.x, right.y - left.y) > 1;
    const order = {
      ...(wide ? this.muster_.orderToLine(left, right) : { target: left }),
      manner: Manner.Free,
    };
    const step = this.world.stepCount();
    this.world.submit({
      kind: CommandKind.GiveOrder,
      step,
      client: 1,
      sequence: this.sent_++,
      body: { group: this.group_, order },
    });
  }

  /** Lets time pass [s]. */
  advance(seconds: number): void {
    this.due_ = Math.min(this.due_ + seconds, kMostStepsAtOnce * kStep);
    for (; this.due_ >= kStep; this.due_ -= kStep) this.world.step();
  }

  centre(): Vec2 {
    const { position, count } = this.world.characters();
    let [x, y] = [0, 0];
    for (let k = 0; k < count; k += 1) [x, y] = [x + position[2 * k]! / count, y + position[2 * k + 1]! / count];
    return { x, y };
  }
}
