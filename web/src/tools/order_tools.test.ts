import { beforeEach, describe, expect, it } from 'vitest';
import type { ToolName } from '../model/studio_state';
import type { GroundPoint } from '../model/plane';
import type { CameraControls } from '../scene/camera/camera_controls';
import { CameraGesture } from './camera_gesture';
import type { Contact, ContactOwner } from './contact';
import { OrderChooser } from './order_chooser';
import { contactAt, FakeController } from './test_support';

let orders: FakeController;
let tool: ToolName;
let panned: number;
let chooser: OrderChooser;

/** Nine in ranks of three, a metre apart, that face x. */
const ranks = [1, 0, -1].flatMap((x) => [1, 0, -1].map((y) => ({ x, y })));

beforeEach(() => {
  orders = new FakeController();
  orders.ordered = [
    { id: 7, index: 0, at: { x: 0, y: 0 }, facing: 0, shape: { formation: 'square', spacing: 1, places: ranks } },
  ];
  tool = 'order';
  panned = 0;
  const camera = new CameraGesture({
    pan: () => (panned += 1),
    pinch: () => (panned += 1),
  } as unknown as CameraControls);
  chooser = new OrderChooser({ orders, camera, tool: () => tool, toGround: (at) => at });
});

function begin(at: GroundPoint, more: Partial<Contact> = {}, over = -1): ContactOwner {
  const contact = contactAt(at.x, at.y, more);
  const owner = chooser.choose(contact, over)!;
  owner.begin(contact);
  return owner;
}

function drag(points: readonly GroundPoint[], more: Partial<Contact> = {}, over = -1): void {
  const owner = begin(points[0]!, more, over);
  owner.move(points.map(({ x, y }) => contactAt(x, y, more)));
  const last = points[points.length - 1]!;
  owner.end(contactAt(last.x, last.y, more), false);
}

describe('orders', () => {
  it('a press goes there, a drag is the front: its middle, width and facing', () => {
    drag([{ x: 5, y: 5 }]);
    expect(orders.moves[0]).toMatchObject({ group: 7, target: { x: 5, y: 5 }, facing: null, width: 0 });
    drag([
      { x: 0, y: 10 },
      { x: 4, y: 10 },
    ]);
    const [line] = orders.moves;
    expect(line!.width).toBeCloseTo(4);
    expect(line!.facing).toBeCloseTo(Math.PI / 2);
    // Nine at 1 m in a front of 4 m: five and four, the front rank on the line.
    expect(line!.places.filter(({ y }) => Math.abs(y - 10) < 1e-9)).toHaveLength(5);
    expect(line!.places.filter(({ y }) => Math.abs(y - 9) < 1e-9)).toHaveLength(4);
  });

  it('shows the places before it is let go, and none afterwards or when it is dropped', () => {
    const owner = begin({ x: 0, y: 10 });
    owner.move([contactAt(6, 10)]);
    expect(orders.shown!.moves[0]!.places).toHaveLength(9);
    chooser.abort();
    expect(orders.shown).toBeNull();
    owner.end(contactAt(6, 10), false);
    expect(orders.did).toEqual([]);
  });

  it('passes the keys on: Shift queues, Alt frees', () => {
    drag([{ x: 5, y: 5 }], { kind: 'mouse', button: 2, shift: true });
    drag([{ x: 5, y: 5 }], { kind: 'mouse', button: 2, alt: true });
    expect(orders.did).toEqual(['move queued', 'move free']);
  });

  it('the right button orders with any tool, others only with a tool for it', () => {
    tool = 'steer';
    expect(chooser.choose(contactAt(5, 5), -1)).toBeNull();
    expect(chooser.choose(contactAt(5, 5, { kind: 'mouse' }), -1)).toBeNull();
    drag([{ x: 5, y: 5 }], { kind: 'mouse', button: 2 });
    expect(orders.did).toEqual(['move']);
  });

  it('from a chosen formation a way is drawn: its points, a metre apart, and its end', () => {
    orders.chosenAt = ({ x }) => x < 1;
    const way = Array.from({ length: 41 }, (_, i) => ({ x: i / 4, y: i > 20 ? (i - 20) / 4 : 0 }));
    drag(way);
    const [move] = orders.moves;
    expect(move!.target).toEqual({ x: 10, y: 5 });
    for (let i = 1; i < move!.route.length; ++i) {
      const [a, b] = [move!.route[i - 1]!, move!.route[i]!];
      expect(Math.hypot(b.x - a.x, b.y - a.y)).toBeGreaterThanOrEqual(1);
      expect(Math.hypot(b.x - a.x, b.y - a.y)).toBeLessThan(1.3);
    }
  });

  it('a tap on another formation chooses it, a drag from it does not', () => {
    drag([{ x: 5, y: 5 }], {}, 3);
    drag(
      [
        { x: 5, y: 5 },
        { x: 9, y: 5 },
      ],
      {},
      3,
    );
    expect(orders.did).toEqual(['choose 3', 'move']);
  });

  it('guards a rectangle, and not a speck', () => {
    tool = 'leave';
    drag([{ x: 5, y: 5 }]);
    tool = 'wait';
    drag([{ x: 6, y: 5 }]);
    expect(orders.did.splice(0)).toEqual(['leave 5,5', 'wait 6,5']);
    tool = 'guard';
    drag([
      { x: 8, y: 3 },
      { x: 2, y: 7 },
    ]);
    drag([
      { x: 8, y: 3 },
      { x: 8.1, y: 3.1 },
    ]);
    expect(orders.did).toEqual(['guard 5,5 3,2']);
  });

  it('a second finger moves the camera, and nobody gets an order', () => {
    const first = begin({ x: 0, y: 10 });
    first.move([contactAt(2, 10)]);
    const second = chooser.choose(contactAt(4, 4, { pointer: 2 }), -1)!;
    second.begin(contactAt(4, 4, { pointer: 2 }));
    first.move([contactAt(3, 10)]);
    second.move([contactAt(5, 5, { pointer: 2 })]);
    first.end(contactAt(3, 10), false);
    expect(panned).toBe(2);
    expect(orders.did).toEqual([]);
    expect(orders.shown).toBeNull();
  });

  it('is dropped where the browser takes the finger away', () => {
    begin({ x: 0, y: 10 }).end(contactAt(8, 10), true);
    expect(orders.did).toEqual([]);
  });
});
