// three.js draws no more instances than a geometry had when it was first drawn, until the geometry is disposed of.

import { InstancedBufferGeometry } from 'three';
import { describe, expect, it } from 'vitest';
import { ContactDiscs } from './crowd/contact_discs';
import { CrowdTextures } from './crowd/crowd_textures';
import { FatLines } from './drawing/fat_lines';
import { InstanceList, kWhoBits } from './drawing/instance_list';
import { PlaceLayer } from './marks/place_layer';

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
    const rings = new PlaceLayer();
    rings.begin(10);
    const count = disposals(rings.mesh.geometry);
    rings.begin(200);
    expect(count()).toBe(1);
  });

  it('people', () => {
    const geometry = new InstancedBufferGeometry();
    const list = new InstanceList([geometry]);
    list.begin(36);
    const count = disposals(geometry);
    list.begin(30);
    expect(count()).toBe(0);
    list.begin(100);
    expect(count()).toBe(1);
    for (let i = 0; i < 100; ++i) list.add(3 * i, i === 7 ? 2 : -1);
    list.end();
    expect(geometry.instanceCount).toBe(100);
    const who = geometry.attributes['aWho']!;
    expect(who.count).toBeGreaterThanOrEqual(100);
    expect([who.getX(7), who.getX(99)]).toEqual([21 + 3 * 2 ** kWhoBits, 297]);
  });

  it('discs', () => {
    const discs = new ContactDiscs(new CrowdTextures().uniforms);
    discs.list.begin(36);
    const count = disposals(discs.mesh.geometry);
    discs.list.begin(100);
    expect(count()).toBe(1);
    for (let i = 0; i < 100; ++i) discs.list.add(i, -1);
    discs.end();
    expect(discs.mesh.geometry.instanceCount).toBe(100);
  });
});
