import { describe, expect, it } from 'vitest';
import { Extent, ViewCamera } from './view_camera';

const kHint = { turn: 0.33, pitch: 0.8, angle: 0.42 };

/** Where a point is in the picture: right and up, -1 to 1. */
function seen(camera: ViewCamera, x: number, y: number, z: number): [number, number] {
  const m = camera.matrix();
  const of = (row: number): number => m[row]! * x + m[4 + row]! * y + m[8 + row]! * z + m[12 + row]!;
  expect(of(3)).toBeGreaterThan(0);
  expect(Math.abs(of(2) / of(3))).toBeLessThan(1);
  const at: [number, number] = [of(0) / of(3), of(1) / of(3)];
  expect(camera.screen(x, y, z)).toEqual(at);
  return at;
}

function spread(): { extent: Extent; points: [number, number][] } {
  const extent = new Extent();
  const points: [number, number][] = [];
  for (let k = 0; k < 60; ++k) points.push([17 * Math.sin(k * 12.9), 9 * Math.sin(k * 7.7) + 30]);
  for (const [x, y] of points) extent.add(x, y);
  return { extent, points };
}

describe('ViewCamera', () => {
  it('sees all points, from feet to head, and could not be nearer, in wide and in upright pictures', () => {
    const { extent, points } = spread();
    for (const aspect of [16 / 9, 1, 9 / 16]) {
      const camera = new ViewCamera(kHint);
      camera.aspect = aspect;
      camera.aim(camera.fit(extent)!);
      const all = points.flatMap(([x, y]) => [seen(camera, x, y, 0), seen(camera, x, y, 1.8)]);
      const [across, along] = [0, 1].map((k) => Math.max(...all.map((p) => Math.abs(p[k]!)))) as [number, number];
      expect(Math.max(across, along)).toBeLessThan(0.945);
      expect(Math.max(across, along)).toBeGreaterThan(0.92);
    }
  });

  it('leaves room for controls below', () => {
    const { extent, points } = spread();
    const camera = new ViewCamera(kHint);
    camera.aspect = 0.8;
    camera.covered = 0.2;
    camera.aim(camera.fit(extent)!);
    const lowest = Math.min(...points.map(([x, y]) => seen(camera, x, y, 0)[1]));
    expect(lowest).toBeGreaterThan(-0.945 + 0.4);
  });

  it('finds the ground below a place of the picture', () => {
    const camera = new ViewCamera(kHint);
    camera.aim({ x: 3, y: -2, distance: 25 });
    const ground = camera.ground(0.5, -0.7)!;
    const back = seen(camera, ground[0], ground[1], 0);
    expect(back[0]).toBeCloseTo(0.5, 4);
    expect(back[1]).toBeCloseTo(-0.7, 4);
    camera.orbit(0, -5);
    expect(camera.ground(0, 0.99)).toBeNull();
  });

  it('keeps turns and zooms in bounds, and takes them back', () => {
    const camera = new ViewCamera(kHint);
    camera.aim({ x: 0, y: 0, distance: 40 });
    camera.orbit(1, 100);
    expect(camera.pitch).toBeCloseTo(1.55);
    for (let k = 0; k < 100; ++k) camera.zoom(0.5);
    expect(camera.distance).toBe(4);
    for (let k = 0; k < 100; ++k) camera.zoom(2);
    expect(camera.distance).toBe(3000);
    camera.pan(0.1, 0.2);
    camera.reset();
    expect([camera.turn, camera.pitch, camera.distance, ...camera.target]).toEqual([0.33, 0.8, 40, 0, 0, 0]);
  });

  it('moves the ground with the hand: a tenth of the picture to the right', () => {
    const camera = new ViewCamera({ ...kHint, turn: 0 });
    camera.aim({ x: 0, y: 0, distance: 40 });
    camera.pan(-0.1, 0);
    expect(seen(camera, 0, 0, 0)[0] * camera.aspect).toBeCloseTo(0.2, 3);
  });
});
