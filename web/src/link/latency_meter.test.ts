import { describe, expect, it } from 'vitest';
import { LatencyMeter } from './latency_meter';

describe('LatencyMeter', () => {
  it('times a touch from its event to the first picture made of a frame that shows it', () => {
    const meter = new LatencyMeter();
    meter.touched(10);
    meter.touched(10.02);
    meter.echoed(9, 1, 10.005);
    expect(meter.takeDrawn(1)).toEqual([]);
    meter.echoed(10, 2, 10.015);
    meter.echoed(10.02, 3, 10.03);
    // The display runs behind: frame 2 has arrived, but is not in the picture yet.
    expect(meter.takeDrawn(1)).toEqual([]);
    meter.drawn(meter.takeDrawn(2), 10.03);
    meter.drawn(meter.takeDrawn(3), 10.05);
    expect(meter.samples).toEqual([
      { down: 10, received: 10.015, shown: 10.03 },
      { down: 10.02, received: 10.03, shown: 10.05 },
    ]);
  });
  it('counts nothing twice and nothing after a reset', () => {
    const meter = new LatencyMeter();
    meter.touched(1);
    meter.echoed(1, 1, 1);
    meter.drawn(meter.takeDrawn(1), 2);
    meter.echoed(1, 2, 2);
    expect(meter.takeDrawn(2)).toEqual([]);
    meter.touched(3);
    meter.reset();
    meter.echoed(4, 3, 4);
    expect(meter.takeDrawn(3)).toEqual([]);
  });
});
