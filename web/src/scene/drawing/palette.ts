// The colours of the scene in both themes (the tests hold the contrasts).

import type { AreaKindWord } from '../../protocol/generated/words';
import { accentOf, chosenOf, type Accent } from '../../model/accent';
import { swatchOf } from '../../model/swatches';
import type { Theme } from '../../model/view_settings';
import { contrast } from './colour';

export interface Palette {
  readonly ground: string;
  readonly groundOutside: string;
  readonly lineFine: string;
  readonly lineCoarse: string;
  /** Where the ground ends, and the kerb beyond. */
  readonly edge: string;
  readonly kerb: string;
  /** Part of its light that ground keeps in shadow. */
  readonly shadowKeeps: number;
  readonly panel: string;
  readonly ink: string;
  readonly ink2: string;
  /** White round marks on the ground; near black in dark. */
  readonly casing: string;
  readonly onAccent: string;
  /** What cannot be. */
  readonly alarm: string;
  readonly water: string;
  readonly waterLine: string;
  readonly coping: string;
  readonly netFloor: string;
  readonly net: string;
  readonly brick: string;
  readonly brickLine: string;
  readonly plainFloor: string;
  /** Of exits, sources and waiting areas. */
  readonly areas: Readonly<Record<AreaKindWord, { readonly floor: string; readonly line: string }>>;
  readonly obstacleEdge: string;
  readonly roof: string;
  readonly roofHatch: string;
  readonly wall: string;
  /** What a wall shines by itself while it is made transparent. */
  readonly thinGlow: string;
  readonly crown: string;
  readonly trunk: string;
  readonly stone: string;
  readonly item: string;
  readonly carBodies: readonly string[];
  readonly glass: string;
  /** Shirts and marks while an overlay is on. */
  readonly grey: string;
  readonly accents: Readonly<Record<Accent, string>>;
  readonly ramp: readonly string[];
  readonly sun: number;
  readonly sky: number;
}

const kLight: Palette = {
  ground: '#E6E1D9',
  groundOutside: '#CFC9BD',
  lineFine: '#DDD7CE',
  lineCoarse: '#CCC6BC',
  edge: '#7C7568',
  kerb: '#F4F0E9',
  shadowKeeps: 0.7,
  panel: '#FFFFFF',
  ink: '#171B20',
  ink2: '#545C66',
  casing: '#FFFFFF',
  onAccent: '#FFFFFF',
  alarm: '#C3123A',
  water: '#A8CFDA',
  waterLine: '#2F7896',
  coping: '#D9D1C2',
  netFloor: '#E2D2AB',
  net: '#6A5A36',
  brick: '#D3B899',
  brickLine: '#7A604A',
  plainFloor: '#D8D2C6',
  areas: {
    exit: { floor: '#CFE3CE', line: '#1E7243' },
    source: { floor: '#D2DDEA', line: '#3A6A9E' },
    waiting: { floor: '#EADFBE', line: '#7D5F0E' },
  },
  obstacleEdge: '#777166',
  roof: '#EDE8DF',
  roofHatch: '#DAD4C9',
  wall: '#DDD6CA',
  thinGlow: '#000000',
  crown: '#9DBB8B',
  trunk: '#8A6D52',
  stone: '#E4DED2',
  item: '#E9B93A',
  carBodies: ['#C4BEB3', '#B5523F', '#7F93A8', '#5F8A7F'],
  glass: '#2B3640',
  grey: '#B4B0AC',
  accents: { blue: '#1D5FD1', ember: '#CB4A0E', green: '#016553', plum: '#87598B', ochre: '#624A02', slate: '#313C4B' },
  ramp: ['#F5F3C9', '#A1D1A3', '#4BA9A0', '#3A758F', '#3B4564'],
  sun: 1.95,
  sky: 1.6,
};

const kDark: Palette = {
  ground: '#21262C',
  groundOutside: '#14181D',
  lineFine: '#292F35',
  lineCoarse: '#353C43',
  edge: '#8793A0',
  kerb: '#3B444D',
  shadowKeeps: 0.6,
  panel: '#1F2429',
  ink: '#EEF1F4',
  ink2: '#B1B9C2',
  casing: '#0E1114',
  onAccent: '#0E1114',
  alarm: '#FF5C77',
  water: '#1D4A5C',
  waterLine: '#6FB6D2',
  coping: '#3A4148',
  netFloor: '#3E3829',
  net: '#C9B67F',
  brick: '#957A5F',
  brickLine: '#B99C82',
  plainFloor: '#2B3138',
  areas: {
    exit: { floor: '#1F3A2C', line: '#62C98A' },
    source: { floor: '#24354A', line: '#7FB2E6' },
    waiting: { floor: '#3B3421', line: '#D6B45A' },
  },
  obstacleEdge: '#A9B4BF',
  roof: '#505A64',
  roofHatch: '#5A646F',
  wall: '#707C88',
  thinGlow: '#808C98',
  crown: '#4C6644',
  trunk: '#5E4A39',
  stone: '#4A525B',
  item: '#F0C654',
  carBodies: ['#5D7389', '#A9553F', '#7D858E', '#3F7468'],
  glass: '#10151A',
  grey: '#6C737B',
  accents: { blue: '#74A9FF', ember: '#FF8A4C', green: '#90FBC9', plum: '#AC6BAA', ochre: '#FBE24F', slate: '#B7BCC2' },
  ramp: ['#1E2744', '#17566E', '#238881', '#82B185', '#D6D4AA'],
  sun: 1.9,
  sky: 1.5,
};

export function paletteOf(theme: Theme): Palette {
  return theme === 'dark' ? kDark : kLight;
}

/** A group's colour in this palette: the chosen one, else its accent's. */
export function accentColour(palette: Palette, colour: number): string {
  const chosen = chosenOf(colour);
  if (!chosen) return palette.accents[accentOf(colour)];
  return (palette === kDark ? swatchOf(chosen)?.dark : null) ?? chosen;
}

const kInks = ['#FFFFFF', '#000000'] as const;

/** For words on a group's colour: the palette's ink, the other where an own colour hides it. */
export function inkOn({ onAccent }: Palette, accent: string): string {
  if (contrast(accent, onAccent) >= 4.5) return onAccent;
  return contrast(accent, kInks[0]) > contrast(accent, kInks[1]) ? kInks[0] : kInks[1];
}

/** What marks of a group's colour are cased in, so that they stand out from it. */
export function casingOf({ casing }: Palette, accent: string): string {
  if (contrast(accent, casing) >= 2) return casing;
  return casing === kInks[0] ? kInks[1] : kInks[0];
}
