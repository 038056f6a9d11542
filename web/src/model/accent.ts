// The accents of groups, and colours that were chosen instead. The scene takes accents from the palette, the panels from the style
// sheet. A colour number is the index of an accent; with a chosen colour, that colour + (index + 1) * kChosen.

const kAccents = ['blue', 'ember', 'green', 'plum', 'ochre', 'slate'] as const;
export type Accent = (typeof kAccents)[number];
const kChosen = 0x1000000;

/** The accent for a group's colour number, which is its shape as well; accents repeat after six. */
export function accentOf(colour: number): Accent {
  const count = kAccents.length;
  const index = colour < kChosen ? colour : Math.floor(colour / kChosen) - 1;
  return kAccents[((index % count) + count) % count]!;
}

/** The colour number of a group of that accent with a chosen colour, `#rrggbb`; without one, the accent's. */
export function colourNumber(accent: number, chosen: string | undefined): number {
  if (!chosen || !/^#[0-9a-f]{6}$/i.test(chosen)) return accent;
  return withChosen(accent, numberOfColour(chosen));
}

/** The same for a colour as a number, 0xRRGGBB; null for none. */
export function withChosen(accent: number, chosen: number | null): number {
  return chosen === null ? accent : chosen + (accent + 1) * kChosen;
}

/** 0xRRGGBB of `#rrggbb`. */
export function numberOfColour(text: string): number {
  return Number.parseInt(text.slice(1), 16);
}

/** The chosen colour, `#RRGGBB`; null where the accent counts. */
export function chosenOf(colour: number): string | null {
  if (colour < kChosen) return null;
  return `#${(colour % kChosen).toString(16).padStart(6, '0').toUpperCase()}`;
}
