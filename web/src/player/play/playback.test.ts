import { describe, expect, it } from 'vitest';
import { clockText, Playback, type PlaybackEvent } from './playback';

function made(duration: number): [Playback, PlaybackEvent[]] {
  const events: PlaybackEvent[] = [];
  return [new Playback(duration, (event) => events.push(event)), events];
}

describe('Playback', () => {
  it('plays to the end, tells of it, and begins again', () => {
    const [playback, events] = made(1);
    playback.advance(0.1);
    expect(playback.time).toBe(0);
    playback.play();
    playback.play();
    for (let k = 0; k < 30; ++k) playback.advance(0.05);
    expect([playback.time, playback.paused, playback.ended]).toEqual([1, true, true]);
    expect(events.filter((event) => event !== 'timeupdate')).toEqual(['play', 'pause', 'ended']);
    const told = events.filter((event) => event === 'timeupdate').length;
    expect(told).toBeGreaterThan(3);
    expect(told).toBeLessThan(8);
    playback.play();
    expect(playback.time).toBe(0);
  });

  it('goes round where it loops, at its speed', () => {
    const [playback, events] = made(2);
    playback.loop = true;
    playback.speed = 4;
    playback.play();
    for (let k = 0; k < 6; ++k) playback.advance(0.1);
    expect(playback.time).toBeCloseTo(0.4);
    expect(events).not.toContain('ended');
  });

  it('goes on where it was after a long sleep, and seeks within its length', () => {
    const [playback] = made(60);
    playback.play();
    playback.advance(3600);
    expect(playback.time).toBeLessThan(1);
    for (const [wish, time] of [
      [-3, 0],
      [99, 60],
      [NaN, 0],
      [12.5, 12.5],
    ] as const) {
      playback.seek(wish);
      expect(playback.time).toBe(time);
    }
  });

  it('stays where a file of one frame is', () => {
    const [playback] = made(0);
    playback.loop = true;
    playback.play();
    playback.advance(0.1);
    expect(playback.time).toBe(0);
  });

  it('shows times as clocks', () => {
    expect([0, 7.99, 60, 1234].map(clockText)).toEqual(['0:00', '0:07', '1:00', '20:34']);
  });
});
