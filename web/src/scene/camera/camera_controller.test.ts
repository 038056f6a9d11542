import { describe, expect, it } from 'vitest';
import { CameraController } from './camera_controller';
import type { ScreenPoint } from '../../model/plane';

function camera(width = 1280, height = 800): CameraController {
  const made = new CameraController();
  made.resize(width, height);
  made.setWorld(-500, -500, 500, 500);
  made.open();
  return made;
}

function ground(made: CameraController, at: ScreenPoint): { x: number; y: number } {
  const point = made.screenToGround(at);
  if (!point) throw new Error('above the horizon');
  return point;
}

describe('CameraController', () => {
  it('shows its target in the middle and answers the inverse', () => {
    const made = camera();
    made.setPose({ targetX: 3, targetY: -7, distance: 30, turn: 1.1, pitch: 0.9 });
    expect(made.worldToScreen(3, -7).x).toBeCloseTo(640, 6);
    expect(made.worldToScreen(3, -7).y).toBeCloseTo(400, 6);
    const at = { x: 200, y: 640 };
    const point = ground(made, at);
    const back = made.worldToScreen(point.x, point.y);
    expect(back.x).toBeCloseTo(at.x, 6);
    expect(back.y).toBeCloseTo(at.y, 6);
  });

  it('with no turn looks north: east is right, far is up', () => {
    const made = camera();
    made.setPose({ targetX: 0, targetY: 0, distance: 30, turn: 0, pitch: 0.8 });
    expect(made.worldToScreen(1, 0).x).toBeGreaterThan(640);
    expect(made.worldToScreen(0, 1).y).toBeLessThan(400);
    expect(made.worldToScreen(0, 0, 1).y).toBeLessThan(400);
  });

  it('a metre across the middle takes pixelsPerMetre', () => {
    const made = camera();
    made.setPose({ targetX: 0, targetY: 0, distance: 30, turn: 0, pitch: 0.8 });
    const width = made.worldToScreen(0.5, 0).x - made.worldToScreen(-0.5, 0).x;
    expect(width).toBeCloseTo(made.pixelsPerMetre(), 6);
  });

  it('panning keeps the ground under the finger', () => {
    const made = camera();
    const point = ground(made, { x: 300, y: 500 });
    made.pan({ x: 300, y: 500 }, { x: 720, y: 410 });
    const at = made.worldToScreen(point.x, point.y);
    expect(at.x).toBeCloseTo(720, 3);
    expect(at.y).toBeCloseTo(410, 3);
  });

  it('pinching keeps both ground points under the fingers', () => {
    for (const turn of [0, 0.33, -2]) {
      const made = camera(820, 1180);
      made.setPose({ targetX: 1, targetY: 2, distance: 40, turn, pitch: 0.87 });
      const before: [ScreenPoint, ScreenPoint] = [
        { x: 300, y: 500 },
        { x: 500, y: 620 },
      ];
      const after: [ScreenPoint, ScreenPoint] = [
        { x: 220, y: 560 },
        { x: 560, y: 420 },
      ];
      const a = ground(made, before[0]);
      const b = ground(made, before[1]);
      made.pinch(before, after);
      const c = made.worldToScreen(a.x, a.y);
      const d = made.worldToScreen(b.x, b.y);
      expect(Math.hypot(c.x - 220, c.y - 560)).toBeLessThan(0.05);
      expect(Math.hypot(d.x - 560, d.y - 420)).toBeLessThan(0.05);
      expect(made.pose.distance).toBeLessThan(40);
    }
  });

  it('zooming keeps the ground at the pointer', () => {
    const made = camera();
    const point = ground(made, { x: 900, y: 250 });
    made.zoomAt({ x: 900, y: 250 }, 1.7);
    const at = made.worldToScreen(point.x, point.y);
    expect(Math.hypot(at.x - 900, at.y - 250)).toBeLessThan(1e-3);
  });

  it('fits points between the panels and fills one direction', () => {
    const made = camera();
    const padding = { top: 80, right: 40, bottom: 160, left: 200 };
    const points = [
      { x: 10, y: 10 },
      { x: 40, y: 12 },
      { x: 30, y: 35 },
      { x: 12, y: 28 },
    ];
    made.fit(points, padding);
    const at = points.map((point) => made.worldToScreen(point.x, point.y));
    const minX = Math.min(...at.map((p) => p.x));
    const maxX = Math.max(...at.map((p) => p.x));
    const minY = Math.min(...at.map((p) => p.y));
    const maxY = Math.max(...at.map((p) => p.y));
    expect(minX).toBeGreaterThan(199);
    expect(maxX).toBeLessThan(1241);
    expect(minY).toBeGreaterThan(79);
    expect(maxY).toBeLessThan(641);
    expect(Math.max((maxX - minX) / 1040, (maxY - minY) / 560)).toBeGreaterThan(0.98);
  });

  it('stays within pitch, distance and world', () => {
    const made = camera();
    made.orbit(0, 10);
    expect(made.pose.pitch).toBeCloseTo((85 * Math.PI) / 180);
    made.orbit(0, -10);
    expect(made.pose.pitch).toBeCloseTo((25 * Math.PI) / 180);
    made.zoomAt({ x: 640, y: 400 }, 1e9);
    expect(made.pose.distance).toBe(5);
    made.panBy(-1e7, 0);
    expect(Math.abs(made.pose.targetX)).toBeLessThanOrEqual(500);
  });

  it('never loses the ground at the flattest pitch', () => {
    for (const [width, height] of [
      [1280, 800],
      [390, 844],
    ] as const) {
      const made = camera(width, height);
      made.orbit(0, -10);
      expect(made.screenToGround({ x: 0, y: 0 })).not.toBeNull();
    }
  });

  it('glides to a fit and ends exactly there', () => {
    const made = camera();
    const points = [
      { x: 10, y: 10 },
      { x: 40, y: 12 },
    ];
    const padding = { top: 0, right: 0, bottom: 0, left: 0 };
    const direct = camera();
    direct.fit(points, padding);
    made.glideFit(points, padding, 1000, 200);
    expect(made.update(1100)).toBe(true);
    expect(made.pose.targetX).not.toBeCloseTo(direct.pose.targetX);
    made.update(1300);
    expect(made.pose.targetX).toBeCloseTo(direct.pose.targetX);
    expect(made.update(1400)).toBe(false);
  });

  it('glides to a spot between the panels without coming nearer, also to one behind the eye', () => {
    const padding = { top: 80, right: 24, bottom: 200, left: 160 };
    for (const spot of [
      { x: 12, y: 9 },
      { x: -20, y: -300 },
    ]) {
      const made = camera();
      const { distance, turn, pitch } = made.pose;
      made.glideTo(spot, padding, 1000, 200);
      expect(made.update(1100)).toBe(true);
      made.update(1300);
      const at = made.worldToScreen(spot.x, spot.y);
      expect(at.x).toBeCloseTo((160 + 1280 - 24) / 2, 4);
      expect(at.y).toBeCloseTo((80 + 800 - 200) / 2, 4);
      expect([made.pose.distance, made.pose.turn, made.pose.pitch]).toEqual([distance, turn, pitch]);
    }
  });
});

