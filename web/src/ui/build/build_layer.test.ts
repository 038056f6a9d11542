// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { polygonThing } from '../../model/place/drawing';
import { BuildLayer, type BuildPicture } from './build_layer';

const box = (x: number) =>
  polygonThing(
    [
      [x, 0],
      [x + 1, 0],
      [x + 1, 1],
      [x, 1],
    ],
    2,
  )!;

const house = box(0);
const moved = box(5);
const kPicture: BuildPicture = {
  time: 0,
  things: [house],
  chosen: [],
  preview: [],
  line: [],
  closed: false,
  handles: false,
  corner: -1,
  guides: [],
};

let shift = 0;
let layer: BuildLayer;
const things = () => [...layer.root.querySelectorAll('.build-thing')];
const count = (name: string) => layer.root.querySelectorAll(name).length;

beforeEach(() => {
  shift = 0;
  layer = new BuildLayer({ toScreen: ({ x, y }) => ({ x: x + shift, y }) });
  layer.draw(kPicture);
});

describe('BuildLayer', () => {
  it('leaves alone what has not changed', () => {
    const [before] = things();
    layer.draw({ ...kPicture, things: [house] });
    expect(things()[0]).toBe(before);
    layer.draw({ ...kPicture, preview: [moved] });
    expect(things()[0]).toBe(before);
    expect(count('.build-preview')).toBe(1);
    layer.draw({ ...kPicture, preview: [] });
    expect(count('.build-preview')).toBe(0);
  });

  it('draws anew where the camera, the place or the choice has changed', () => {
    const points = () => layer.root.querySelector('.build-outline')!.getAttribute('points');
    const before = points();
    shift = 7;
    layer.draw(kPicture);
    expect(points()).not.toBe(before);
    layer.draw({ ...kPicture, chosen: [house], handles: true });
    expect([count('.build-chosen'), count('.build-handle')]).toEqual([1, 2]);
    layer.draw({ ...kPicture, things: [house, moved] });
    expect([things().length, count('.build-handle')]).toEqual([2, 0]);
  });

  it('follows a line that grows in place', () => {
    const line = [
      { x: 0, y: 0 },
      { x: 1, y: 0 },
    ];
    layer.draw({ ...kPicture, line });
    line.push({ x: 2, y: 3 });
    layer.draw({ ...kPicture, line });
    expect(layer.root.querySelector('.build-line')!.getAttribute('points')).toContain('2.0,3.0');
  });
});
