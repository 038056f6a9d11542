import { expect, it } from 'vitest';
import { fragmentOf, kMostFragment, sharedIn, type Shared } from './shared_link';

const place: Shared = {
  kind: 'place',
  bytes: new TextEncoder().encode(JSON.stringify({ format: 'muster-scenario', name: 'Köln', list: [1, 2, 3] })),
};

/** Bytes that cannot be compressed. */
function noise(count: number): Uint8Array<ArrayBuffer> {
  let state = 1;
  return Uint8Array.from({ length: count }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state >>> 24;
  });
}

it('holds a place or a take, byte for byte, in characters that every program passes on', async () => {
  for (const one of [place, { kind: 'take', bytes: noise(3000) } satisfies Shared]) {
    const fragment = await fragmentOf(one);
    expect(fragment).toMatch(/^#(place|take)=[\w-]+$/);
    expect(await sharedIn(fragment!)).toEqual(one);
  }
});

it('is not made where it would be too long', async () => {
  expect(await fragmentOf({ kind: 'take', bytes: noise(kMostFragment) })).toBeNull();
});

it('says so where it is damaged, and nothing where there is none', async () => {
  const fragment = (await fragmentOf(place))!;
  await expect(sharedIn(fragment.slice(0, -9))).rejects.toThrow('The place in this link is damaged');
  await expect(sharedIn('#take=!!!')).rejects.toThrow('The take in this link is damaged');
  await expect(sharedIn('#take=')).rejects.toThrow('damaged');
  expect(await sharedIn('#scenario=market')).toBeNull();
  expect(await sharedIn('')).toBeNull();
});
