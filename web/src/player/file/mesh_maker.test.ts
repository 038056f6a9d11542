import { describe, expect, it } from 'vitest';
import { MeshMaker, thrown, type SceneMesh } from './mesh_maker';

/** The volume inside of a closed mesh, by the divergence theorem [m^3]. */
function volume({ positions: p }: SceneMesh): number {
  let sum = 0;
  for (let t = 0; t < p.length; t += 9) {
    const corner = (k: number): number[] => [p[t + k]!, p[t + k + 1]!, p[t + k + 2]!];
    const [a, b, c] = [corner(0), corner(3), corner(6)];
    sum +=
      a[0]! * (b[1]! * c[2]! - b[2]! * c[1]!) +
      a[1]! * (b[2]! * c[0]! - b[0]! * c[2]!) +
      a[2]! * (b[0]! * c[1]! - b[1]! * c[0]!);
  }
  return sum / 6;
}

function made(fill: (maker: MeshMaker) => void): SceneMesh {
  const maker = new MeshMaker();
  fill(maker);
  return maker.take();
}

const kSquare = [
  [1, 1, 0],
  [3, 1, 0],
  [3, 4, 0],
  [1, 4, 0],
] as const;

const kThrown = [0.8312788, 0.35051578, 0.21315914];

describe('MeshMaker', () => {
  it('closes boxes and beams, and turns them outwards', () => {
    const box = made((maker) => {
      maker.walls(1, kSquare, [0, 2], false);
      maker.floor(1, kSquare, 2);
    });
    expect(volume(box)).toBeCloseTo(12);
    const inside = made((maker) => maker.walls(1, kSquare, [0, 2], true));
    expect(volume(inside)).toBeLessThan(0);
    const beam = made((maker) => maker.beam(2, [0, 0, 1], [3, 4, 1], 0.2));
    expect(volume(beam)).toBeCloseTo(5 * 0.04);
    const upright = made((maker) => maker.beam(2, [5, 5, 0], [5, 5, 3], 0.1));
    expect(volume(upright)).toBeCloseTo(3 * 0.01);
  });

  it('makes cones and balls of their size', () => {
    const cone = made((maker) => maker.frustum(3, [7, 8, 0], { height: 3, low: 2, high: 1, sides: 64 }));
    expect(volume(cone)).toBeCloseTo((Math.PI * 3 * (4 + 2 + 1)) / 3, 0);
    const ball = made((maker) => maker.blob(4, [9, 9, 9], { radius: 1, height: 1, rows: 12, sides: 24, seed: 7 }));
    // Lumps are 0.88 to 1.08 of the radius.
    expect(volume(ball)).toBeGreaterThan(0.88 ** 3 * 4);
    expect(volume(ball)).toBeLessThan(1.08 ** 3 * 4.2);
    for (let k = 0; k < ball.normals.length; k += 3)
      expect(Math.hypot(ball.normals[k]!, ball.normals[k + 1]!, ball.normals[k + 2]!)).toBeCloseTo(1);
  });

  it('throws the same numbers as the exporter', () => {
    // Computed by the definition with 32-bit numbers of Python.
    expect(thrown(0, 0)).toBeCloseTo(kThrown[0]!, 7);
    expect(thrown(7, 65)).toBeCloseTo(kThrown[1]!, 7);
    expect(thrown(4000000000, 3)).toBeCloseTo(kThrown[2]!, 7);
  });

  it('leaves out triangles without an area', () => {
    expect(made((maker) => maker.triangle(0, [0, 0, 0], [1, 1, 1], [2, 2, 2])).positions.length).toBe(0);
  });
});
