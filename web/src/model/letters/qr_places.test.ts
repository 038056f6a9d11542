import jsQR from 'jsqr';
import { expect, it } from 'vitest';
import type { GroundPoint } from '../plane';
import { leastDistance } from './stroke_places';
import { qrPlaces, type QrPlaces } from './qr_places';

const kAddress = 'https://example.org/meet';
/** A body is so wide, where neighbours stand 1 apart. */
const kBody = 0.9;
/** Samples of a pixel on each side. */
const kFine = 4;

function codeFor(address: string, count: number): QrPlaces {
  const answer = qrPlaces(address, count);
  if (!('code' in answer)) throw new Error(JSON.stringify(answer));
  return answer.code;
}

/** Round bodies on white from above, by a camera with so many pixels between neighbours. */
function pictureOf(places: readonly GroundPoint[], pitch: number) {
  const reach = Math.ceil(Math.max(...places.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]))) + 6;
  const size = Math.ceil(2 * reach * pitch);
  const data = new Uint8ClampedArray(4 * size * size).fill(255);
  const covered = new Float64Array(size * size);
  const step = 1 / (pitch * kFine);
  for (const { x, y } of places)
    for (let dx = -kBody / 2; dx <= kBody / 2; dx += step)
      for (let dy = -kBody / 2; dy <= kBody / 2; dy += step) {
        if (Math.hypot(dx, dy) > kBody / 2) continue;
        const at = Math.floor((reach - y + dy) * pitch) * size + Math.floor((x + dx + reach) * pitch);
        covered[at] = covered[at]! + 1 / kFine ** 2;
      }
  covered.forEach((share, i) => data.fill(255 - 215 * Math.min(1, share), 4 * i, 4 * i + 3));
  return { data, size };
}

/** A phone that is held nearer and nearer. */
function read(places: readonly GroundPoint[]): string | undefined {
  for (const pitch of [1.5, 2, 2.5, 3, 4]) {
    const { data, size } = pictureOf(places, pitch);
    const found = jsQR(data, size, size)?.data;
    if (found) return found;
  }
  return undefined;
}

it('is read from the places by another program, for every number of people', () => {
  for (const count of [350, 600, 700, 1000, 3000]) {
    const code = codeFor(kAddress, count);
    expect(code.places, `${count}`).toHaveLength(count);
    expect(leastDistance(code.places)).toBeCloseTo(1);
    expect(code.spare).toBeLessThan(0.3 * count);
    expect(read(code.places), `${count}`).toBe(kAddress);
  }
});

it('is read where a few people are missing, and not where half are', () => {
  const { places } = codeFor(kAddress, 700);
  expect(read(places.filter((_, i) => i % 230 !== 5))).toBe(kAddress);
  expect(read(places.filter((_, i) => i % 2 === 0))).toBeUndefined();
});

it('says how many people it needs, and which address is too long', () => {
  const answer = qrPlaces(kAddress, 49);
  const needs = 'needs' in answer ? answer.needs : 0;
  expect(needs).toBeGreaterThan(200);
  expect(needs).toBeLessThan(600);
  expect(codeFor(kAddress, needs).spare).toBe(0);
  expect(qrPlaces(kAddress, needs - 1)).toEqual({ needs });
  expect(qrPlaces(`https://example.org/${'a'.repeat(200)}`, 5000)).toHaveProperty('why');
});
