// What was measured as tables of comma-separated values. Units stand in the header, or beside each value.

import type { EvacuationRecord } from './evacuation_record';
import { kWindow, type Measure, type Measures } from './measures';

type Cell = string | number;
type Row = readonly Cell[];

function cellOf(cell: Cell): string {
  if (typeof cell === 'number') return Number.isFinite(cell) ? String(Math.round(cell * 1e4) / 1e4) : '';
  return /[",\n\r]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
}

function textOf(rows: readonly Row[]): string {
  return rows.map((row) => `${row.map(cellOf).join(',')}\n`).join('');
}

/** A file name for it. */
export function csvName(name: string): string {
  const plain = name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');
  return `${plain || 'measures'}.csv`;
}

/** One row for each crossing, or for each sample of an area. */
export function measureCsv(one: Measure): string {
  if (one.kind === 'line') {
    const header = ['time [s]', 'person', 'direction (1: with the arrow)'];
    return textOf([header, ...one.record.crossings.map((c) => [c.time, c.person, c.direction])]);
  }
  const header = ['time [s]', 'persons', 'density [1/m2]', 'mean speed [m/s]'];
  return textOf([header, ...one.record.series.samples.map((s) => [s.time, s.persons, s.density, s.speed])]);
}

/** Of each exit by its name; exits without a name, and those that share one, by their numbers. */
export function exitNames(
  ids: readonly number[],
  areas: readonly { readonly id: number; readonly name?: string }[],
): string[] {
  const given = ids.map((id) => areas.find((area) => area.id === id)?.name ?? '');
  return ids.map((id, k) => {
    const name = given[k]!;
    const alone = name !== '' && given.filter((other) => other === name).length === 1;
    return alone ? name : `${name || 'Exit'} ${id}`;
  });
}

/** One row for each sample; a column for each exit. */
export function evacuationCsv({ series, exits }: EvacuationRecord, names: readonly string[]): string {
  const header = ['time [s]', 'inside [persons]', 'out [persons]', ...names.map((name) => `out by ${name} [persons]`)];
  const rows = series.samples.map((s) => [s.time, s.inside, s.out, ...exits.map((_, k) => s.byExit[k] ?? 0)]);
  return textOf([header, ...rows]);
}

function longRows(one: Measure, time: number): Row[] {
  if (one.kind === 'area')
    return one.record.series.samples.flatMap((s) => [
      [s.time, one.name, 'persons', s.persons, 'persons'],
      [s.time, one.name, 'density', s.density, '1/m2'],
      [s.time, one.name, 'mean speed', s.speed, 'm/s'],
    ]);
  const counts = { with: 0, against: 0 };
  const rows = one.record.crossings.map((c): Row => {
    const way = c.direction > 0 ? 'with' : 'against';
    return [c.time, one.name, `crossings ${way} the arrow`, ++counts[way], 'persons'];
  });
  const { persons, meanFlow } = one.record.figures(time, kWindow, one.since);
  return [
    ...rows,
    [time, one.name, 'persons who crossed', persons, 'persons'],
    [time, one.name, 'mean flow', meanFlow, '1/s'],
  ];
}

/** All measures in one long table: time, measure, quantity, value and unit. */
export function allCsv(measures: Measures, names: readonly string[]): string {
  const { series, exits } = measures.evacuation;
  const out = series.samples.flatMap((s): Row[] => [
    [s.time, 'Evacuation', 'inside', s.inside, 'persons'],
    [s.time, 'Evacuation', 'out', s.out, 'persons'],
    ...exits.map((_, k): Row => [s.time, 'Evacuation', `out by ${names[k] ?? ''}`, s.byExit[k] ?? 0, 'persons']),
  ]);
  const header: Row = ['time [s]', 'measure', 'quantity', 'value', 'unit'];
  return textOf([header, ...measures.list.flatMap((one) => longRows(one, measures.time)), ...out]);
}
