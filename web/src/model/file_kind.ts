// What a file is, by what stands in it: names lie.

export type FileKind =
  'take' | 'character' | 'picture' | 'scenario' | 'gestures' | 'geojson' | 'map' | 'motion' | 'empty' | 'unknown';

/** So much of a file is looked at [bytes]. */
export const kHead = 65536;

const kSignatures: readonly (readonly [kind: FileKind, bytes: string])[] = [
  ['take', 'MUSTAKE\n'],
  ['character', 'glTF'],
  ['picture', '\x89PNG\r\n'],
  ['picture', '\xff\xd8\xff'],
  ['picture', 'GIF8'],
  ['picture', 'BM'],
];

function jsonKind(text: string): FileKind {
  if (/"type"\s*:\s*"(Feature|FeatureCollection|GeometryCollection|Polygon|MultiPolygon)"/.test(text)) return 'geojson';
  if (/"asset"\s*:/.test(text) && /"(scenes?|nodes|meshes|buffers|accessors)"\s*:/.test(text)) return 'character';
  if (/"groups"\s*:/.test(text)) return 'scenario';
  if (/"(events|gestures)"\s*:/.test(text)) return 'gestures';
  return 'unknown';
}

/** The kind of a file that begins with these bytes. */
export function kindOf(head: Uint8Array): FileKind {
  if (head.length === 0) return 'empty';
  const bytes = Array.from(head.subarray(0, 16), (byte) => String.fromCharCode(byte)).join('');
  for (const [kind, signature] of kSignatures) if (bytes.startsWith(signature)) return kind;
  if (bytes.startsWith('RIFF') && bytes.slice(8, 12) === 'WEBP') return 'picture';
  const text = new TextDecoder()
    .decode(head)
    .replace(/^\uFEFF/, '')
    .trimStart();
  if (text.startsWith('{')) return jsonKind(text);
  if (/^<(\?xml|!DOCTYPE svg|svg)/i.test(text) && /<svg/i.test(text)) return 'picture';
  if (/^type\s+octile/.test(text)) return 'map';
  if (text.startsWith('HIERARCHY')) return 'motion';
  return 'unknown';
}

/** Why the studio does not open a file of this kind, and what does; null for those that it opens. */
export function refusal(kind: FileKind, name: string): string | null {
  const file = `“${name}”`;
  switch (kind) {
    case 'take':
    case 'character':
    case 'picture':
      return null;
    case 'scenario':
      return `${file} is a scenario: the studio opens it when it is started by “muster studio ${name}”.`;
    case 'gestures':
      return `${file} holds gestures: “muster play SCENARIO --gestures ${name}” plays them.`;
    case 'geojson':
      return `${file} holds GeoJSON, which Muster does not open: give its ground as obstacles of a scenario.`;
    case 'map':
      return `${file} is a grid map: “muster import ${name} -o place.json” makes a scenario of it.`;
    case 'motion':
      return `${file} is recorded motion: a scenario names such files for its characters.`;
    case 'empty':
      return `${file} is empty.`;
    case 'unknown':
      return `${file} is no take, glTF character or picture, which the studio opens.`;
  }
}
