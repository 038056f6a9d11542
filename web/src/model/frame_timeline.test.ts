import { describe, expect, it } from 'vitest';
import { FrameTimeline } from './frame_timeline';
import { madeFrame } from './test_frames';

describe('FrameTimeline', () => {
  it('has nothing before the first frame and holds a lone one', () => {
    const timeline = new FrameTimeline();
    expect(timeline.sample(0)).toBeNull();
    timeline.push(madeFrame(1, [0]), 1000);
    const blend = timeline.sample(1500);
    expect(blend?.from.frame).toBe(1);
    expect(blend?.to.frame).toBe(1);
    expect(blend?.alpha).toBe(0);
  });

  it('with even arrivals shows even motion, about one frame late', () => {
    const timeline = new FrameTimeline();
    const shown: number[] = [];
    for (let i = 0; i < 200; ++i) {
      timeline.push(madeFrame(i, [i]), 1000 + 20 * i);
      if (i < 150) continue;
      for (const part of [5, 15]) {
        const blend = timeline.sample(1000 + 20 * i + part);
        if (!blend) throw new Error('nothing shown');
        const at = (blend.from.x[0] ?? 0) + ((blend.to.x[0] ?? 0) - (blend.from.x[0] ?? 0)) * blend.alpha;
        shown.push(at);
        expect(i + part / 20 - at).toBeGreaterThan(0.5);
        expect(i + part / 20 - at).toBeLessThan(1.6);
      }
    }
    for (let i = 1; i < shown.length; ++i) expect((shown[i] ?? 0) - (shown[i - 1] ?? 0)).toBeCloseTo(0.5, 1);
  });

  it('never shows what lies beyond the newest frame', () => {
    const timeline = new FrameTimeline();
    for (let i = 0; i < 20; ++i) timeline.push(madeFrame(i, [i]), 1000 + 20 * i);
    const blend = timeline.sample(9000);
    expect(blend?.from.frame).toBe(19);
    expect(blend?.alpha).toBe(0);
  });

  it('goes on smoothly through jitter', () => {
    const timeline = new FrameTimeline();
    let last = -1;
    let largest = 0;
    let next = 0;
    for (let t = 0; t < 6000; t += 8) {
      // Frames every 16 ms arrive up to 10 ms late.
      while (next * 16 + ((next * 7) % 11) <= t) {
        timeline.push(madeFrame(next, [next]), next * 16 + ((next * 7) % 11));
        ++next;
      }
      const blend = timeline.sample(t);
      if (!blend) continue;
      const at = (blend.from.x[0] ?? 0) + ((blend.to.x[0] ?? 0) - (blend.from.x[0] ?? 0)) * blend.alpha;
      if (t > 3000) {
        expect(at).toBeGreaterThanOrEqual(last - 1e-9);
        largest = Math.max(largest, at - last);
      }
      last = at;
    }
    expect(largest).toBeLessThan(1);
  });

  it('starts anew after a stall', () => {
    const timeline = new FrameTimeline();
    for (let i = 0; i < 30; ++i) timeline.push(madeFrame(i, [i]), 1000 + 16 * i);
    timeline.push(madeFrame(30, [30]), 9000);
    const blend = timeline.sample(9000 + timeline.delay + 1);
    expect(blend?.from.frame).toBe(30);
    timeline.clear();
    expect(timeline.newest).toBeNull();
  });
});
