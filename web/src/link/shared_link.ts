// A place or a take inside a link: compressed, after the `#`, so that no host ever sees it.

import { ask, byUs, hasEngine } from './answers';

export type SharedKind = 'place' | 'take';

export interface Shared {
  readonly kind: SharedKind;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Longer fragments are cut off by programs that pass links on [characters]. */
export const kMostFragment = 16000;
/** What a link may unpack to. */
const kMostBytes = 8 << 20;

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const answer = new Response(new Blob([bytes]).stream().pipeThrough(stream));
  return new Uint8Array(await answer.arrayBuffer());
}

function toText(bytes: Uint8Array): string {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function fromText(text: string): Uint8Array<ArrayBuffer> {
  const plain = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(plain, (c) => c.charCodeAt(0));
}

/** The fragment of a link, with its `#`; null where it would be too long. */
export async function fragmentOf({ kind, bytes }: Shared): Promise<string | null> {
  const text = toText(await through(bytes, new CompressionStream('deflate-raw')));
  const fragment = `#${kind}=${text}`;
  return fragment.length <= kMostFragment ? fragment : null;
}

/** What a link holds; null where it holds nothing. Throws a sentence where it is damaged. */
export async function sharedIn(fragment: string): Promise<Shared | null> {
  const found = /^#(place|take)=(.*)$/.exec(fragment);
  if (!found) return null;
  const kind = found[1] as SharedKind;
  try {
    const bytes = await through(fromText(found[2]!), new DecompressionStream('deflate-raw'));
    if (bytes.length > 0 && bytes.length <= kMostBytes) return { kind, bytes };
  } catch {
    // Told below.
  }
  throw new Error(`The ${kind} in this link is damaged: perhaps the link was cut off.`);
}

/** Opens what a link holds. Throws a sentence where it cannot be opened. */
export async function openShared({ kind, bytes }: Shared): Promise<void> {
  const answer = await ask(byUs(kind === 'place' ? 'scenario?name=shared' : 'take'), { method: 'POST', body: bytes });
  if (!answer.ok) throw new Error(`The ${kind} in this link could not be opened: ${(await answer.text()).trim()}`);
}

/** Puts a link to what lies at an address of ours on the clipboard; a sentence that says so, or why not. */
export async function copyLink(kind: SharedKind, path: string): Promise<string> {
  const answer = await ask(path);
  if (!answer.ok) return `The ${kind} could not be read.`;
  const fragment = await fragmentOf({ kind, bytes: new Uint8Array(await answer.arrayBuffer()) });
  if (fragment === null) return `This ${kind} is too large for a link: send its file instead.`;
  try {
    await navigator.clipboard.writeText(new URL(fragment, document.baseURI).href);
    return 'Link copied: it holds everything, nothing is uploaded.';
  } catch {
    return 'The link could not be copied.';
  }
}

/** True where a link opens for others: on a site. */
export function canShareLinks(): boolean {
  return hasEngine() && 'CompressionStream' in globalThis;
}
