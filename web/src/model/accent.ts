// The accents of groups. The scene takes their colours from the palette, the panels from the style sheet.

const kAccents = ['blue', 'ember', 'green', 'plum', 'ochre', 'slate'] as const;
export type Accent = (typeof kAccents)[number];

/** The accent for a group's colour number; colours repeat after six. */
export function accentOf(colour: number): Accent {
  const count = kAccents.length;
  return kAccents[((colour % count) + count) % count]!;
}
