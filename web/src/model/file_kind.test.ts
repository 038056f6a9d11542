import { describe, expect, it } from 'vitest';
import { kindOf, refusal, type FileKind } from './file_kind';

const bytes = (text: string): Uint8Array => Uint8Array.from(text, (one) => one.charCodeAt(0));

describe('the kind of a file', () => {
  const kFiles: readonly (readonly [FileKind, string])[] = [
    ['take', 'MUSTAKE\n\x03\0\0\0rest'],
    ['character', 'glTF\x02\0\0\0....' + '....JSON{"skins": [{"joints": []}]}'],
    ['scenery', 'glTF\x02\0\0\0'],
    ['character', '{ "asset": { "version": "2.0" }, "meshes": [], "skins": [ {} ] }'],
    ['scenery', '{ "asset": { "version": "2.0" }, "meshes": [], "skins": [] }'],
    ['obj', '# Blender\nmtllib a.mtl\no Cube\nv 1.0 -1 0.5\nvn 0 0 1\nf 1 1 1\n'],
    ['unknown', 'v 1 2 3\nhello there\nv 2 3 4\n'],
    ['scenario', '{"format": "muster-scenario", "box": []}'],
    ['geojson', '{"type": "LineString", "coordinates": []}'],
    ['picture', '\x89PNG\r\n\x1a\n'],
    ['picture', '\xff\xd8\xff\xe0..JFIF'],
    ['picture', 'RIFF\0\0\0\0WEBPVP8 '],
    ['picture', '<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"/>'],
    ['scenario', '\xef\xbb\xbf  {"name": "x", "groups": []}'],
    ['gestures', '{ "events": [] }'],
    ['geojson', '{"type" : "FeatureCollection", "features": []}'],
    ['map', 'type octile\nheight 4\n'],
    ['motion', 'HIERARCHY\nROOT Hips'],
    ['empty', ''],
    ['unknown', 'hello'],
    ['unknown', '{"a": 1}'],
    ['unknown', '\0\0\0\0'],
  ];

  it.each(kFiles)('is %s by its content: %j', (kind, text) => {
    expect(kindOf(bytes(text))).toBe(kind);
  });

  it('has one sentence that names the file wherever the studio does not open it', () => {
    for (const [kind] of kFiles) {
      const text = refusal(kind, 'town.x');
      if (!['gestures', 'motion', 'empty', 'unknown'].includes(kind)) expect(text).toBeNull();
      else expect(text).toMatch(/^“town\.x” .*\.$/);
    }
  });
});