describe('from straight above', () => {
  const box = { min: [-20, -11.25], max: [20, 11.25] } as const;
  const padding = { top: 76, right: 8, bottom: 8, left: 8 };

  it('shows all of the world below the bar, and nothing moves it', () => {
    const camera = new CameraController();
    camera.resize(1440, 900);
    camera.straightDown(box, padding);
    const [low, high] = [camera.worldToScreen(-20, -11.25), camera.worldToScreen(20, 11.25)];
    expect(low.x).toBeGreaterThanOrEqual(8 - 1e-6);
    expect(high.x).toBeLessThanOrEqual(1432 + 1e-6);
    expect(high.y).toBeGreaterThanOrEqual(76 - 1e-6);
    expect(low.y).toBeLessThanOrEqual(892 + 1e-6);
    expect(high.x - low.x).toBeCloseTo(1424, 3);
    const before = { ...camera.pose };
    camera.zoomAt({ x: 3, y: 4 }, 2);
    camera.orbit(1, 1);
    camera.panBy(10, 10);
    camera.fit([{ x: 0, y: 0 }], padding);
    camera.open();
    expect(camera.pose).toEqual(before);
  });

  it('stands the world on its side in a high window', () => {
    const camera = new CameraController();
    camera.resize(390, 844);
    camera.straightDown(box, padding);
    expect(camera.worldToScreen(-20, 0).y).toBeGreaterThan(camera.worldToScreen(20, 0).y + 600);
    camera.resize(844, 390);
    expect(camera.worldToScreen(20, 0).x).toBeGreaterThan(camera.worldToScreen(-20, 0).x + 400);
  });
});

it('tells by one matrix where the ground is seen', () => {
  const camera = new CameraController();
  camera.resize(1200, 800);
  const project = (x: number, y: number) => {
    const m = camera.seenGround().matrix;
    const row = (i: number): number => m[i]! * x + m[i + 1]! * y + m[i + 2]!;
    return { x: row(0) / row(6), y: row(3) / row(6) };
  };
  const check = (): void => {
    for (const [x, y] of [
      [0, 0],
      [5, -7],
      [-12, 9],
    ] as const) {
      const seen = camera.worldToScreen(x, y);
      expect(project(x, y).x).toBeCloseTo(seen.x, 6);
      expect(project(x, y).y).toBeCloseTo(seen.y, 6);
    }
  };
  check();
  camera.orbit(0.7, 0.2);
  camera.zoomAt({ x: 100, y: 700 }, 1.6);
  check();
  camera.straightDown({ min: [-20, -11.25], max: [20, 11.25] }, { top: 76, right: 8, bottom: 8, left: 8 });
  check();
});
