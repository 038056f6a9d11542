// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { GroundPoint } from '../model/plane';
import type { Contact, ContactOwner } from './contact';
import { GroundCursor } from './ground_cursor';
import { onScreen } from './test_support';

let told: string[];
let shown: GroundPoint | null;
let did: string[];
let panned: [number, number];
let picks: boolean;
let forecast: string;
let cursor: GroundCursor;

function owner(): ContactOwner {
  const at = ({ ground, screen }: Contact): string => `${ground!.x},${ground!.y} at ${screen.x},${screen.y}`;
  return {
    begin: (contact) => did.push(`begin ${at(contact)}`),
    move: (contacts) => did.push(`move ${at(contacts[contacts.length - 1]!)}`),
    end: (contact, cancelled) => did.push(`${cancelled ? 'cancel' : 'end'} ${at(contact)}`),
  };
}

beforeEach(() => {
  vi.useFakeTimers();
  [told, did, panned, picks, forecast, shown] = [[], [], [0, 0], false, '', null];
  cursor = new GroundCursor({
    view: {
      screenToWorld: ({ x, y }) => ({ x: (x + panned[0]) / 100, y: (y + panned[1]) / 100 }),
      worldToScreen: (at) => ({ x: onScreen(at).x - panned[0], y: onScreen(at).y - panned[1] }),
    },
    show: (at) => (shown = at),
    camera: { panBy: (x, y) => (panned = [panned[0] - x, panned[1] - y]) },
    room: () => ({ from: { x: 0, y: 0 }, to: { x: 400, y: 200 } }),
    choose: owner,
    picks: () => picks,
    words: ({ x, y }) => `${x} ${y}`,
    forecast: () => forecast,
    say: (text) => told.push(text),
  });
  return () => vi.useRealTimers();
});

it('stands in the middle of what is free, and arrows move it over the ground', () => {
  cursor.show();
  expect(shown).toEqual({ x: 2, y: 1 });
  cursor.arrow('ArrowRight', false);
  cursor.arrow('ArrowLeft', true);
  expect(shown).toEqual({ x: 0.5, y: 1 });
  expect(told[told.length - 1]).toBe('0.5 1');
});

it('draws from one Enter to the next', () => {
  cursor.press(false);
  cursor.arrow('ArrowRight', false);
  cursor.press(false);
  expect(did).toEqual(['begin 2,1 at 200,100', 'move 2.5,1 at 250,100', 'end 2.5,1 at 250,100']);
  expect(cursor.draws).toBe(false);
});

it('takes the camera along, and its stroke is no shorter for that', () => {
  cursor.press(false);
  for (let i = 0; i < 2; ++i) cursor.arrow('ArrowRight', true);
  expect(panned[0]).toBe(200);
  expect(did[did.length - 1]).toBe('move 6,1 at 600,100');
});

it('gives up what is drawn, once', () => {
  cursor.press(false);
  expect(cursor.giveUp()).toBe(true);
  expect(cursor.giveUp()).toBe(false);
  expect(did[1]).toBe('cancel 2,1 at 200,100');
});

it('picks by a single Enter', () => {
  picks = true;
  cursor.press(false);
  expect(did.length).toBe(2);
});

it('tells the forecast when it rests, also one that comes late', () => {
  cursor.press(false);
  vi.advanceTimersByTime(1000);
  forecast = 'in 0:07';
  vi.advanceTimersByTime(1000);
  expect(told[told.length - 1]).toBe('2 1: in 0:07');
});
