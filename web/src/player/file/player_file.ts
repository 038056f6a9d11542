// The parts of a player's file, and what its head says. The layout is that of src/files/export/player/player_format.h.

import { DamagedFile } from './range_decoder';

const kMagic = 'MUSTERPL';
const kVersion = 2;
/** Of files before there were exits, sources and waiting areas. */
const kOldest = 1;
const kHeadBytes = 20;
const kPartBytes = 8;
/** What a page can hold. */
const kMostFrames = 1 << 20;
const kMostSamples = 8 << 20;
const kMostAtOnce = 1 << 20;
const kMostClips = 4096;
const kMostThings = 4096;

/** Direction of the camera: turned from +y to the left, looking down, vertical angle of view [rad]. */
export interface CameraHint {
  readonly turn: number;
  readonly pitch: number;
  readonly angle: number;
}

export interface PlayerHead {
  readonly title: string;
  /** Frames per second. */
  readonly fps: number;
  readonly frames: number;
  /** Characters in the fullest frame, and in all frames together. */
  readonly most: number;
  readonly samples: number;
  readonly clips: number;
  readonly things: number;
  /** Shirts: number of an accent, or `#rrggbb`. */
  readonly colours: readonly (number | string)[];
  /** Left, near, right and far edge of the ground [m]. */
  readonly box: readonly [number, number, number, number];
  readonly camera: CameraHint;
}

export interface PlayerFile {
  readonly head: PlayerHead;
  readonly body: Uint8Array;
  readonly clip: Uint8Array;
  readonly land: Uint8Array;
  readonly crowd: Uint8Array;
}

const kTable = Uint32Array.from({ length: 256 }, (_, n) => {
  let value = n;
  for (let k = 0; k < 8; ++k) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

/** CRC-32 (IEEE 802.3). */
export function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = kTable[(crc ^ byte) & 255]! ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** Reads the parts. Throws DamagedFile with what is wrong. */
export function readPlayerFile(bytes: Uint8Array): PlayerFile {
  checkFrame(bytes);
  const parts = partsOf(bytes);
  const part = (tag: string): Uint8Array => {
    const found = parts.get(tag);
    if (!found) throw new DamagedFile(`found no part “${tag}”`);
    return found;
  };
  return {
    head: readHead(part('head')),
    body: part('body'),
    clip: part('clip'),
    land: part('land'),
    crowd: part('crwd'),
  };
}

function checkFrame(bytes: Uint8Array): void {
  const magic = String.fromCharCode(...bytes.subarray(0, kMagic.length));
  if (magic !== kMagic) throw new DamagedFile('this is no file of a Muster player');
  if (bytes.length < kHeadBytes) throw new DamagedFile('found its end too early');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const version = view.getUint32(8, true);
  if (version > kVersion)
    throw new DamagedFile(`found version ${version}, expected ${kVersion}: a newer muster-player.js is needed`);
  if (version < kOldest) throw new DamagedFile(`found version ${version}, expected ${kVersion}`);
  const length = view.getUint32(12, true);
  if (bytes.length !== length) throw new DamagedFile(`found ${bytes.length} bytes, expected ${length}`);
  if (crc32(bytes.subarray(kHeadBytes)) !== view.getUint32(16, true))
    throw new DamagedFile('its checksum does not fit');
}

function partsOf(bytes: Uint8Array): Map<string, Uint8Array> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts = new Map<string, Uint8Array>();
  for (let at = kHeadBytes; at < bytes.length;) {
    if (at + kPartBytes > bytes.length) throw new DamagedFile('found its end too early');
    const size = view.getUint32(at + 4, true);
    const from = at + kPartBytes;
    if (from + size > bytes.length) throw new DamagedFile('found its end too early');
    parts.set(String.fromCharCode(...bytes.subarray(at, at + 4)), bytes.subarray(from, from + size));
    at = from + size;
  }
  return parts;
}

function readHead(bytes: Uint8Array): PlayerHead {
  let value: unknown;
  try {
    value = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new DamagedFile('its head is no JSON');
  }
  if (typeof value !== 'object' || value === null) throw new DamagedFile('its head is no object');
  const head = value as Record<string, unknown>;
  const camera = (head['camera'] ?? {}) as Record<string, unknown>;
  const frames = number(head, 'frames', 1, kMostFrames, true);
  return {
    title: typeof head['title'] === 'string' ? head['title'] : '',
    fps: number(head, 'fps', 0.1, 1000),
    frames,
    most: number(head, 'most', 0, kMostAtOnce, true),
    samples: number(head, 'samples', 0, kMostSamples, true),
    clips: number(head, 'clips', 0, kMostClips, true),
    things: number(head, 'things', 0, kMostThings, true),
    colours: readColours(head['colours']),
    box: readBox(head['box']),
    camera: {
      turn: number(camera, 'turn', -10, 10),
      pitch: number(camera, 'pitch', 0.05, Math.PI / 2),
      angle: number(camera, 'angle', 0.01, 2.5),
    },
  };
}

function number(of: Record<string, unknown>, key: string, least: number, most: number, whole = false): number {
  const value = of[key];
  if (typeof value !== 'number' || !(value >= least && value <= most) || (whole && !Number.isInteger(value)))
    throw new DamagedFile(`${key}: found ${JSON.stringify(value) ?? 'nothing'}, expected ${least} to ${most}`);
  return value;
}

function readColours(value: unknown): (number | string)[] {
  const colours: unknown[] = Array.isArray(value) ? value : [];
  return colours.map((one) => {
    if (typeof one === 'number' && one >= 0 && one < 64) return one;
    if (typeof one === 'string' && /^#[0-9a-f]{6}$/i.test(one)) return one;
    throw new DamagedFile(`colours: found ${JSON.stringify(one)}, expected a colour`);
  });
}

function readBox(value: unknown): [number, number, number, number] {
  const box: unknown[] = Array.isArray(value) ? value : [];
  const [left, near, right, far] = box;
  const all = [left, near, right, far];
  const fine = all.every((one): one is number => typeof one === 'number' && Math.abs(one) < 1e6);
  if (!fine || !(all[0]! < all[2]!) || !(all[1]! < all[3]!)) throw new DamagedFile('box: expected four edges');
  return [all[0]!, all[1]!, all[2]!, all[3]!];
}
