import { beforeEach, expect, it } from 'vitest';
import { CameraGesture, OrbitGesture } from './camera_gesture';
import { ControlDrag } from './drawn_controls';
import { CrowdKeys } from './crowd_keys';
import { FormationHitTest } from './formation_hit_test';
import { grabAt } from './grab';
import { VirtualControls } from './virtual_controls';
import { FakeClient, FakeScene, contactAt, controlFrame, frameWith, noOrders, onScreen } from './test_support';
import { ToolChooser } from './tool_chooser';
import { TouchEditor } from './touch_editor';
import { TouchSender } from './touch_sender';
import type { CameraControls } from '../scene/camera/camera_controls';

const noCamera = {} as CameraControls;
let client: FakeClient;
let scene: FakeScene;
let controls: VirtualControls;
let keys: CrowdKeys;

/** Two points of ours, at (1, 1) and (6, 1); the second is the newer. */
function twoPoints() {
  const older = controlFrame(3, 0, [{ x: 1, y: 1 }], { pinned: true });
  const newer = controlFrame(4, 0, [{ x: 6, y: 1 }]);
  newer.points[0]!.touch = 20;
  newer.points[0]!.down = true;
  return frameWith(1, [older, newer]);
}

function observe(frame: ReturnType<typeof frameWith>, chooser: ToolChooser): void {
  chooser.observe(frame);
  keys.observe(frame);
  controls.observe(frame);
}

let chooser: ToolChooser;

beforeEach(() => {
  client = new FakeClient();
  scene = new FakeScene();
  const touches = new TouchSender(client);
  controls = new VirtualControls(client, touches, () => 1);
  const camera = new CameraGesture(noCamera);
  const orbit = new OrbitGesture(noCamera);
  const editor = new TouchEditor(touches, scene);
  chooser = new ToolChooser({
    shapes: () => null,
    tell: () => undefined,
    scene,
    hitTest: new FormationHitTest(),
    editor,
    camera,
    orbit,
    controls,
    orders: noOrders(),
  });
  const world = {
    camera: noCamera,
    screenToWorld: ({ x, y }: { x: number; y: number }) => ({ x: x / 100, y: y / 100 }),
  };
  keys = new CrowdKeys(
    world,
    controls,
    chooser,
    () => ({ x: 0, y: 0 }),
    () => undefined,
  );
  observe(twoPoints(), chooser);
});

function mouse(type: string, x: number, y: number, buttons = 0): void {
  keys.pointed({ type, pointerType: 'mouse', buttons, clientX: 100 * x, clientY: 100 * y });
}

const removed = () =>
  client.commands().flatMap((one) => (one.kind === 'editControl' && one.edit === 'remove' ? [one.control] : []));

it('removes what lies under the mouse', () => {
  mouse('pointermove', 1.1, 1);
  keys.removeControl();
  expect(removed()).toEqual([3]);
});

it('acts on our newest control where nothing lies under the mouse, or it left the scene', () => {
  mouse('pointermove', 9, 9);
  keys.removeControl();
  mouse('pointermove', 1, 1);
  mouse('pointerleave', 1, 1);
  keys.removeControl();
  expect(removed()).toEqual([4, 4]);
});

it('acts on what the mouse has in hand, not on what lay where it began', () => {
  // A finger of the mouse: its control is the newest.
  mouse('pointerdown', 1, 1, 1);
  mouse('pointermove', 1, 1, 1);
  keys.togglePin();
  expect(client.commands()).toEqual([{ kind: 'editControl', group: 5, control: 4, edit: 'pin' }]);
});

it('acts on a control that is dragged, though another is newer', () => {
  const older = controlFrame(3, 1, [
    { x: 1, y: 1 },
    { x: 3, y: 1 },
  ]);
  const made = controls.create({ group: 5, kind: 1, positions: older.points, time: 1, keep: true, pinned: false });
  older.points.forEach((point, i) => (point.touch = made.fingers[i]!.touch));
  const frame = frameWith(2, [older, twoPoints().groups[0]!.controls[1]!]);
  observe(frame, chooser);
  const drag = new ControlDrag(
    grabAt(frame.groups, { x: 1, y: 1 }, onScreen, () => 'whole')!,
    controls,
    scene,
  );
  mouse('pointerdown', 1, 1, 1);
  drag.begin(contactAt(1, 1));
  keys.removeControl();
  expect(removed()).toEqual([3]);
});
