import { expect, it } from 'vitest';
import { cutOut } from './picture_series';
import { ZipStore, crc32 } from './zip_store';

it('finds what shines through from a dark and a bright picture', () => {
  // A solid orange, nothing, and a shadow of half strength.
  const dark = Uint8ClampedArray.from([255, 128, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255]);
  const bright = Uint8ClampedArray.from([255, 128, 0, 255, 255, 255, 255, 255, 127, 127, 127, 255]);
  cutOut(dark, bright);
  expect([...dark]).toEqual([255, 128, 0, 255, 0, 0, 0, 0, 0, 0, 0, 128]);
});

it('puts files into an archive as they are', async () => {
  expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
  const zip = new ZipStore();
  await zip.add('a.png', new Blob(['first']));
  await zip.add('b.png', new Blob(['second file']));
  const bytes = new DataView(await zip.finish().arrayBuffer());
  const text = new TextDecoder('latin1').decode(bytes);
  const end = bytes.byteLength - 22;
  expect(bytes.getUint32(end, true)).toBe(0x06054b50);
  expect(bytes.getUint16(end + 10, true)).toBe(2);
  const list = bytes.getUint32(end + 16, true);
  expect(list + bytes.getUint32(end + 12, true)).toBe(end);
  expect(bytes.getUint32(list, true)).toBe(0x02014b50);
  const second = bytes.getUint32(list + 46 + 5 + 42, true);
  expect(text.slice(second + 30, second + 30 + 5 + 11)).toBe('b.pngsecond file');
});
