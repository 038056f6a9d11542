// @vitest-environment jsdom
import { h, render } from 'preact';
import { expect, it, vi } from 'vitest';
import { StudyStage, TrialEnd, type StudyState } from '../../protocol/messages';
import { TrialBar, type Moment } from './bars';
import { endText, StageCard } from './cards';

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

it('shows what comes next, and starts it once', () => {
  const root = document.createElement('div');
  const start = vi.fn(() => show(true));
  const show = (busy: boolean): void => render(h(StageCard, { state: kState, busy, act: start }), root);
  show(false);
  const button = root.querySelector('button')!;
  button.click();
  button.click();
  expect(start).toHaveBeenCalledTimes(1);
  expect(root.textContent).toContain('Use the mouse.');
  expect(root.textContent).toContain('Part 2 of 10');
});

it('has a card for every stage without a scene', () => {
  const root = document.createElement('div');
  for (const stage of [StudyStage.Paused, StudyStage.Elsewhere, StudyStage.Thanks, StudyStage.BrokenOff]) {
    render(h(StageCard, { state: { ...kState, stage }, busy: false, act: () => undefined }), root);
    expect(root.querySelector('h1')!.textContent).not.toBe('Muster');
    expect(root.querySelector('.study-next')).not.toBeNull();
  }
});

it('asks once more before a trial is given up, but not in practice', async () => {
  const root = document.createElement('div');
  const giveUp = vi.fn();
  const show = (state: StudyState, change: Partial<Moment>): HTMLButtonElement => {
    const moment = { time: 0, playing: true, speed: 1, collected: 0, ...change };
    render(h(TrialBar, { key: state.trial, state, moment, giveUp, stop: () => undefined }), root);
    return root.querySelector('button')!;
  };
  const button = show(kState, { time: 12.34, collected: 7 });
  expect(root.textContent).toContain('0:12.3');
  expect(root.textContent).toContain('7 / 24');
  button.click();
  expect(giveUp).not.toHaveBeenCalled();
  await new Promise((done) => setTimeout(done));
  expect(button.textContent).toBe('Really give up?');
  button.click();
  expect(giveUp).toHaveBeenCalledTimes(1);
  const practice = { ...kState, trial: 3, practice: true, least: 30 };
  expect(show(practice, { time: 29 }).disabled).toBe(true);
  show(practice, { time: 30 }).click();
  expect(giveUp).toHaveBeenCalledTimes(2);
});
