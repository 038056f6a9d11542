import { describe, expect, it } from 'vitest';
import type { CrowdFrame } from '../protocol/messages';
import { CrowdUnpacker } from './crowd_unpacker';
import { kRowFloats } from '../model/studio_frame';

function crowdFrame(more: Partial<CrowdFrame>): CrowdFrame {
  return {
    count: 2,
    x0: -8,
    y0: 4,
    quantum: 0.5,
    x: new Uint16Array(),
    y: new Uint16Array(),
    stepX: new Int8Array(),
    stepY: new Int8Array(),
    jumped: new Uint32Array(),
    jumpedX: new Uint16Array(),
    jumpedY: new Uint16Array(),
    heading: new Uint8Array(2),
    headingFine: new Uint8Array(2),
    changed: new Uint32Array(),
    clip: new Uint8Array(),
    phase: new Uint8Array(2),
    phaseFine: new Uint8Array(2),
    near: new Uint32Array(),
    nearPlaces: new Float32Array(),
    nearPoses: new Int16Array(),
    ...more,
  };
}

const kFirst = crowdFrame({
  x: Uint16Array.of(4, 10),
  y: Uint16Array.of(0, 2),
  clip: Uint8Array.of(0, 1),
  phase: Uint8Array.of(64, 192),
});
const still = (more: Partial<CrowdFrame> = {}): CrowdFrame =>
  crowdFrame({ stepX: new Int8Array(2), stepY: new Int8Array(2), phase: Uint8Array.of(64, 192), ...more });

function started(): CrowdUnpacker {
  const unpacker = new CrowdUnpacker();
  unpacker.setClips([
    { seconds: 1, cyclic: true },
    { seconds: 2, cyclic: true },
    { seconds: 0.5, cyclic: false },
  ]);
  unpacker.unpack(kFirst, 10);
  return unpacker;
}

/** Fade, clip, phase, clip before, phase before. */
function played(rows: Float32Array, who: number): number[] {
  return Array.from(rows.subarray(kRowFloats * who + 3, kRowFloats * who + 8));
}

describe('CrowdUnpacker', () => {
  it('takes a whole frame, then steps and jumps', () => {
    const unpacker = started();
    const { x, y } = unpacker.unpack(
      still({
        stepX: Int8Array.of(-3, 0),
        stepY: Int8Array.of(1, 0),
        jumped: Uint32Array.of(1),
        jumpedX: Uint16Array.of(40),
        jumpedY: Uint16Array.of(60),
      }),
      10.02,
    );
    expect([Array.from(x), Array.from(y)]).toEqual([
      [-7.5, 12],
      [4.5, 34],
    ]);
    const next = unpacker.unpack(still({ stepX: Int8Array.of(0, -1) }), 10.04);
    expect(Array.from(next.x)).toEqual([-7.5, 11.5]);
    expect(Array.from(x)).toEqual([-7.5, 12]);
  });

  it('reads headings and phases, fine or as the middle of what is told', () => {
    const unpacker = started();
    const fine = unpacker.unpack(
      still({ heading: Uint8Array.of(64, 0), headingFine: Uint8Array.of(128, 0), phaseFine: Uint8Array.of(128, 0) }),
      10.1,
    );
    expect(fine.rows[2]).toBeCloseTo((2 * Math.PI * 64.5) / 256);
    expect(fine.rows[5]).toBeCloseTo(64.5 / 256);
    const coarse = unpacker.unpack(still({ headingFine: new Uint8Array(), phaseFine: new Uint8Array() }), 10.2);
    expect(coarse.rows[2]).toBeCloseTo(Math.PI / 256);
    expect(coarse.rows[kRowFloats + 5]).toBeCloseTo(192.5 / 256);
  });

  it('lets the clip before fade in a fifth of a second, going on by the pace of the new one', () => {
    const unpacker = started();
    const changed = unpacker.unpack(
      still({ changed: Uint32Array.of(1), clip: Uint8Array.of(0), phase: Uint8Array.of(64, 0) }),
      10.02,
    );
    expect(played(changed.rows, 1)).toEqual([1, 0, 0, 1, 0.75]);
    expect(played(changed.rows, 0)[0]).toBe(0);
    // A tenth of the new clip's second is a twentieth of the old one's two.
    const later = played(
      unpacker.unpack(still({ phase: Uint8Array.of(64, 25), phaseFine: Uint8Array.of(0, 154) }), 10.12).rows,
      1,
    );
    expect(later[0]).toBeCloseTo(0.5);
    expect(later[4]).toBeCloseTo(0.8, 3);
    const gone = played(unpacker.unpack(still({ phase: Uint8Array.of(64, 60) }), 10.23).rows, 1);
    expect(gone[0]).toBe(0);
  });

  it('fades nobody over a gap, a world begun anew, or where all is told', () => {
    for (const time of [11, 2]) {
      const rows = started().unpack(still({ changed: Uint32Array.of(1), clip: Uint8Array.of(0) }), time).rows;
      expect(played(rows, 1).slice(0, 2)).toEqual([0, 0]);
    }
    const unpacker = started();
    unpacker.unpack(still({ changed: Uint32Array.of(1), clip: Uint8Array.of(2) }), 10.02);
    expect(played(unpacker.unpack(kFirst, 10.04).rows, 1)[0]).toBe(0);
  });

  it('refuses steps of another crowd', () => {
    expect(() =>
      started().unpack(crowdFrame({ count: 3, stepX: new Int8Array(3), stepY: new Int8Array(3) }), 10.1),
    ).toThrow('3 characters after one of 2');
  });
});
