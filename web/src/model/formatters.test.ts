import { describe, expect, it } from 'vitest';
import {
  formatClock,
  formatCount,
  formatFigure,
  formatLength,
  formatMs,
  formatSpeed,
  scaleBarMetres,
} from './formatters';

describe('formatters', () => {
  it('write clocks', () => {
    expect(formatClock(14.2)).toBe('0:14.2');
    expect(formatClock(0)).toBe('0:00.0');
    expect(formatClock(59.99)).toBe('0:59.9');
    expect(formatClock(75.5)).toBe('1:15.5');
    expect(formatClock(-1)).toBe('0:00.0');
  });
  it('write milliseconds and figures', () => {
    expect(formatMs(6.24)).toBe('6.2');
    expect(formatMs(123.4)).toBe('123');
    expect(formatMs(NaN)).toBe('–');
    expect(formatFigure(0.836)).toBe('0.84');
    expect(formatFigure(12.34)).toBe('12.3');
    expect(formatFigure(250.2)).toBe('250');
    expect(formatLength(Infinity)).toBe('–');
    expect(formatLength(28.24)).toBe('28.2');
  });
  it('write counts and speeds', () => {
    expect(formatCount(100)).toBe('100');
    expect(formatCount(12345)).toBe('12\u2009345');
    expect(formatCount(1234567)).toBe('1\u2009234\u2009567');
    expect(formatSpeed(1)).toBe('1×');
    expect(formatSpeed(0.25)).toBe('0.25×');
  });
});

describe('scaleBarMetres', () => {
  it('fits 1, 2 or 5 times a power of ten', () => {
    expect(scaleBarMetres(30, 160)).toBe(5);
    expect(scaleBarMetres(100, 160)).toBe(1);
    expect(scaleBarMetres(80, 160)).toBe(2);
    expect(scaleBarMetres(1, 160)).toBe(100);
    expect(scaleBarMetres(400, 160)).toBeCloseTo(0.2);
  });
});
