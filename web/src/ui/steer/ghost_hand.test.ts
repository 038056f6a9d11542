// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { StudioStore } from '../../model/studio_store';
import { GhostHand, ghostWay } from './ghost_hand';

const spot = { x: 3, y: 4, facing: Math.PI / 2 };
let store: StudioStore;
let frames: ((now: number) => void)[];

beforeEach(() => {
  document.body.replaceChildren();
  store = new StudioStore();
  frames = [];
  vi.stubGlobal('requestAnimationFrame', (one: (now: number) => void) => frames.push(one));
  vi.stubGlobal('matchMedia', () => ({ matches: false }));
  store.set({ hint: true });
});

afterEach(() => vi.unstubAllGlobals());

function play(until: number): void {
  for (let now = 100; now < until; now += 50) for (const one of frames.splice(0)) one(now);
}

it('drags once ahead, and is gone afterwards', () => {
  new GhostHand(document.body, store, { worldToScreen: ({ x, y }) => ({ x: 10 * x, y: 10 * y }) }, () => spot);
  play(2600);
  expect(document.querySelector('.ghost')).not.toBeNull();
  const points = document.querySelector('.ghost polyline')!.getAttribute('points')!.split(' ');
  expect(points[0]).toBe('30.0,40.0');
  play(6000);
  expect(document.querySelector('.ghost')).toBeNull();
  const end = ghostWay(spot, 1);
  expect([end.x, end.y].map((one) => Math.round(one * 10) / 10)).toEqual([3, 11]);
});

it('goes at the first press, and never comes without the hint', () => {
  new GhostHand(document.body, store, { worldToScreen: (at) => at }, () => spot);
  play(2600);
  window.dispatchEvent(new Event('pointerdown'));
  expect(document.querySelector('.ghost')).toBeNull();
  store.set({ hint: false });
  new GhostHand(document.body, store, { worldToScreen: (at) => at }, () => spot);
  play(2600);
  expect(document.querySelector('.ghost')).toBeNull();
});
