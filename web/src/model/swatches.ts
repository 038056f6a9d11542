// The colours that groups are offered: each for light and for dark ground. Files keep the light one (src/lab/picture/swatches.cpp has
// the same pairs).

export interface Swatch {
  readonly name: string;
  readonly light: string;
  readonly dark: string;
  /** In the style sheet; the colour follows the theme. */
  readonly variable: string;
}

function swatch(name: string, light: string, dark: string, variable: string): Swatch {
  return { name, light, dark, variable };
}

export const kSwatches: readonly Swatch[] = [
  swatch('Blue', '#1D5FD1', '#74A9FF', '--group-blue'),
  swatch('Ember', '#CB4A0E', '#FF8A4C', '--group-ember'),
  swatch('Green', '#016553', '#90FBC9', '--group-green'),
  swatch('Plum', '#87598B', '#AC6BAA', '--group-plum'),
  swatch('Ochre', '#624A02', '#FBE24F', '--group-ochre'),
  swatch('Slate', '#313C4B', '#B7BCC2', '--group-slate'),
  swatch('Magenta', '#D60EA8', '#E47AD0', '--swatch-magenta'),
  swatch('Teal', '#05536D', '#17D7FF', '--swatch-teal'),
  swatch('Olive', '#6A7A42', '#7F8430', '--swatch-olive'),
  swatch('Violet', '#440E93', '#AA5AFC', '--swatch-violet'),
  swatch('Brown', '#5C1A0C', '#BD8B7F', '--swatch-brown'),
  swatch('Ink', '#08090B', '#FFFFFF', '--swatch-ink'),
];

/** The swatch of a chosen colour, `#rrggbb`; none for people's own. */
export function swatchOf(chosen: string): Swatch | undefined {
  const light = chosen.toUpperCase();
  return kSwatches.find((one) => one.light === light);
}
