import { expect, it } from 'vitest';
import { lostText } from './lost_banner';

it('says what is safe and when the next attempt comes', () => {
  expect(lostText(14.2, 3)).toBe('The crowd waits. Your take is safe up to 0:14.2. Trying again in 3 s.');
  expect(lostText(-1, 3)).toBe('The crowd waits. Trying again in 3 s.');
  expect(lostText(-1, 0)).toBe('The crowd waits. Trying again now.');
});
