// three.js draws no more instances than a geometry had when it was first drawn, until the geometry is disposed of.
import type { InstancedBufferGeometry } from 'three';
import { describe, expect, it } from 'vitest';
import { CrowdState } from './crowd_state';
import { FatLines } from './fat_lines';
import { Figures } from './figures';
import { InstancedRings } from './instanced_rings';
import { paletteOf } from './palette';

function disposals(geometry: InstancedBufferGeometry): () => number {
  let count = 0;
  geometry.addEventListener('dispose', () => (count += 1));
  return () => count;
}

describe('what is drawn in instances makes room for more of them', () => {
  it('lines', () => {
    const lines = new FatLines({ width: 1, renderOrder: 1 });
    lines.reserve(10);
    const count = disposals(lines.mesh.geometry);
    lines.reserve(20);
    expect(count()).toBe(0);
    lines.reserve(200);
    expect(count()).toBe(1);
    expect(lines.mesh.geometry.attributes['from']!.count).toBeGreaterThanOrEqual(200);
  });

  it('rings', () => {
    const rings = new InstancedRings();
    rings.begin(10);
    const count = disposals(rings.mesh.geometry);
    rings.begin(200);
    expect(count()).toBe(1);
  });

  it('figures', () => {
    const figures = new Figures('light');
    const state = new CrowdState();
    const of = (people: number): void => {
      state.setMembers(Array.from({ length: people }, (_, i) => i), new Array<number>(people).fill(0));
      figures.setMembers(state, [0], paletteOf('light'), -1);
    };
    of(36);
    const bodies = disposals(figures.bodies.geometry);
    const discs = disposals(figures.discs.geometry);
    of(100);
    expect([bodies(), discs()]).toEqual([1, 1]);
    expect(figures.bodies.geometry.instanceCount).toBe(100);
  });
});
