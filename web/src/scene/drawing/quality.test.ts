import { describe, expect, it } from 'vitest';
import { chooseQuality } from './quality';

describe('quality', () => {
  it('goes by the renderer unless the address says', () => {
    expect(chooseQuality('', () => 'ANGLE (Mesa, llvmpipe (LLVM 15.0.6, 256 bits))')).toBe('light');
    expect(chooseQuality('', () => 'ANGLE (NVIDIA, GeForce RTX 3060)')).toBe('full');
    expect(chooseQuality('', () => '')).toBe('full');
    expect(chooseQuality('?quality=full', () => 'llvmpipe')).toBe('full');
    expect(chooseQuality('?quality=light', () => 'Apple M2')).toBe('light');
    expect(chooseQuality('?quality=best', () => 'Apple M2')).toBe('full');
  });
});
