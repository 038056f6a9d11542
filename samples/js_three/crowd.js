// Two companies, orders to the blue one, and steps as time passes. Positions are drawn between the last two steps, so that
// movement is even on displays of any rate.
import { CommandKind, FormationKind, loadMuster } from 'muster-engine';

const kStep = 1 / 60;
const kMostStepsAtOnce = 4;

export const kHouses = [
  { x: 0, y: 9, width: 10, depth: 6, height: 5 },
  { x: 0, y: -9, width: 10, depth: 6, height: 4 },
];

const cornersOf = ({ x, y, width, depth }) => [
  { x: x - width / 2, y: y - depth / 2 },
  { x: x + width / 2, y: y - depth / 2 },
  { x: x + width / 2, y: y + depth / 2 },
  { x: x - width / 2, y: y + depth / 2 },
];

export class Crowd {
  static async make() {
    return new Crowd(await loadMuster());
  }

  constructor(muster) {
    this.world = muster.World.create({
      box: { min: { x: -40, y: -24 }, max: { x: 40, y: 24 } },
      obstacles: kHouses.map((house) => ({
        polygon: { points: cornersOf(house) },
        height: house.height,
      })),
      groups: [
        {
          name: 'blue',
          count: 150,
          position: { x: -20, y: 0 },
          formation: { kind: FormationKind.Wedge, spacing: 1.1 },
        },
        {
          name: 'red',
          count: 100,
          position: { x: 22, y: 0 },
          angle: Math.PI,
          formation: { kind: FormationKind.Ring, spacing: 1.1 },
        },
      ],
    });
    const { count, group, position } = this.world.characters();
    this.count = count;
    this.groups = group.slice();
    this.before = position.slice();
    this.due = 0;
    this.sent = 0;
  }

  /** Sends the blue company to a point. */
  send(target) {
    const body = { group: this.world.group(0).id, order: { target } };
    this.world.submit({
      kind: CommandKind.GiveOrder,
      step: this.world.stepCount(),
      client: 1,
      sequence: this.sent++,
      body,
    });
  }

  /** Lets time pass [s]; the share of the next step that has passed already. */
  advance(seconds) {
    this.due = Math.min(this.due + seconds, kMostStepsAtOnce * kStep);
    for (; this.due >= kStep; this.due -= kStep) {
      this.before.set(this.world.characters().position);
      this.world.step();
    }
    return this.due / kStep;
  }
}
