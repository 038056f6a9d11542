import { describe, expect, it } from 'vitest';
import { KeptWorld } from './kept_world';

/** A handover as src/studio/session/takes/handover.cpp writes it. */
function handover(world: number, takeFrom: number, take: number[], rest: number[]): Uint8Array {
  const bytes = new Uint8Array(32 + take.length + rest.length);
  const view = new DataView(bytes.buffer);
  bytes.set(new TextEncoder().encode('MUSTHAND'));
  view.setUint32(8, 1, true);
  view.setUint32(12, world, true);
  view.setBigUint64(16, BigInt(takeFrom), true);
  view.setUint32(24, take.length, true);
  view.setUint32(28, rest.length, true);
  bytes.set(take, 32);
  bytes.set(rest, 32 + take.length);
  return bytes;
}

describe('the kept world', () => {
  it('puts the pieces of a take together, with the newest rest', () => {
    const kept = new KeptWorld();
    expect(kept.whole()).toBeNull();
    expect(kept.query).toBe('handover?world=0&take=0');
    kept.add(handover(4, 0, [1, 2, 3], [9]));
    expect(kept.query).toBe('handover?world=4&take=3');
    kept.add(handover(4, 3, [4], [8, 8]));
    kept.add(handover(4, 4, [], [7]));
    expect(kept.whole()).toEqual(handover(4, 0, [1, 2, 3, 4], [7]));
  });

  it('begins again with another world', () => {
    const kept = new KeptWorld();
    kept.add(handover(4, 0, [1, 2, 3], [9]));
    kept.add(handover(5, 0, [6], [5]));
    expect(kept.query).toBe('handover?world=5&take=1');
    expect(kept.whole()).toEqual(handover(5, 0, [6], [5]));
  });

  it('refuses other bytes and keeps what it has', () => {
    const kept = new KeptWorld();
    const good = handover(4, 0, [1, 2, 3], [9]);
    kept.add(good);
    const newer = good.slice();
    newer[8] = 2;
    for (const bad of [new Uint8Array(0), good.slice(0, 20), good.slice(0, -1), newer, new Uint8Array(40)]) {
      expect(() => kept.add(bad)).toThrow('handover');
    }
    expect(() => kept.add(handover(4, 2, [3], [9]))).toThrow('something else');
    expect(() => kept.add(handover(5, 3, [3], [9]))).toThrow('something else');
    expect(kept.whole()).toEqual(good);
  });
});
