import { describe, expect, it } from 'vitest';
import { chooseLayout } from './layout';

describe('chooseLayout', () => {
  it('follows the concept sizes', () => {
    expect(chooseLayout(1440, 900)).toBe('desktop');
    expect(chooseLayout(1280, 800)).toBe('desktop');
    expect(chooseLayout(1180, 820)).toBe('landscape');
    expect(chooseLayout(820, 1180)).toBe('portrait');
    expect(chooseLayout(390, 844)).toBe('phone');
    expect(chooseLayout(360, 640)).toBe('phone');
  });
  it('has one for small windows and 200 % zoom', () => {
    expect(chooseLayout(640, 400)).toBe('short');
    expect(chooseLayout(844, 390)).toBe('short');
    expect(chooseLayout(720, 600)).toBe('portrait');
  });
});
