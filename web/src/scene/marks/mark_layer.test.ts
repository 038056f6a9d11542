// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { CameraController } from '../camera/camera_controller';
import { MarkState } from './mark_state';
import type { ControlView } from '../../model/frame_view';
import { MarkLayer, type MarkScene } from './mark_layer';
import { MarkPainter } from './mark_painter';
import { paletteOf } from '../drawing/palette';
import { madeControl, madeGroup, quietOrders } from '../../model/test_frames';
import type { ScreenPoint } from '../../model/plane';

/** A pen that can do all and paints nothing. */
const pen = new Proxy({}, { get: () => () => undefined, set: () => true });
const camera = new CameraController();
let layer: MarkLayer;
let marks: MarkState;

beforeEach(() => {
  vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(pen as never);
  camera.resize(1280, 800);
  camera.setPose({ targetX: 4, targetY: 0, distance: 40, turn: 0, pitch: 0.9 });
  layer = new MarkLayer(document.createElement('div'));
  layer.resize(1280, 800, 1);
  marks = new MarkState();
  marks.client = 1;
});

afterEach(() => vi.restoreAllMocks());

function draw(control: ControlView): void {
  marks.update([madeGroup(1, [control])], 0);
  const scene: MarkScene = {
    camera,
    palette: paletteOf('light'),
    colours: [0],
    paths: true,
    covered: () => false,
    now: 1000,
    drafts: [],
    overlay: null,
    chosenGroup: 0,
    ...quietOrders(),
  };
  layer.draw(marks, scene);
}

const onScreen = (x: number, y: number): ScreenPoint => camera.worldToScreen(x, y);

it('fills the convex hull of an area: a corner inside it bends nothing', () => {
  const hull = vi.spyOn(MarkPainter.prototype, 'hull');
  draw(
    madeControl(1, 2, [
      [0, 0],
      [6, 0],
      [3, 1],
      [3, 6],
    ]),
  );
  const corners = hull.mock.calls[0]![0];
  expect(corners).toHaveLength(3);
  for (const [x, y] of [
    [0, 0],
    [6, 0],
    [3, 6],
  ] as const)
    expect(corners).toContainEqual(onScreen(x, y));
});

/** A point control on its way along x, its path known up to 6 m. */
function onItsWay(more: Partial<ControlView> = {}): ControlView {
  const made = madeControl(1, 0, [[0, 0]]);
  const path = Array.from({ length: 12 }, (_, i) => [0.5 * (i + 1), 0]).flat();
  return { ...made, points: [{ ...made.points[0]!, touch: 7, path }], ...more };
}

it('draws a path up to the finger of its own touch, not to one that is only near', () => {
  const cased = vi.spyOn(MarkPainter.prototype, 'cased');
  const end = (): ScreenPoint => {
    const points = cased.mock.calls[cased.mock.calls.length - 1]![0];
    return points[points.length - 1]!;
  };
  marks.touch(8, { x: 6.1, y: 0.1 }, 0, 0);
  draw(onItsWay());
  expect(end()).toEqual(onScreen(6, 0));
  marks.touch(7, { x: 9, y: 2 }, 0, 0);
  draw(onItsWay());
  expect(end()).toEqual(onScreen(9, 2));
  draw(onItsWay({ client: 2 }));
  expect(end()).toEqual(onScreen(6, 0));
});

it('shows small checkpoints where they are, with the next one bigger, and none on the handle', () => {
  const checkpoint = vi.spyOn(MarkPainter.prototype, 'checkpoint');
  const lifted = onItsWay();
  draw({ ...lifted, points: [{ ...lifted.points[0]!, down: false }] });
  const shown = checkpoint.mock.calls.map(([at, , next]) => ({ at, next }));
  expect(shown.length).toBeGreaterThan(2);
  expect(shown.map(({ next }) => next)).toEqual(shown.map((_, i) => i === 0));
  const handle = onScreen(0, 0);
  for (const { at } of shown) expect(Math.hypot(at.x - handle.x, at.y - handle.y)).toBeGreaterThan(18);
  const radii: number[] = [];
  const arcs = new Proxy(
    {},
    {
      get: (_, name) =>
        name === 'arc' ? (_x: number, _y: number, radius: number) => radii.push(radius) : () => undefined,
      set: () => true,
    },
  );
  new MarkPainter(arcs as CanvasRenderingContext2D).checkpoint(handle, { accent: '#112233', casing: '#ffffff' }, false);
  expect(Math.max(...radii)).toBe(3);
});
