import { beforeEach, expect, it } from 'vitest';
import { kDrawingOptions } from '../../model/place/drawing';
import { moved, thing, type Thing } from '../../model/place/things';
import type { BuildStroke } from '../../tools/build_pointer';
import { BuildStroking, type StrokeHost } from './build_strokes';

const box = thing('obstacle', {
  id: 3,
  polygon: [
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
  ],
  centre: [1, 1],
});
let said: [string, readonly Thing[]][] = [];
let host: StrokeHost;
let strokes: BuildStroking;

/** Ten CSS px are a metre, and north is up. */
function at(x: number, y: number): BuildStroke {
  return { ground: { x, y }, screen: { x: 10 * x, y: -10 * y }, touch: false, shift: false, free: true };
}

beforeEach(() => {
  said = [];
  const say =
    (word: string) =>
    (label: string, what: readonly Thing[]): void => {
      said.push([`${word} ${label}`, what]);
    };
  host = {
    tool: 'select',
    options: { ...kDrawingOptions, speed: 1, count: 9 },
    snaps: true,
    time: 0,
    all: [box],
    free: [box],
    chosen: [],
    preview: [],
    add: say('add'),
    change: say('change'),
    openWall: () => undefined,
    dragBegins: () => said.push(['begins', []]),
    drag: say('drag'),
    dragEnds: say('ends'),
    dragCancelled: say('cancelled'),
    setTool: () => undefined,
    say: () => undefined,
    undo: () => undefined,
    toScreen: ({ x, y }) => ({ x: 10 * x, y: -10 * y }),
    metres: (px) => px / 10,
  };
  strokes = new BuildStroking(host);
});

it('tells how a drag goes on, and how it ends', () => {
  strokes.begin(at(1, 1));
  strokes.move(at(1.1, 1), true);
  expect(said.map(([word]) => word)).toEqual(['begins']);
  expect(strokes.dragging).toBe(true);
  strokes.move(at(2, 1), false);
  strokes.end(at(3, 1), false);
  expect(said.slice(1)).toEqual([
    ['drag Move', [moved(box, 1, 0)]],
    ['ends Move', [moved(box, 2, 0)]],
  ]);
  expect(strokes.dragging).toBe(false);
});

it('says nothing of a tap but that it is over', () => {
  strokes.begin(at(1, 1));
  strokes.end(at(1, 1), true);
  expect(host.chosen).toEqual([box]);
  expect(said.map(([word]) => word)).toEqual(['begins']);
});

it('gives up a drag with how things were before it', () => {
  strokes.begin(at(1, 1));
  strokes.move(at(2, 1), false);
  strokes.cancel();
  expect(said.at(-1)).toEqual(['cancelled Move', [box]]);
  strokes.cancel();
  expect(said).toHaveLength(3);
});

it('turns about the middle that things had, however they follow', () => {
  host.chosen = [box];
  // The handle lies 34 px above the box.
  strokes.begin(at(1, 5.4));
  strokes.move(at(5.4, 1), false);
  host.chosen = [moved(box, 7, 7)];
  strokes.end(at(5.4, 1), false);
  const [, [dragged]] = said[1]!;
  expect(said[1]![0]).toBe('drag Turn');
  expect(said[2]).toEqual(['ends Turn', [dragged]]);
  expect(dragged!.centre[0]).toBeCloseTo(1, 9);
  expect(dragged!.centre[1]).toBeCloseTo(1, 9);
});

it('turns by the shorter way', () => {
  const group = thing('group', { id: 1, centre: [1, 1], radius: 1, count: 9 });
  host.chosen = [group];
  strokes.begin(at(1, 5.4));
  strokes.end(at(-3.4, 1.1), false);
  expect(said[1]![1][0]!.angle).toBeGreaterThan(1.4);
  expect(said[1]![1][0]!.angle).toBeLessThan(Math.PI / 2);
  said = [];
  strokes.begin(at(1, 5.4));
  strokes.end(at(-3.4, 0.9), false);
  expect(said[1]![1][0]!.angle).toBeGreaterThan(Math.PI / 2);
  expect(said[1]![1][0]!.angle).toBeLessThan(1.8);
});
