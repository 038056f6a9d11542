import { describe, expect, it } from 'vitest';
import { loadCrowd, type LoadedCrowd } from '../file/loaded_crowd';
import { madeFile, type MadeSample } from '../file/test_support';
import { CrowdMoment } from './crowd_moment';

/** Ten frames per second; the first clip goes round in 256 units, the second lasts 128. */
async function moment(frames: readonly (readonly MadeSample[])[]): Promise<[CrowdMoment, LoadedCrowd]> {
  const loaded = await loadCrowd(madeFile(frames), () => Promise.resolve());
  return [new CrowdMoment(loaded), loaded];
}

describe('CrowdMoment', () => {
  it('is between two frames, by place, heading the short way, and time of the clip over its end', async () => {
    const [now] = await moment([[{ id: 1, x: 0, yaw: 250, time: 240 }], [{ id: 1, x: 40, y: 20, yaw: 262, time: 4 }]]);
    now.goTo(0.025);
    expect(now.count).toBe(1);
    expect(now.x[0]).toBeCloseTo(0.05);
    expect(now.y[0]).toBeCloseTo(0.025);
    expect(Math.cos(now.yaw[0]! - (2 * Math.PI * 253) / 512)).toBeCloseTo(1, 6);
    expect(now.time[0]).toBeCloseTo(245);
    now.goTo(0.1);
    expect([now.x[0]!.toFixed(3), now.time[0]]).toEqual(['0.200', 4]);
    expect(now.things[0]).toBeCloseTo(0.1);
  });

  it('shows first and last frame for times outside, and a crowd of one frame', async () => {
    const [now] = await moment([[{ id: 1, x: 0 }], [{ id: 1, x: 40 }]]);
    for (const [time, x] of [
      [-5, 0],
      [99, 0.2],
      [NaN, 0],
    ] as const) {
      now.goTo(time);
      expect(now.x[0]).toBeCloseTo(x);
    }
    const [one] = await moment([[{ id: 1, x: 20 }]]);
    one.goTo(3);
    expect([one.count, one.x[0]!.toFixed(2)]).toEqual([1, '0.10']);
  });

  it('switches clips at the moment that the fade tells, and lets the clip before go on and fade', async () => {
    // 100 ms between frames; 12 / 15 of the clip before is left, so the switch was 40 ms ago, at 0.4 of the way from 0.2 s to 0.3 s:
    // the fade takes 200 ms.
    const [now] = await moment([
      [{ id: 1, x: 0, time: 0 }],
      [{ id: 1, x: 0, time: 20 }],
      [{ id: 1, x: 0, time: 40 }],
      [{ id: 1, x: 0, clip: 1, time: 64, fade: 12 }],
      [{ id: 1, x: 0, clip: 1, time: 84 }],
    ]);
    now.goTo(0.2 + 0.055);
    expect([now.clip[0], now.fade[0]]).toEqual([0, 0]);
    expect(now.time[0]).toBeCloseTo(51);
    now.goTo(0.2 + 0.065);
    expect([now.clip[0], now.fromClip[0]]).toEqual([1, 0]);
    expect(now.fade[0]).toBeCloseTo(0.8 + 0.035 / 0.2);
    expect(now.time[0]).toBeCloseTo(64 - 7);
    expect(now.fromTime[0]).toBeCloseTo(53);
    now.goTo(0.35);
    expect(now.fade[0]).toBeCloseTo(0.55);
    expect(now.time[0]).toBeCloseTo(74);
    expect(now.fromTime[0]).toBeCloseTo(70);
    now.goTo(0.4);
    expect(now.fade[0]).toBeCloseTo(0.3);
  });

  it('lets nobody glide who was put elsewhere', async () => {
    const [now] = await moment([[{ id: 1, x: 0 }], [{ id: 1, x: 4000 }]]);
    now.goTo(0.09);
    expect(now.x[0]).toBe(0);
    now.goTo(0.1);
    expect(now.x[0]).toBeCloseTo(20);
  });

  it('shows who comes from their first frame on, and who leaves until their last', async () => {
    const [now, { crowd }] = await moment([
      [{ id: 4, x: 0 }],
      [
        { id: 2, x: 1 },
        { id: 4, x: 0 },
      ],
      [{ id: 2, x: 1 }],
    ]);
    const shown = (time: number): number[] => {
      now.goTo(time);
      return Array.from({ length: now.count }, (_, i) => crowd.people[now.who[i]!]!.id);
    };
    expect(shown(0.05)).toEqual([4]);
    expect(shown(0.1)).toEqual([2, 4]);
    expect(shown(0.15)).toEqual([2]);
  });
});
