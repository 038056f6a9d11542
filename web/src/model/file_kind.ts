// What a file is, by what stands in it: names lie.

export type FileKind =
  | 'take'
  | 'character'
  | 'scenery'
  | 'picture'
  | 'scenario'
  | 'gestures'
  | 'geojson'
  | 'map'
  | 'obj'
  | 'motion'
  | 'empty'
  | 'unknown';

/** So much of a file is looked at [bytes]. */
const kHead = 65536;
/** So much where that does not tell: a glTF has its skins anywhere in its JSON. */
const kWhole = 64 << 20;

const kSignatures: readonly (readonly [kind: FileKind, bytes: string])[] = [
  ['take', 'MUSTAKE\n'],
  ['picture', '\x89PNG\r\n'],
  ['picture', '\xff\xd8\xff'],
  ['picture', 'GIF8'],
  ['picture', 'BM'],
];

/** Bodies have skins; without one a model is scenery. */
const gltfKind = (text: string): FileKind => (/"skins"\s*:\s*\[\s*\{/.test(text) ? 'character' : 'scenery');

const kGeoTypes = 'Feature|FeatureCollection|GeometryCollection|(Multi)?(Polygon|LineString|Point)';
const isGeoJson = new RegExp(`"type"\\s*:\\s*"(${kGeoTypes})"`);
const isGltf = (text: string): boolean =>
  /"asset"\s*:/.test(text) && /"(scenes?|nodes|meshes|buffers|accessors)"\s*:/.test(text);

function jsonKind(text: string): FileKind {
  if (/"format"\s*:\s*"muster-scenario"/.test(text)) return 'scenario';
  if (/"format"\s*:\s*"muster-gestures"/.test(text)) return 'gestures';
  if (isGeoJson.test(text)) return 'geojson';
  if (isGltf(text)) return gltfKind(text);
  if (/"groups"\s*:/.test(text)) return 'scenario';
  if (/"(events|gestures)"\s*:/.test(text)) return 'gestures';
  return 'unknown';
}

/** Lines of a Wavefront OBJ: corners, among comments and names. */
function isObj(text: string): boolean {
  if (!/^v\s+-?[\d.]\S*\s+-?[\d.]\S*\s+-?[\d.]/m.test(text)) return false;
  const lines = text.split('\n').slice(0, 200);
  return lines.slice(0, -1).every((line) => /^\s*($|#|(v|vt|vn|vp|f|l|p|o|g|s|mg|usemtl|mtllib|usemap)\b)/.test(line));
}

const isGlb = (head: Uint8Array): boolean =>
  head.length >= 20 && [0x67, 0x6c, 0x54, 0x46].every((one, i) => head[i] === one);

/** How many bytes of a file that begins so tell what it is. */
function bytesThatTell(head: Uint8Array): number {
  // The length of the first chunk, its JSON.
  if (isGlb(head)) return Math.min(kWhole, 20 + new DataView(head.buffer, head.byteOffset).getUint32(12, true));
  const text = new TextDecoder().decode(head);
  return text.trimStart().startsWith('{') && isGltf(text) ? kWhole : head.length;
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
  if (bytes.startsWith('glTF')) return gltfKind(text);
  if (text.startsWith('{')) return jsonKind(text);
  if (/^<(\?xml|!DOCTYPE svg|svg)/i.test(text) && /<svg/i.test(text)) return 'picture';
  if (/^type\s+\w+\s*\n\s*(height|width)\b/.test(text) || /^type\s+octile/.test(text)) return 'map';
  if (text.startsWith('HIERARCHY')) return 'motion';
  return isObj(text) ? 'obj' : 'unknown';
}

/** Files of these kinds become a place, or part of one. */
export function isForPlaces(kind: FileKind): boolean {
  return kind === 'scenario' || kind === 'geojson' || kind === 'map' || kind === 'obj' || kind === 'scenery';
}

/** Why the studio does not open a file of this kind, and what does; null for those that it opens. */
export function refusal(kind: FileKind, name: string): string | null {
  const file = `“${name}”`;
  switch (kind) {
    case 'take':
    case 'character':
    case 'scenery':
    case 'picture':
    case 'scenario':
    case 'geojson':
    case 'map':
    case 'obj':
      return null;
    case 'gestures':
      return `${file} holds gestures: “muster play SCENARIO --gestures ${name}” plays them.`;
    case 'motion':
      return `${file} is recorded motion: a scenario names such files for its characters.`;
    case 'empty':
      return `${file} is empty.`;
    case 'unknown':
      return `${file} is no take, place, model, map or picture, which the studio opens.`;
  }
}

async function bytesOf(file: File, count: number): Promise<Uint8Array> {
  return new Uint8Array(await file.slice(0, count).arrayBuffer());
}

export async function kindOfFile(file: File): Promise<FileKind> {
  const head = await bytesOf(file, kHead);
  const needed = bytesThatTell(head);
  return kindOf(needed > head.length ? await bytesOf(file, needed) : head);
}
