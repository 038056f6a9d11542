import { describe, expect, it } from 'vitest';
import { filled } from '../../protocol/encoding';
import type { PeopleDef } from '../../protocol/generated/commands';
import { kAdults, meanOf, respread, sortOf, spreadTrouble, spreadWords, type Spreading } from './people';

const kNormal: Spreading = { spread: 'normal', a: 1.34, b: 0.26, least: 0.5, most: 2.2 };

describe('A sort of persons', () => {
  it('has what is drawn, and leaves the rest to the bodies of its group', () => {
    const def = filled<PeopleDef>('PeopleDef', {
      name: 'Old',
      share: 2,
      speed: { a: 1 },
      age: { spread: 'uniform', b: 80 },
    });
    const sort = sortOf(def);
    const shares = { upstairs: 0, downstairs: 0 };
    expect(sort).toEqual({ name: 'Old', share: 2, unitClass: 0, ...shares, speed: def.speed, age: def.age });
  });
  it('is that of adults where it is just that', () => {
    const adults = sortOf(filled<PeopleDef>('PeopleDef', { name: kAdults.name, speed: kAdults.speed }));
    expect(JSON.stringify(adults)).toBe(JSON.stringify(kAdults));
  });
});

describe('A spread', () => {
  it('keeps its mean about where it was when its kind changes', () => {
    for (const spread of ['constant', 'uniform', 'normal', 'logNormal', 'gamma', 'weibull'] as const) {
      const made = respread('speed', kNormal, spread)!;
      expect(Math.abs(meanOf(made) - 1.34)).toBeLessThan(0.05);
      expect(spreadTrouble('speed', made)).toBe('');
    }
    expect(respread('age', undefined, 'normal')).toMatchObject({ a: 45, b: 15 });
    expect(respread('age', kNormal, undefined)).toBeUndefined();
  });
  it('is told in a few words', () => {
    expect(spreadWords('speed', kNormal)).toBe('1.34 ± 0.26 m/s');
    expect(spreadWords('premovement', { ...kNormal, spread: 'uniform', a: 10, b: 100 })).toBe('10 to 100 s');
    expect(spreadWords('radius', { ...kNormal, spread: 'constant', a: 0.25 })).toBe('0.25 m');
  });
  it('is refused by one sentence where it is bad', () => {
    expect(spreadTrouble('speed', { ...kNormal, b: 0 })).toBe('The speed needs a second number above 0.');
    expect(spreadTrouble('speed', { ...kNormal, least: 3 })).toBe('The least speed is not below the largest one.');
    expect(spreadTrouble('radius', { ...kNormal, spread: 'uniform', a: 0.3, b: 0.2 })).toMatch('ends below');
    expect(spreadTrouble('age', { ...kNormal, spread: 'constant', a: 120 })).toBe(
      'The age is to lie within 5 and 90 years.',
    );
    expect(spreadTrouble('speed', kNormal)).toBe('');
  });
});
