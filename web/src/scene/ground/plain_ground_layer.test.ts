import { describe, expect, it } from 'vitest';
import { paletteOf } from '../drawing/palette';
import { between, PlainGroundLayer } from './plain_ground_layer';

describe('PlainGround', () => {
  it('rules lines strictly inside the box', () => {
    expect(between(-10, 10, 5)).toEqual([-5, 0, 5]);
    expect(between(-0.5, 2.5, 1)).toEqual([0, 1, 2]);
    expect(between(3, 3, 1)).toEqual([]);
  });

  it('draws every metre once, the fifth ones thicker, and hides the fine ones from afar', () => {
    const ground = new PlainGroundLayer();
    ground.setPalette(paletteOf('light'));
    ground.setBox({ min: [-10, -5], max: [10, 5] });
    const counts = ground.group.children
      .slice(1, 4)
      .map((child) => (child as unknown as { geometry: { instanceCount: number } }).geometry.instanceCount);
    // 19 + 9 lines inside; 3 + 1 of them at multiples of five; four edges.
    expect(counts).toEqual([24, 4, 4]);
    ground.setScale(40);
    expect(ground.group.children[1]?.visible).toBe(true);
    ground.setScale(3);
    expect(ground.group.children[1]?.visible).toBe(false);
    ground.dispose();
  });
});
