import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { ClientMessage, Places, PlacesAsk } from '../../protocol/messages';
import { PlaceAsker } from './place_asker';

let sent: Extract<ClientMessage, { type: 'AskPlaces' }>[];
let hear: (message: Places) => void;
let asker: PlaceAsker;

const places = new Float64Array(0);
const ask = (x: number): PlacesAsk => ({ group: 1, formation: null, x, y: 0, facing: 0, places, count: 0 });
const answer = (number: number): Places => ({
  type: 'Places',
  number,
  answers: [{ group: 1, places: Float32Array.of(1, 2), unfit: Uint8Array.of(0), problem: '' }],
});

beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  asker = new PlaceAsker({
    send: (message) => message.type === 'AskPlaces' && sent.push(message),
    on: (_, listener) => (hear = listener),
  });
});
afterEach(() => vi.useRealTimers());

it('has one question out at a time, and of wishes keeps the newest', () => {
  const heard: string[] = [];
  asker.ask([ask(1)], () => heard.push('first'));
  asker.ask([ask(2)], () => heard.push('second'));
  asker.ask([ask(3)], () => heard.push('third'));
  expect(sent.map(({ asks }) => asks[0]!.x)).toEqual([1]);
  hear(answer(sent[0]!.number));
  expect(heard).toEqual(['first']);
  vi.advanceTimersByTime(200);
  expect(sent.map(({ asks }) => asks[0]!.x)).toEqual([1, 3]);
  hear(answer(sent[0]!.number));
  expect(heard).toEqual(['first']);
  hear(answer(sent[1]!.number));
  expect(heard).toEqual(['first', 'third']);
});

it('goes on after a question that nobody answers, and hears nothing that was dropped', () => {
  let heard = 0;
  asker.ask([ask(1)], () => (heard += 1));
  asker.drop();
  hear(answer(sent[0]!.number));
  expect(heard).toBe(0);
  vi.advanceTimersByTime(200);
  asker.ask([ask(2)], () => (heard += 1));
  asker.ask([ask(3)], () => (heard += 1));
  vi.advanceTimersByTime(2000);
  expect(sent.map(({ asks }) => asks[0]!.x)).toEqual([1, 2, 3]);
  hear(answer(sent[2]!.number));
  expect(heard).toBe(1);
});
