import { describe, expect, it } from 'vitest';
import type { Given } from '../../protocol/generated/commands';
import { EventKind, type EventFrame, type Scene } from '../../protocol/messages';
import { sceneOf } from '../../protocol/test_scene';
import { areaOf } from './area_record';
import { crossingOf, type MeasureLine } from './crossing';
import { Measures, type LineMeasure, type MeasuredFrame } from './measures';
import { allCsv, csvName, evacuationCsv, exitNames, measureCsv } from './measures_csv';
import { Series } from './series';

const kStep = 1 / 60;
/** Across the way to the east: from the north to the south, so that the east is to its left. */
const kDoor: MeasureLine = { a: { x: 2, y: 1 }, b: { x: 2, y: -1 } };

function scene(more: Given<Scene> = {}): Scene {
  return sceneOf({ world: 1, name: 'hall', box: { min: [-10, -5], max: [10, 5] }, ...more });
}

function frame(
  time: number,
  people: Readonly<Record<number, readonly [number, number]>>,
  more: object = {},
): MeasuredFrame {
  const ids = Object.keys(people).map(Number);
  const spots = ids.map((id) => people[id]!);
  const [x, y] = [spots.map(([at]) => at), spots.map(([, at]) => at)];
  return { time, replaying: false, ids, x, y, events: [], areas: [], ...more };
}

/** Everybody walks from x = 0 at that time on, at 1.5 m/s, and is seen in each step. */
function walk(measures: Measures, starts: Readonly<Record<number, number>>, until: number): void {
  for (let step = 0; step * kStep < until; ++step) {
    const time = step * kStep;
    const people = Object.entries(starts).map(([id, from]) => [id, [1.5 * Math.max(0, time - from), 0]] as const);
    measures.observe(frame(time, Object.fromEntries(people)));
  }
}

function lineOf(measures: Measures): LineMeasure {
  return measures.list.find((one) => one.kind === 'line')!;
}

function measuring(more: object = {}, line = kDoor): Measures {
  const measures = new Measures();
  measures.setScene(scene(more));
  measures.addLine(line.a, line.b);
  return measures;
}

describe('crossingOf', () => {
  it('tells where and which way', () => {
    expect(crossingOf(kDoor, { x: 1, y: 0 }, { x: 5, y: 0 })).toEqual({ share: 0.25, direction: -1 });
    expect(crossingOf(kDoor, { x: 5, y: 0 }, { x: 1, y: 0 })).toEqual({ share: 0.75, direction: 1 });
    expect(crossingOf(kDoor, { x: 1, y: 1.2 }, { x: 5, y: 1.2 })).toBeNull();
    expect(crossingOf(kDoor, { x: 1, y: 0 }, { x: 1.9, y: 0 })).toBeNull();
  });
  it('counts a movement that begins on the line, and none that ends on it', () => {
    expect(crossingOf(kDoor, { x: 1, y: 0 }, { x: 2, y: 0 })).toBeNull();
    expect(crossingOf(kDoor, { x: 2, y: 0 }, { x: 3, y: 0 })).toEqual({ share: 0, direction: -1 });
  });
});

