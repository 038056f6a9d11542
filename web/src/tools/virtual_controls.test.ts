import { beforeEach, describe, expect, it } from 'vitest';
import { TouchPhase } from '../protocol/messages';
import { ControlDrag, Lasso, RubberBand } from './drawn_controls';
import { grabAt } from './grab';
import { VirtualControls } from './virtual_controls';
import { FakeClient, FakeScene, contactAt, controlFrame, frameWith, onScreen } from './test_support';
import { TouchSender } from './touch_sender';

const target = { index: 0, group: 5 };
let client: FakeClient;
let scene: FakeScene;
let touches: TouchSender;
let controls: VirtualControls;

beforeEach(() => {
  client = new FakeClient();
  scene = new FakeScene();
  touches = new TouchSender(client);
  controls = new VirtualControls(client, touches, () => 1);
});

function drawLine(): void {
  const band = new RubberBand(target, controls, scene);
  band.begin(contactAt(0, 0));
  band.move([contactAt(4, 0)]);
  expect(scene.preview).toHaveLength(2);
  band.end(contactAt(4, 0, { time: 3 }), false);
}

/** The line as the server shows it, moved by `x`. */
function shownLine(x = 0, pinned = false) {
  const control = controlFrame(
    8,
    1,
    [
      { x, y: 0 },
      { x: x + 4, y: 0 },
    ],
    { pinned },
  );
  control.points.forEach((point) => (point.down = true));
  return control;
}

describe('RubberBand', () => {
  it('makes a line of two held touches', () => {
    drawLine();
    expect(scene.preview).toBeNull();
    expect(client.commands()).toMatchObject([{ kind: 'control', group: 5, control: 'line', touches: [1, 2], time: 3 }]);
    const [made] = client.commands();
    expect(made?.kind === 'control' && made.positions?.map(([x]) => x)).toEqual([0, 4]);
    expect(client.touches()).toEqual([]);
  });
  it('makes nothing of a click or a lost contact', () => {
    for (const [to, cancelled] of [
      [0.1, false],
      [4, true],
    ] as const) {
      const band = new RubberBand(target, controls, scene);
      band.begin(contactAt(0, 0));
      band.move([contactAt(to, 0)]);
      band.end(contactAt(to, 0), cancelled);
    }
    expect(client.sent).toEqual([]);
  });
});

describe('Lasso', () => {
  it('makes an area of three to six corners', () => {
    const lasso = new Lasso((corners) => ({ ...target, corners }), 0, controls, scene);
    lasso.begin(contactAt(3, 0));
    lasso.move(Array.from({ length: 40 }, (_, i) => contactAt(3 * Math.cos(i / 6.4), 3 * Math.sin(i / 6.4))));
    lasso.end(contactAt(3, 0), false);
    const [made] = client.commands();
    expect(made).toMatchObject({ kind: 'control', control: 'area' });
    expect(made?.kind === 'control' && made.touches?.length).toBeLessThanOrEqual(6);
  });
});

