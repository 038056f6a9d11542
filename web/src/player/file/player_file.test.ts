import { describe, expect, it } from 'vitest';
import { loadCrowd } from './loaded_crowd';
import { crc32, readPlayerFile } from './player_file';
import { DamagedFile } from './range_decoder';
import { joined, madeFile, madeParts, type MadeSample } from './test_support';

const kFrames: MadeSample[][] = [
  [
    { id: 3, x: 100, y: 20, yaw: 500, time: 10, colour: 1 },
    { id: 9, x: -400 },
  ],
  [
    { id: 3, x: 120, y: 20, yaw: 510, time: 30, colour: 1 },
    { id: 9, x: -400 },
  ],
  [
    { id: 3, x: 140, y: 21, yaw: 515, time: 50, colour: 0 },
    { id: 5, x: 7, y: 8, clip: 1, time: 64 },
    { id: 9, x: -400, clip: 1, time: 5, fade: 9 },
  ],
  [
    { id: 5, x: 8, y: 8, clip: 1, time: 90 },
    { id: 9, x: -401, clip: 1, time: 30 },
  ],
];

const soon = (): Promise<void> => Promise.resolve();

async function failure(bytes: Uint8Array): Promise<string> {
  try {
    await loadCrowd(bytes, soon);
  } catch (error) {
    if (error instanceof DamagedFile) return error.message;
    throw error;
  }
  return '';
}

describe('the file of a player', () => {
  it('gives back who is where in each frame, and what they play', async () => {
    const { crowd, head, scene, figures, clips, duration } = await loadCrowd(madeFile(kFrames), soon);
    expect(duration).toBeCloseTo(0.3);
    expect(head.title).toBe('Made');
    expect(Array.from(crowd.first)).toEqual([0, 2, 4, 7, 9]);
    const ids = Array.from(crowd.who, (who) => crowd.people[who]!.id);
    expect(ids).toEqual([3, 9, 3, 9, 3, 5, 9, 5, 9]);
    expect(Array.from(crowd.before)).toEqual([-1, -1, 0, 1, 2, -1, 3, 5, 6]);
    kFrames.flat().forEach(({ x, y = 0, yaw = 0, time = 0, clip = 0, colour = 0 }, k) => {
      expect(crowd.x[k]).toBeCloseTo(0.005 * x);
      expect(crowd.y[k]).toBeCloseTo(0.005 * y);
      expect(Math.cos(crowd.yaw[k]! - (2 * Math.PI * yaw) / 512)).toBeCloseTo(1);
      expect([crowd.time[k], crowd.clip[k], crowd.colour[k]]).toEqual([time, clip, colour]);
    });
    expect(crowd.switched[6]).toBe(1);
    expect(crowd.fade[6]).toBeCloseTo(9 / 15);
    expect(crowd.fade[8]).toBeCloseTo(9 / 15 - 0.5);
    expect([crowd.things[0], crowd.things[3], crowd.things[9]].map((x) => x!.toFixed(2))).toEqual([
      '0.00',
      '0.10',
      '0.30',
    ]);
    expect(scene.still.positions.length / 9).toBe(2);
    expect(scene.moving[0]!.positions.length / 9).toBe(8);
    expect(figures.bodies[1]).toBeNull();
    expect(Array.from(figures.bodies[0]!.fine.weights)).toEqual([255, 0, 0, 0, 200, 55, 0, 0, 200, 55, 0, 0]);
    expect(clips.map(({ poses, cyclic }) => [poses, cyclic])).toEqual([
      [4, true],
      [2, false],
    ]);
    expect(clips[0]!.hips[11]).toBeCloseTo(0.93);
  });

  it('has the usual checksum', () => {
    expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
  });

  it('says what is wrong with other files, newer ones, cut ones and damaged ones', async () => {
    const file = madeFile(kFrames);
    expect(await failure(new TextEncoder().encode('<!doctype html>'))).toBe('this is no file of a Muster player');
    expect(await failure(new Uint8Array(0))).toBe('this is no file of a Muster player');
    expect(await failure(joined(madeParts(kFrames), 3))).toBe(
      'found version 3, expected 2: a newer muster-player.js is needed',
    );
    expect(await failure(file.subarray(0, 12))).toBe('found its end too early');
    expect(await failure(file.subarray(0, file.length - 1))).toBe(
      `found ${file.length - 1} bytes, expected ${file.length}`,
    );
    const flipped = file.slice();
    flipped[200]! ^= 4;
    expect(await failure(flipped)).toBe('its checksum does not fit');
    const { land, ...others } = madeParts(kFrames);
    expect(land).toBeDefined();
    expect(await failure(joined(others))).toBe('found no part “land”');
  });

  it('refuses heads with impossible numbers, and says which', async () => {
    const wrong: readonly [Record<string, unknown>, string][] = [
      [{ fps: 0 }, 'fps: found 0, expected 0.1 to 1000'],
      [{ frames: 1e9 }, 'frames: found 1000000000, expected 1 to 1048576'],
      [{ samples: 1e12 }, 'samples: found 1000000000000, expected 0 to 8388608'],
      [{ clips: 1.5 }, 'clips: found 1.5, expected 0 to 4096'],
      [{ colours: ['red'] }, 'colours: found "red", expected a colour'],
      [{ box: [0, 0, 0, 1] }, 'box: expected four edges'],
      [{ camera: {} }, 'turn: found nothing, expected -10 to 10'],
      [{ most: 2 }, 'characters who come: found 1, expected 0 to 0'],
      [{ samples: 8 }, 'found more characters than told'],
      [{ samples: 10 }, 'found 9 positions, expected 10'],
      [{ things: 0 }, 'found 1 moving things, expected 0'],
    ];
    for (const [head, sentence] of wrong) expect(await failure(joined(madeParts(kFrames, head)))).toBe(sentence);
  });

  it('never hangs nor shows nonsense, whatever is damaged behind a checksum that fits', async () => {
    let seed = 12345;
    const random = (below: number): number => {
      seed = (Math.imul(seed, 1103515245) + 12345) >>> 0;
      return Math.floor((seed / 2 ** 32) * below);
    };
    const parts = madeParts(kFrames);
    let refused = 0;
    for (let round = 0; round < 300; ++round) {
      const tag = ['body', 'clip', 'land', 'crwd'][round % 4]!;
      const part = parts[tag]!.slice(0, round % 5 === 0 ? random(parts[tag]!.length) : undefined);
      for (let k = random(3) + 1; k > 0 && part.length > 0; --k) part[random(part.length)]! ^= 1 << random(8);
      const said = await failure(joined({ ...parts, [tag]: part }));
      if (said !== '') ++refused;
      else {
        const { crowd } = await loadCrowd(joined({ ...parts, [tag]: part }), soon);
        for (const values of [crowd.x, crowd.y, crowd.yaw, crowd.fade, crowd.fromTime, crowd.things])
          expect(values.every(Number.isFinite)).toBe(true);
      }
    }
    expect(refused).toBeGreaterThan(150);
  });

  it('skips parts that it does not know', () => {
    const file = readPlayerFile(joined({ more: Uint8Array.of(1, 2, 3), ...madeParts(kFrames) }));
    expect(file.head.frames).toBe(4);
  });
});
