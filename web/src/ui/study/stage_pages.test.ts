// @vitest-environment jsdom
import { expect, it, vi } from 'vitest';
import { StudyStage, TrialEnd, type StudyState } from '../../protocol/messages';
import { endText, readyPage } from './stage_pages';
import { TrialBar } from './trial_bar';

const kState: StudyState = {
  type: 'StudyState',
  stage: StudyStage.Ready,
  token: 't',
  run: 3,
  test: true,
  trial: 2,
  trials: 10,
  practice: false,
  environment: 'Corridor',
  environmentText: 'Two rooms.',
  scheme: 'mouse-paper',
  schemeTitle: 'Mouse, as in the paper',
  schemeText: '',
  touch: false,
  mesh: false,
  items: 24,
  limit: 300,
  least: 0,
  mmPerPixel: 0.28,
  ended: TrialEnd.None,
  seconds: 0,
  collected: 0,
};

it('says how the last trial went', () => {
  expect(endText(kState)).toBe('');
  expect(endText({ ...kState, ended: TrialEnd.Done, seconds: 61.25 })).toBe('All items collected in 1:01.2.');
  expect(endText({ ...kState, ended: TrialEnd.TimeOver, collected: 20 })).toContain('20 of 24');
});

it('starts the next trial once, however often it is pressed', () => {
  const start = vi.fn();
  const page = readyPage(kState, start);
  const button = page.querySelector('button')!;
  button.click();
  button.click();
  expect(start).toHaveBeenCalledTimes(1);
  expect(page.textContent).toContain('Use the mouse.');
  expect(page.textContent).toContain('Part 2 of 10');
});

it('asks once more before a trial is given up, but not in practice', () => {
  const give = vi.fn();
  const bar = new TrialBar(give, () => undefined);
  bar.show(kState);
  bar.update(12.34, 7);
  expect(bar.root.textContent).toContain('0:12.3');
  expect(bar.root.textContent).toContain('7 / 24');
  const button = bar.root.querySelector('button')!;
  button.click();
  expect(give).not.toHaveBeenCalled();
  button.click();
  expect(give).toHaveBeenCalledTimes(1);
  bar.show({ ...kState, practice: true, least: 30 });
  bar.update(29, 0);
  expect(button.disabled).toBe(true);
  bar.update(30, 0);
  button.click();
  expect(give).toHaveBeenCalledTimes(2);
});