describe('A line', () => {
  it('counts a straight walk at its very time', () => {
    const measures = measuring();
    walk(measures, { 7: 0.1 }, 3);
    const { crossings } = lineOf(measures).record;
    expect(crossings).toHaveLength(1);
    expect(crossings[0]).toMatchObject({ person: 7, direction: -1 });
    expect(crossings[0]!.time).toBeCloseTo(0.1 + 2 / 1.5, 9);
  });
  it('tells flows: of the last seconds, and between the first and the last person', () => {
    const measures = measuring();
    const starts = Object.fromEntries(Array.from({ length: 11 }, (_, k) => [k + 1, 0.5 * k]));
    walk(measures, starts, 8);
    const figures = lineOf(measures).record.figures(measures.time, 10, 0);
    expect(figures).toMatchObject({ persons: 11, left: 11, right: 0 });
    expect(figures.meanFlow).toBeCloseTo(2, 9);
    expect(figures.leftFlow).toBeCloseTo(11 / measures.time, 9);
    expect(lineOf(measures).record.flowAt(4.01, 2, 0).left).toBeCloseTo(2, 9);
  });
  it('counts who steps on the line and turns once, on the way back', () => {
    const measures = measuring();
    const xs = [1, 1.5, 2, 1.5, 1];
    xs.forEach((x, k) => measures.observe(frame(k, { 1: [x, 0] })));
    expect(lineOf(measures).record.crossings).toEqual([{ time: 2, person: 1, direction: 1 }]);
  });
  it('counts who goes over the line and comes back both ways, as one person', () => {
    const measures = measuring();
    [1, 1.75, 2.25, 1.75].forEach((x, k) => measures.observe(frame(k, { 1: [x, 0] })));
    const { record } = lineOf(measures);
    expect(record.figures(4, 10, 0)).toMatchObject({ persons: 1, right: 1, left: 1 });
    expect(record.crossings.map(({ time }) => time)).toEqual([1.5, 2.5]);
  });
  it('is crossed once at the seam of a ring, wherever it lies', () => {
    for (const at of [9.5, -9.5, -10, 10]) {
      const measures = measuring({ ring: true }, { a: { x: at, y: 2 }, b: { x: at, y: -2 } });
      for (let step = 0; step <= 600; ++step) {
        const x = ((4 + 2 * step * kStep + 10.003) % 20) - 10;
        measures.observe(frame(step * kStep, { 3: [x, 0] }));
      }
      const { crossings } = lineOf(measures).record;
      expect(crossings.map(({ direction }) => direction)).toEqual([-1]);
      const away = at > 0 ? at - 4.003 : at + 20 - 4.003;
      expect(crossings[0]!.time).toBeCloseTo(away / 2, 6);
    }
  });
  it('counts whoever leaves by an exit behind it between two frames', () => {
    const measures = measuring();
    const events: EventFrame[] = [{ kind: EventKind.Exited, subject: 1, value: 4, x: 3, y: 0 }];
    measures.observe(frame(0, { 1: [1, 0], 2: [0, 0] }));
    measures.observe(frame(1, { 2: [1, 0] }, { events }));
    expect(lineOf(measures).record.crossings).toEqual([{ time: 0.5, person: 1, direction: -1 }]);
  });
  it('does not count who comes into the world beyond it', () => {
    const measures = measuring();
    measures.observe(frame(0, { 1: [0, 0] }));
    measures.observe(frame(1, { 1: [0.5, 0], 2: [5, 0] }));
    expect(lineOf(measures).record.crossings).toEqual([]);
  });
});

describe('Time', () => {
  it('is wound back: what came later is forgotten', () => {
    const measures = measuring();
    walk(measures, { 1: 0, 2: 1 }, 4);
    expect(lineOf(measures).record.crossings).toHaveLength(2);
    measures.observe(frame(2, { 1: [3, 0], 2: [1.5, 0] }));
    expect(lineOf(measures).record.figures(2, 10, 0).persons).toBe(1);
    measures.observe(frame(2 + kStep, { 1: [3, 0], 2: [1.5, 0] }));
    expect(measures.evacuation.series.last!.time).toBeLessThanOrEqual(2 + kStep);
  });
  it('leaps in a replay: everything begins anew', () => {
    const measures = measuring();
    walk(measures, { 1: 0 }, 3);
    measures.observe(frame(20, { 1: [0, 0] }, { replaying: true }));
    expect(lineOf(measures)).toMatchObject({ since: 20 });
    expect(lineOf(measures).record.crossings).toEqual([]);
  });
  it('begins anew with another world; lines stay in the same place and go with it', () => {
    const measures = measuring();
    walk(measures, { 1: 0 }, 3);
    measures.setScene(scene({ world: 2 }));
    expect(measures.list).toHaveLength(1);
    expect(lineOf(measures).record.crossings).toEqual([]);
    measures.setScene(scene({ world: 3, name: 'square' }));
    expect(measures.list).toEqual([]);
  });
});

