// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { TakeMarkKind } from '../../protocol/messages';
import type { TakeActions } from '../../model/take_actions';
import type { OpenTake } from '../../model/take_facts';
import { kOpenTake } from '../../model/test_frames';
import { recordingActions } from '../widgets/test_support';
import { TimeLine } from './time_line';
import { rowsOf } from './time_track';

const take: OpenTake = {
  ...kOpenTake,
  title: 'Rain',
  marks: [{ kind: TakeMarkKind.Touch, step: 70, length: 30, label: 'touch' }],
};

let calls: string[];
let line: TimeLine;
const at = (name: string): HTMLElement => line.root.querySelector<HTMLElement>(name)!;

beforeEach(() => {
  calls = [];
  line = new TimeLine(recordingActions(calls) as unknown as TakeActions);
  document.body.replaceChildren(line.root);
  line.setTake(take, 'Rain');
  const track = at('.time-track');
  track.getBoundingClientRect = () => new DOMRect(100, 0, 600, 48);
});

function pointer(type: string, x: number): void {
  const event = new MouseEvent(type, { clientX: x, bubbles: true, button: 0 });
  Object.defineProperty(event, 'pointerId', { value: 1 });
  at('.time-track').dispatchEvent(event);
}

it('tells where the take stands, in words and as a slider', () => {
  line.setStep(240);
  expect(at('.time-clock').textContent).toBe('0:03.0 of 0:08.0');
  const head = at('.time-playhead');
  expect([head.getAttribute('aria-valuenow'), head.getAttribute('aria-valuetext')]).toEqual(['240', '0:03.0']);
  expect(head.getAttribute('aria-description')).toBe('1 touch');
  line.setTake(null, '');
  expect(line.root.hidden).toBe(true);
});

it('is scrubbed by a finger, both ways', () => {
  pointer('pointerdown', 400);
  pointer('pointermove', 300);
  pointer('pointerup', 300);
  expect(calls).toEqual(['beginScrub', 'seek 300', 'seek 200', 'endScrub']);
});

it('moves an end of the part, and tells it when the finger lifts', () => {
  pointer('pointerdown', 162);
  pointer('pointermove', 220);
  expect(calls).toEqual(['beginScrub', 'seek 120']);
  pointer('pointerup', 220);
  expect(calls.slice(2)).toEqual(['setPart 120 540', 'endScrub']);
});

it('is moved by keys', () => {
  const press = (name: string, key: string, shiftKey = false): void =>
    void at(name).dispatchEvent(new KeyboardEvent('keydown', { key, shiftKey, bubbles: true }));
  press('.time-playhead', 'ArrowRight');
  press('.time-playhead', 'ArrowRight', true);
  press('.time-playhead', 'Home');
  press('.time-to', 'ArrowLeft', true);
  expect(calls).toEqual(['seek 2', 'seek 62', 'seek 0', 'setPart 60 480', 'seek 480']);
});

it('makes parts slow and fast', () => {
  line.setStep(240);
  at('.time-speed').click();
  [...line.root.querySelectorAll<HTMLButtonElement>('.speed-add button')][0]!.click();
  expect(calls).toEqual(['setSpeeds [{"from":4,"to":6,"speed":0.5,"ease":0.3}]']);
  line.setTake({ ...take, speeds: [{ from: 4, to: 6, speed: 0.5, ease: 0.3 }] }, 'Rain');
  const select = line.root.querySelector('select')!;
  select.value = '4';
  select.dispatchEvent(new Event('change'));
  expect(calls.at(-1)).toBe('setSpeeds [{"from":4,"to":6,"speed":4,"ease":0.3}]');
});

it('offers to direct again, on top, and over and over', () => {
  at('.time-again').click();
  at('.time-layer').click();
  at('.time-loop').click();
  at('.time-close').click();
  expect(calls).toEqual(['takeAgain false', 'takeAgain true', 'setLoop true', 'leaveTake']);
});

it('gives each touch the lowest free row', () => {
  const touch = (step: number, length: number) => ({ kind: TakeMarkKind.Touch, step, length, label: '' });
  expect(rowsOf([touch(0, 100), touch(10, 20), touch(40, 10), touch(60, 5), touch(61, 90)])).toEqual([0, 1, 1, 1, 2]);
});

it('offers no change of a take that plays from its stored frames, and says why', () => {
  expect(at('.time-stored').hidden).toBe(true);
  line.setTake({ ...take, stored: true }, 'Rain');
  expect(at('.time-stored').hidden).toBe(false);
  expect(line.root.hasAttribute('data-stored')).toBe(true);
});

it('shows the part of a long take with some of what lies around it, in seconds of the part', () => {
  line.setTake({ ...take, steps: 60000, from: 48000, to: 49200 }, 'Late');
  line.setStep(48600);
  expect(at('.time-clock').textContent).toBe('0:10.0 of 0:20.0');
  const left = (name: string): number => parseFloat(at(name).style.left);
  expect(left('.time-from')).toBeCloseTo((100 * 144) / 1488, 3);
  expect(left('.time-playhead')).toBeCloseTo(50, 3);
  pointer('pointerdown', 400);
  expect(calls).toEqual(['beginScrub', 'seek 48600']);
  line.setStep(100);
  expect(at('.time-playhead').style.left).toBe('50%');
});
