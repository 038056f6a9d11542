import { beforeEach, describe, expect, it } from 'vitest';
import { TouchPhase, type GroupMesh } from '../protocol/messages';
import type { StudioFrame } from '../model/studio_frame';
import type { CameraControls } from '../scene/camera/camera_controls';
import { CameraGesture, OrbitGesture } from './camera_gesture';
import { OrderDrag } from './order_tools';
import { BoxSelect } from './box_select';
import { ControlDrag, Lasso, RubberBand } from './drawn_controls';
import { FormationHitTest } from './formation_hit_test';
import { VirtualControls } from './virtual_controls';
import { FakeClient, FakeScene, contactAt, controlFrame, frameWith, noOrders } from './test_support';
import { ToolChooser } from './tool_chooser';
import { TouchEditor } from './touch_editor';
import { TouchSender } from './touch_sender';

const noCamera = {} as CameraControls;
const camera = new CameraGesture(noCamera);
const orbit = new OrbitGesture(noCamera);
let client: FakeClient;
let chooser: ToolChooser;
let frame: StudioFrame;
const told: string[] = [];

beforeEach(() => {
  client = new FakeClient();
  const scene = new FakeScene();
  const touches = new TouchSender(client);
  const controls = new VirtualControls(client, touches, () => 1);
  const hitTest = new FormationHitTest();
  told.length = 0;
  const mesh = {
    type: 'GroupMesh',
    group: 5,
    version: 1,
    formation: 'square',
    triangles: new Uint32Array([0, 1, 2, 0, 2, 3]),
    boundary: new Uint32Array([4, 0, 1, 2, 3]),
  };
  hitTest.setMesh(mesh as GroupMesh);
  frame = frameWith(1, [controlFrame(3, 0, [{ x: 1, y: 1 }], { pinned: true })]);
  frame.groups[0]!.vertices = new Float32Array([0, 0, 4, 0, 4, 4, 0, 4]);
  hitTest.setGroups(frame.groups);
  chooser = new ToolChooser({
    shapes: () => null,
    tell: (text) => told.push(text),
    scene,
    hitTest,
    editor: new TouchEditor(touches, scene),
    camera,
    orbit,
    controls,
    orders: noOrders(),
  });
  chooser.observe(frame);
});

/** A finger comes down, and its owner. */
function press(x: number, y: number, pointer: number, time: number): void {
  const contact = contactAt(x, y, { pointer, time });
  chooser.choose(contact).begin(contact);
}

describe('ToolChooser', () => {
  it('makes new fingers of those that come down together where an earlier control is left', () => {
    const left = controlFrame(7, 0, [{ x: 3, y: 3 }]);
    const frame = frameWith(2, [left]);
    frame.groups[0]!.vertices = new Float32Array([0, 0, 4, 0, 4, 4, 0, 4]);
    chooser.observe(frame);
    press(3, 3, 1, 10);
    expect(client.types()).toEqual(['editControl', 'control']);
    press(1, 3, 2, 10.05);
    press(3, 1, 3, 10.1);
    const [lifted, ...fresh] = client.touches();
    expect(lifted!.phase).toBe(TouchPhase.Up);
    expect(fresh.map(({ phase, x, y, time }) => [phase, x, y, time])).toEqual([
      [TouchPhase.Down, 3, 3, 10],
      [TouchPhase.Down, 1, 3, 10.05],
      [TouchPhase.Down, 3, 1, 10.1],
    ]);
  });
  it('lets a finger that comes alone, or much later, drag what is left', () => {
    const frame = frameWith(2, [controlFrame(7, 0, [{ x: 3, y: 3 }])]);
    frame.groups[0]!.vertices = new Float32Array([0, 0, 4, 0, 4, 4, 0, 4]);
    chooser.observe(frame);
    press(1, 1, 1, 10);
    press(3, 3, 2, 10.5);
    expect(client.types()).toEqual(['Touches', 'editControl', 'control']);
  });
  it('lets fingers and pens edit on the formation and move the camera beside it', () => {
    for (const kind of ['touch', 'pen'] as const) {
      const owner = chooser.choose(contactAt(2, 3, { kind }));
      owner.begin(contactAt(2, 3, { kind }));
      expect(client.types()).toContain('Touches');
      expect(chooser.choose(contactAt(8, 8, { kind }))).toBe(camera);
    }
  });
  it('counts a rim within a fingertip as the formation', () => {
    expect(chooser.choose(contactAt(4.25, 2))).not.toBe(camera);
    expect(chooser.choose(contactAt(4.5, 2))).toBe(camera);
  });
  it('takes a pinned control up again', () => {
    expect(chooser.choose(contactAt(1.1, 1))).toBeInstanceOf(ControlDrag);
  });
  it('draws with Shift and Alt, but not with fingers', () => {
    expect(chooser.choose(contactAt(2, 3, { kind: 'mouse', shift: true }))).toBeInstanceOf(RubberBand);
    expect(chooser.choose(contactAt(6, 3, { kind: 'mouse', shift: true }))).toBeInstanceOf(RubberBand);
    expect(chooser.choose(contactAt(9, 3, { kind: 'mouse', shift: true }))).toBeInstanceOf(BoxSelect);
    expect(chooser.choose(contactAt(9, 9, { kind: 'mouse', alt: true }))).toBeInstanceOf(Lasso);
    expect(chooser.choose(contactAt(2, 3, { alt: true }))).not.toBeInstanceOf(Lasso);
  });
  it('holds a point of the mesh with each corner of a loop, and says where there are too few', () => {
    const loop = (reach: number): void => {
      const contacts = Array.from({ length: 24 }, (_, i) =>
        contactAt(2 + reach * Math.cos(i / 3.8), 2 + reach * Math.sin(i / 3.8), { kind: 'mouse', alt: true }),
      );
      const lasso = chooser.choose(contacts[0]!);
      for (const contact of contacts) lasso.begin(contact);
      lasso.end(contacts[0]!, false);
    };
    chooser.observe({ ...frame, groups: [{ ...frame.groups[0]!, vertices: new Float32Array([0, 0, 4, 0]) }] });
    loop(2);
    expect(client.sent).toEqual([]);
    expect(told.join()).toMatch(/fewer than three points/);
    chooser.observe(frame);
    loop(2.5);
    const [made] = client.commands();
    expect(made?.kind === 'control' && made.touches?.length).toBe(4);
    expect(told.length).toBe(1);
  });
  it('gives buttons and Space to the camera, wherever they press', () => {
    expect(chooser.choose(contactAt(2, 2, { kind: 'mouse', button: 1 }))).toBe(orbit);
    expect(chooser.choose(contactAt(2, 2, { kind: 'mouse', button: 2 }))).toBeInstanceOf(OrderDrag);
    chooser.panning = true;
    expect(chooser.choose(contactAt(2, 2, { kind: 'mouse', button: 2 }))).toBe(orbit);
    expect(chooser.choose(contactAt(2, 2, { kind: 'mouse' }))).toBe(camera);
  });
  it('moves the camera from above the horizon', () => {
    expect(chooser.choose(contactAt(2, 2, { ground: null }))).toBe(camera);
  });
});
