// @vitest-environment jsdom
import { expect, it } from 'vitest';
import type { StageTimes } from '../../protocol/messages';
import { StageTable } from './stage_table';

const kTimes: StageTimes = {
  type: 'StageTimes',
  step: 60,
  total: 0.84,
  stages: [
    { name: 'commands', about: 'Applies the commands of this step.', milliseconds: 0.01 },
    { name: 'density', about: 'Counts everybody into the grid.', milliseconds: 0.4 },
    { name: 'events', about: 'Tells what happened.', milliseconds: 0.1 },
  ],
};

function rowsOf(table: StageTable): HTMLTableRowElement[] {
  return [...table.root.querySelectorAll('tbody tr')] as HTMLTableRowElement[];
}

it('is hidden until times come, and then tells the whole step in one line', () => {
  const table = new StageTable();
  expect(table.root.hidden).toBe(true);
  table.show(kTimes);
  expect([table.root.hidden, table.root.open]).toEqual([false, false]);
  expect(table.root.querySelector('summary')!.textContent).toBe('Times of a step: 0.84 ms');
});

it('has a row for each stage in the order of the step, with its sentence, time and bar', () => {
  const table = new StageTable();
  table.show(kTimes);
  const rows = rowsOf(table);
  expect(rows.map((row) => [...row.cells].map((cell) => cell.textContent))).toEqual([
    ['commands', '0.010 ms'],
    ['density', '0.400 ms'],
    ['events', '0.100 ms'],
  ]);
  expect(rows.map((row) => row.title)).toEqual(kTimes.stages.map(({ about }) => about));
  expect(rows.map((row) => row.style.getPropertyValue('--share'))).toEqual(['0.025', '1.000', '0.250']);
  expect(table.root.querySelector('tfoot')!.textContent).toBe('Whole step0.840 ms');
});

it('names its rows and columns for those who cannot see them', () => {
  const table = new StageTable();
  table.show(kTimes);
  const { root } = table;
  expect(root.querySelector('table')!.getAttribute('aria-label')).toBe('Times of the stages of a step');
  expect([...root.querySelectorAll('thead th')].map((cell) => cell.getAttribute('scope'))).toEqual(['col', 'col']);
  expect(rowsOf(table).every((row) => row.cells[0]!.getAttribute('scope') === 'row')).toBe(true);
  expect(root.querySelector<HTMLElement>('.stage-scroll')!.tabIndex).toBe(0);
});

it('keeps its rows while the stages are the same', () => {
  const table = new StageTable();
  table.show(kTimes);
  const [first] = rowsOf(table);
  table.show({ ...kTimes, total: 1, stages: kTimes.stages.map((stage) => ({ ...stage, milliseconds: 0 })) });
  expect(rowsOf(table)[0]).toBe(first);
  expect(first!.cells[1]!.textContent).toBe('0.000 ms');
  expect(first!.style.getPropertyValue('--share')).toBe('0');
  table.show({ ...kTimes, stages: [...kTimes.stages, { name: 'scores', about: 'Counts.', milliseconds: 0 }] });
  expect(rowsOf(table).map((row) => row.cells[0]!.textContent)).toEqual(['commands', 'density', 'events', 'scores']);
});