describe('An area', () => {
  const square = [0, 1, 2, 3].map((k) => ({ x: k === 0 || k === 3 ? 0 : 4, y: k < 2 ? -1 : 1 }));
  it('tells density and speed', () => {
    const measures = new Measures();
    measures.setScene(scene());
    measures.addArea(square);
    walk(measures, { 1: 0, 2: 1, 3: 30 }, 2);
    expect(areaOf(square)).toBe(8);
    const { last } = (measures.list[0]!.record as unknown as { series: Series<{ time: number }> }).series;
    expect(last).toMatchObject({ persons: 3, density: 3 / 8 });
    expect((last as unknown as { speed: number }).speed).toBeCloseTo((1.5 + 1.5 + 0) / 3, 6);
  });
  it('tells a speed over the seam of a ring', () => {
    const measures = new Measures();
    measures.setScene(scene({ ring: true }));
    measures.addArea([
      { x: 8, y: -1 },
      { x: 10, y: -1 },
      { x: 10, y: 1 },
      { x: 8, y: 1 },
    ]);
    for (let step = 0; step <= 600; ++step)
      measures.observe(frame(step * kStep, { 3: [((2 * step * kStep + 10) % 20) - 10, 0] }));
    const [one] = measures.list;
    const speeds =
      one!.kind === 'area' ? one!.record.series.samples.filter((s) => s.persons > 0).map((s) => s.speed) : [];
    expect(speeds.length).toBeGreaterThan(3);
    for (const speed of speeds) expect(speed).toBeCloseTo(2, 6);
  });
});

describe('The curve of evacuation', () => {
  it('counts by each exit, and knows the last one', () => {
    const measures = new Measures();
    const areas = [
      { id: 1, kind: 'exit', name: 'Door' },
      { id: 2, kind: 'source' },
      { id: 3, kind: 'exit' },
    ] as const;
    measures.setScene(scene({ areas }));
    const seen = (one: number, three: number): object => ({
      areas: [
        { id: 1, passed: one },
        { id: 2, passed: 9 },
        { id: 3, passed: three },
      ],
    });
    measures.observe(frame(0, { 1: [0, 0], 2: [1, 0], 3: [1, 1] }, seen(0, 0)));
    measures.observe(frame(1, { 2: [1, 0], 3: [1, 1] }, seen(1, 0)));
    measures.observe(frame(2, { 3: [1, 1] }, seen(1, 1)));
    measures.observe(frame(3, { 3: [1, 1] }, seen(1, 1)));
    const { evacuation } = measures;
    expect(evacuation.now).toEqual({ time: 3, inside: 1, out: 2, byExit: [1, 1] });
    expect(evacuation.lastOut).toBe(2);
    const names = exitNames(evacuation.exits, measures.scene!.areas);
    expect(names).toEqual(['Door', 'Exit 3']);
    expect(evacuationCsv(evacuation, names)).toBe(
      'time [s],inside [persons],out [persons],out by Door [persons],out by Exit 3 [persons]\n' +
        '0,3,0,0,0\n1,2,1,1,0\n2,1,2,1,1\n3,1,2,1,1\n',
    );
  });
});

describe('Tables', () => {
  it('have units in the header, and names as they are', () => {
    const measures = measuring();
    measures.change(lineOf(measures).id, { name: 'Door, "west"' });
    walk(measures, { 4: 0 }, 2);
    expect(measureCsv(lineOf(measures))).toBe('time [s],person,direction (1: with the arrow)\n1.3333,4,-1\n');
    const rows = allCsv(measures, []).split('\n');
    expect(rows[0]).toBe('time [s],measure,quantity,value,unit');
    expect(rows[1]).toBe('1.3333,"Door, ""west""",crossings against the arrow,1,persons');
    expect(rows.filter((row) => row.includes('Evacuation,inside,1,persons')).length).toBeGreaterThan(5);
    expect(csvName('Hall 2 Line 1')).toBe('hall-2-line-1.csv');
  });
});

describe('Series', () => {
  it('goes on half as often once it is long', () => {
    const series = new Series<{ time: number }>(10);
    for (let k = 0; k < 200; ++k) if (series.isDue(0.1 * k)) series.add({ time: 0.1 * k });
    expect(series.samples.length).toBeLessThanOrEqual(10);
    expect(series.apart).toBeCloseTo(3.2, 9);
    expect(series.samples[0]!.time).toBe(0);
  });
});
