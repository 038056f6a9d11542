import { describe, expect, it } from 'vitest';
import { cropAround } from './picture_crop';

describe('cropAround', () => {
  it('takes the middle where nobody is', () => {
    expect(cropAround([], 400, 800, 2)).toEqual({ x: 0, y: 300, width: 400, height: 200 });
    expect(cropAround([{ x: -5, y: 9 }], 400, 100, 2)).toEqual({ x: 100, y: 0, width: 200, height: 100 });
  });
  it('goes to the crowd, and stays in the picture', () => {
    const crowd = [
      { x: 20, y: 100 },
      { x: 140, y: 160 },
    ];
    expect(cropAround(crowd, 400, 800, 2)).toEqual({ x: 0, y: 80, width: 200, height: 100 });
  });
  it('shows a little crowd with its surroundings', () => {
    expect(cropAround([{ x: 300, y: 400 }], 400, 800, 2)).toEqual({ x: 220, y: 360, width: 160, height: 80 });
  });
});
