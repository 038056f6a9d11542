import { describe, expect, it } from 'vitest';
import { maskOfPixels, readSize } from './picture_mask';

describe('the mask of a picture', () => {
  it('holds what is dark and solid', () => {
    const black = [0, 0, 0, 255];
    const white = [255, 255, 255, 255];
    const clear = [0, 0, 0, 0];
    const red = [255, 0, 0, 255];
    const green = [0, 255, 0, 255];
    const mask = maskOfPixels([...black, ...white, ...clear, ...red, ...green, ...black], 3, 2);
    expect(Array.from(mask.cells)).toEqual([1, 0, 0, 1, 0, 1]);
    expect([mask.width, mask.height]).toEqual([3, 2]);
  });

  it('reads large pictures smaller, and never a side of no pixel', () => {
    expect(readSize(4000, 1000, 200)).toEqual({ width: 200, height: 50 });
    expect(readSize(100, 50, 200)).toEqual({ width: 100, height: 50 });
    expect(readSize(5000, 1, 200)).toEqual({ width: 200, height: 1 });
  });
});
