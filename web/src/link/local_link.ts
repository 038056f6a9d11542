// Links to what lies on the studio's server: short, and they open while it runs.

import { ask } from './answers';
import { fragmentOf, type SharedKind } from './shared_link';

/** What is shared: `fragment` names it on the server, `path` reads it whole. */
export interface SharedThing {
  readonly kind: SharedKind;
  readonly title: string;
  readonly fragment: string;
  readonly path: string;
}

export interface LocalLink {
  readonly link: string;
  /** Only this computer can open it. */
  readonly here: boolean;
  /** The whole thing in a link to a site; empty where no site is known, or it is too large. */
  readonly site: string;
  /** Rows of the QR code of what others can open; empty for none. */
  readonly code: readonly string[];
}

interface Invited {
  readonly links: readonly string[];
  readonly site?: string;
}

async function codeOf(text: string): Promise<readonly string[]> {
  const answer = await ask(`code?text=${encodeURIComponent(text)}`);
  return answer.ok ? ((await answer.json()) as { code: string[] }).code : [];
}

async function siteLink(site: string, { kind, path }: SharedThing): Promise<string> {
  if (!site || !('CompressionStream' in globalThis)) return '';
  const answer = await ask(path);
  if (!answer.ok) return '';
  const fragment = await fragmentOf({ kind, bytes: new Uint8Array(await answer.arrayBuffer()) });
  return fragment === null ? '' : new URL(fragment, site).href;
}

/** Throws where the server does not answer. */
export async function localLink(thing: SharedThing): Promise<LocalLink> {
  const answer = await ask('invitation.json', { cache: 'no-store' });
  const invited = (answer.ok ? await answer.json() : { links: [] }) as Invited;
  const open = invited.links[0];
  const base = open ?? new URL('./', document.baseURI).href;
  const link = `${base}#${thing.fragment}`;
  const site = await siteLink(invited.site ?? '', thing);
  const shown = open ? link : site;
  return { link, here: !open, site, code: shown === '' ? [] : await codeOf(shown) };
}
