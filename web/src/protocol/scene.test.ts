import { describe, expect, it } from 'vitest';
import { isSameWorld, parseScene } from './scene';

const scene = parseScene(JSON.stringify({ name: 'open', box: { min: [-4, -3], max: [4, 3] }, obstacles: [] }));

describe('isSameWorld', () => {
  it('is true whatever stands in it', () => {
    const tree = { id: 1, name: 'Tree', centre: [0, 0] as const, radius: 1, height: 3, moving: false };
    expect(isSameWorld(scene, { ...scene, obstacles: [tree], groups: [], title: 'Other' })).toBe(true);
  });
  it('is false for another name or another box', () => {
    expect(isSameWorld(scene, { ...scene, name: 'block' })).toBe(false);
    expect(isSameWorld(scene, { ...scene, box: { min: [-4, -3], max: [5, 3] } })).toBe(false);
  });
});

describe('parseScene', () => {
  it('fills in what is absent and refuses what has no box', () => {
    expect(parseScene('{"box": {"min": [0, 0], "max": [1, 1]}}').groups).toEqual([]);
    expect(() => parseScene('{"name": "x"}')).toThrow('no box');
    expect(() => parseScene('[]')).toThrow();
  });
});
