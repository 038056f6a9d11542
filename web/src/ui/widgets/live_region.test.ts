// @vitest-environment jsdom
import { expect, it, vi } from 'vitest';
import { LiveRegion } from './live_region';

it('speaks the newest text, and the same text again', () => {
  vi.useFakeTimers();
  const region = new LiveRegion();
  const heard: string[] = [];
  const say = (...texts: string[]): void => {
    texts.forEach((text) => region.say(text));
    vi.advanceTimersByTime(300);
    heard.push(region.root.textContent ?? '');
  };
  say('Point on Blue', 'Line on Blue');
  expect(heard[0]).toBe('Line on Blue');
  say('Pinned');
  say('Pinned');
  say('Pinned');
  expect(new Set(heard.slice(1, 3)).size).toBe(2);
  expect(heard[3]).not.toBe(heard[2]);
  expect(heard.map((text) => text.trim())).toEqual(['Line on Blue', 'Pinned', 'Pinned', 'Pinned']);
});
