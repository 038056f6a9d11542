import { describe, expect, it } from 'vitest';
import { decodeServer, encodeServer } from './encoding';
import { isMoving, isSameWorld } from './scene';
import { kMoves, obstacleOf, sceneOf } from './test_scene';

const scene = sceneOf({ name: 'open', box: { min: [-4, -3], max: [4, 3] } });
const tree = obstacleOf({ id: 1, name: 'Tree', radius: 1 });

describe('isSameWorld', () => {
  it('is true whatever stands in it', () => {
    expect(isSameWorld(scene, { ...scene, obstacles: [tree], groups: [], title: 'Other' })).toBe(true);
  });
  it('is false for another name or another box', () => {
    expect(isSameWorld(scene, { ...scene, name: 'places/yard' })).toBe(true);
    expect(isSameWorld(scene, { ...scene, name: 'block', world: scene.world + 1 })).toBe(false);
    expect(isSameWorld(scene, { ...scene, box: { min: [-4, -3], max: [5, 3] } })).toBe(false);
  });
});

it('isMoving tells what follows a path', () => {
  expect([tree, { ...tree, path: kMoves }].map(isMoving)).toEqual([false, true]);
});

describe('a scene message', () => {
  it('has things as their definitions with ids, and its groups where definitions have indices', () => {
    const full = sceneOf({
      obstacles: [tree],
      checkpoints: [{ id: 3, position: [1, 2], formation: { kind: 'ring' }, group: 7 }],
      areas: [{ id: 4, kind: 'source', polygon: [[0, 0]], group: 7 }],
      groups: [{ id: 7, accent: 2, definition: { name: 'Guests', build: 'narrow' }, body: { maxSpeed: 1.5 } }],
    });
    const again = decodeServer(encodeServer(full));
    expect(again).toEqual(full);
    expect(full.obstacles[0]).toEqual({ ...tree, id: 1, height: 3, range: -1 });
    expect(full.checkpoints[0]).toMatchObject({ id: 3, group: 7, formation: { kind: 'ring', spacing: 1 }, share: 0.5 });
    expect(full.areas[0]).toMatchObject({ id: 4, group: 7, kind: 'source', open: true, until: 1e9 });
    expect(full.groups[0]).toMatchObject({
      id: 7,
      definition: { name: 'Guests', build: 'narrow', motions: null },
      body: { radius: null, maxSpeed: 1.5, unitClass: null },
    });
  });
  it('has marks in the place of bytes of names that are not UTF-8', () => {
    const bytes = new Uint8Array(encodeServer({ ...scene, title: 'Caf#' }));
    bytes[bytes.indexOf(0x23)] = 0xff;
    expect(decodeServer(bytes.buffer)).toMatchObject({ title: 'Caf\ufffd' });
  });
});
