// A place that the browser keeps.

export interface KeptPlace {
  readonly id: string;
  readonly name: string;
  /** Last change, in seconds since 1970. */
  readonly changed: number;
  /** "64 × 48 m · 12 obstacles · 80 people". */
  readonly facts: string;
  readonly picture: Blob | null;
  /** Kept by itself, while somebody edited. */
  readonly auto: boolean;
}

/** "14:03". */
export function clockOf(changed: number): string {
  return new Date(changed * 1000).toLocaleTimeString('en-GB', { hour: '2-digit', minute: '2-digit' });
}

/** What it is called in lists. */
export function placeTitle({ name, changed, auto }: Pick<KeptPlace, 'name' | 'changed' | 'auto'>): string {
  return auto ? `Autosaved – ${name}, ${clockOf(changed)}` : name;
}

/** A name that no other has: "Town", "Town 2"... */
export function freeName(wanted: string, taken: readonly string[]): string {
  if (!taken.includes(wanted)) return wanted;
  const base = wanted.replace(/ \d+$/, '');
  for (let k = 2; ; ++k) if (!taken.includes(`${base} ${k}`)) return `${base} ${k}`;
}

/** Of a file with this place. */
export function fileNameOf(name: string): string {
  const plain = name
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, '-')
    .replace(/^-|-$/g, '');
  return `${plain || 'place'}.json`;
}