describe('HeldControls', () => {
  it('drags one end with its own touch, the bar with both', () => {
    drawLine();
    const frame = frameWith(1, [shownLine()]);
    controls.observe(frame);
    for (const [x, moved] of [
      [4, [2]],
      [2, [1, 2]],
    ] as const) {
      const grab = grabAt(frame.groups, { x, y: 0 }, onScreen, (control, group) => controls.grabbable(control, group))!;
      const drag = new ControlDrag(grab, controls, scene);
      drag.begin(contactAt(x, 0));
      drag.move([contactAt(x, 2, { time: 5 })]);
      drag.end(contactAt(x, 2));
      touches.flush();
      const moves = client.touches().filter((event) => event.phase === TouchPhase.Move);
      expect(moves.slice(-moved.length).map((event) => event.touch)).toEqual(moved);
      expect(moves[moves.length - 1]!.y).toBeGreaterThanOrEqual(2);
    }
    expect(controls.all).toHaveLength(1);
    expect(client.touches().every((event) => event.phase === TouchPhase.Move)).toBe(true);
  });

  it('takes a lifted pinned control up again: removes it, makes it anew and pins that', () => {
    const old = controlFrame(8, 0, [{ x: 1, y: 1 }], { pinned: true });
    const frame = frameWith(1, [old]);
    const grab = grabAt(frame.groups, { x: 1, y: 1 }, onScreen, (control, group) =>
      controls.grabbable(control, group),
    )!;
    const drag = new ControlDrag(grab, controls, scene);
    drag.begin(contactAt(1, 1));
    drag.move([contactAt(2, 1)]);
    drag.end(contactAt(2, 1));
    touches.flush();
    expect(client.types()).toEqual(['editControl', 'control', 'Touches']);
    const anew = controlFrame(9, 0, [{ x: 2, y: 1 }]);
    anew.points[0]!.down = true;
    controls.observe(frameWith(2, [anew]));
    expect(client.commands().at(-1)).toEqual({ kind: 'editControl', group: 5, control: 9, edit: 'pin' });
    expect(controls.all).toHaveLength(1);
  });

  it('leaves fingers alone that are really down', () => {
    const foreign = shownLine();
    expect(controls.grabbable(foreign, 5)).toBe('nothing');
  });

  it('lifts the fingers when a pinned one is let go', () => {
    drawLine();
    controls.observe(frameWith(1, [shownLine()]));
    controls.togglePin(5, shownLine(), 6);
    expect(controls.all).toHaveLength(1);
    controls.togglePin(5, shownLine(0, true), 7);
    expect(controls.all).toHaveLength(0);
    expect(client.touches().map((event) => event.phase)).toEqual([TouchPhase.Up, TouchPhase.Up]);
  });

  it('ends all of ours at once, pinned or held by real fingers, and lifts what no frame shows yet', () => {
    drawLine();
    controls.observe(frameWith(1, [shownLine(0, true)]));
    drawLine();
    const real = controlFrame(11, 0, [{ x: 7, y: 7 }]);
    real.points[0]!.touch = 90;
    const theirs = controlFrame(12, 0, [{ x: 9, y: 9 }], { client: 2 });
    client.sent.length = 0;
    controls.letGoAll(9, frameWith(2, [shownLine(0, true), real, theirs]));
    expect(client.touches().map(({ phase, touch }) => [phase, touch])).toEqual([
      [TouchPhase.Up, 3],
      [TouchPhase.Up, 4],
    ]);
    expect(client.commands()).toEqual([
      { kind: 'editControl', group: 5, control: 8, edit: 'remove' },
      { kind: 'editControl', group: 5, control: 11, edit: 'remove' },
    ]);
    expect(controls.all).toHaveLength(0);
  });

  it('tells controls of one number in two groups apart', () => {
    // Controls are numbered within a group: 8 is there twice.
    const frame = frameWith(1, [controlFrame(8, 0, [{ x: 1, y: 1 }])]);
    controls.take(
      grabAt(frame.groups, { x: 1, y: 1 }, onScreen, () => 'whole')!,
      1,
    );
    const other = controlFrame(8, 0, [{ x: 3, y: 3 }], { client: 2 });
    other.points[0]!.down = true;
    expect(controls.grabbable(other, 6)).toBe('nothing');
    expect(controls.grabbable(other, 5)).toBe('whole');
    expect(controls.all).toHaveLength(1);
    controls.remove(6, other);
    expect(controls.all).toHaveLength(1);
  });

  it('moves the finger of the point that was grabbed, also where the server dropped another', () => {
    drawLine();
    const rest = shownLine();
    rest.points.shift();
    const frame = frameWith(1, [rest]);
    controls.observe(frame);
    const drag = new ControlDrag(
      grabAt(frame.groups, { x: 4, y: 0 }, onScreen, () => 'handles')!,
      controls,
      scene,
    );
    drag.begin(contactAt(4, 0));
    drag.move([contactAt(5, 1)]);
    touches.flush();
    expect(client.touches()).toMatchObject([{ phase: TouchPhase.Move, touch: 2, x: 5, y: 1 }]);
  });

  it('moves the right finger of a line that was taken up again', () => {
    const lifted = controlFrame(
      8,
      1,
      [
        { x: 0, y: 0 },
        { x: 4, y: 0 },
      ],
      { client: 2 },
    );
    const frame = frameWith(1, [lifted]);
    const drag = new ControlDrag(
      grabAt(frame.groups, { x: 4, y: 0 }, onScreen, () => 'handles')!,
      controls,
      scene,
    );
    drag.begin(contactAt(4, 0));
    drag.move([contactAt(4, 2)]);
    touches.flush();
    const made = client.commands().find((one) => one.kind === 'control');
    const [moved] = client.touches();
    expect(made?.kind === 'control' && made.touches?.[1]).toBe(moved?.touch);
    expect(moved).toMatchObject({ x: 4, y: 2 });
  });

  it('knows our newest control by its touch, in all groups', () => {
    const old = controlFrame(30, 0, [{ x: 1, y: 1 }]);
    const young = controlFrame(2, 0, [{ x: 2, y: 2 }]);
    young.points[0]!.touch = 7;
    const theirs = controlFrame(40, 0, [{ x: 3, y: 3 }], { client: 2 });
    theirs.points[0]!.touch = 99;
    const frame = frameWith(1, [old, theirs]);
    frame.groups.push({ ...frame.groups[0]!, id: 6, controls: [young] });
    expect(controls.newestIn(frame)).toEqual({ group: 6, control: young });
    expect(controls.newestIn(frameWith(1, [theirs]))).toBeNull();
  });

  it('forgets controls that are gone and those that the server refused', () => {
    drawLine();
    controls.observe(frameWith(1, [shownLine()]));
    controls.observe(frameWith(2, []));
    expect(controls.all).toHaveLength(0);
    drawLine();
    controls.observe(frameWith(3, []));
    expect(controls.all).toHaveLength(1);
    controls.observe(frameWith(200, []));
    expect(controls.all).toHaveLength(0);
  });
});
