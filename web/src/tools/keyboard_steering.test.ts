import { beforeEach, describe, expect, it } from 'vitest';
import { TouchPhase } from '../protocol/messages';
import { groundAxes } from './ground_axes';
import { VirtualControls } from './virtual_controls';
import { KeyboardSteering, innerCorners } from './keyboard_steering';
import { FakeClient } from './test_support';
import { TouchSender } from './touch_sender';

const square = [
  { x: 0, y: 0 },
  { x: 10, y: 0 },
  { x: 10, y: 10 },
  { x: 0, y: 10 },
];
const axes = { right: { x: 1, y: 0 }, up: { x: 0, y: 1 } };
let client: FakeClient;
let touches: TouchSender;
let steering: KeyboardSteering;

beforeEach(() => {
  client = new FakeClient();
  touches = new TouchSender(client);
  steering = new KeyboardSteering(new VirtualControls(client, touches, () => 1));
});

describe('KeyboardSteering', () => {
  it('grabs the inner part as an area, carries and drops it', () => {
    expect(steering.grab(5, square, 1)).toBe(true);
    expect(client.commands()[0]).toMatchObject({ kind: 'control', control: 'area' });
    steering.move('ArrowUp', false, axes, 2);
    steering.move('ArrowLeft', true, axes, 3);
    touches.flush();
    const last = client.touches().slice(-4);
    expect(last[0]).toMatchObject({ x: 2 - 2, y: 2 + 0.5 });
    steering.drop(4);
    expect(
      client
        .touches()
        .slice(-4)
        .every((event) => event.phase === TouchPhase.Up),
    ).toBe(true);
    expect(steering.active).toBe(false);
  });
  it('does nothing without a mesh or twice', () => {
    expect(steering.grab(5, [], 1)).toBe(false);
    expect(steering.grab(5, square, 1)).toBe(true);
    expect(steering.grab(5, square, 1)).toBe(false);
    expect(client.sent).toHaveLength(1);
  });
});

it('innerCorners lie well inside the hull', () => {
  expect(innerCorners(square)).toEqual([
    { x: 2, y: 2 },
    { x: 8, y: 2 },
    { x: 8, y: 8 },
    { x: 2, y: 8 },
  ]);
});

it('groundAxes follow the camera', () => {
  const turned = groundAxes((at) => ({ x: at.y, y: at.x }), { x: 0, y: 0 });
  expect(turned.right).toEqual({ x: 0, y: 1 });
  expect(turned.up).toEqual({ x: -1, y: 0 });
  expect(groundAxes(() => null, { x: 0, y: 0 }).right).toEqual({ x: 1, y: 0 });
});
