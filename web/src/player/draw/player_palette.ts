// The colours of a player's picture: the studio's, in linear light.

import { hexToRgb, srgbToLinear } from '../../scene/drawing/colour';
import { accentColour, paletteOf } from '../../scene/drawing/palette';
import { colourNumber } from '../../model/accent';
import type { Theme } from '../../model/view_settings';

export interface PlayerPalette {
  /** Four per finish, in the order of the exporter's: red, green, blue in linear light, opacity. */
  readonly finishes: Float32Array;
  readonly ground: Float32Array;
  readonly outside: Float32Array;
  readonly fine: Float32Array;
  readonly coarse: Float32Array;
  readonly edge: Float32Array;
  readonly trousers: Float32Array;
  readonly shadowKeeps: number;
  readonly disc: number;
  /** Strengths of sun and sky. */
  readonly sun: number;
  readonly sky: number;
}

/** Red, green, blue in linear light. */
export function linear(hex: string): Float32Array {
  return Float32Array.from(hexToRgb(hex), srgbToLinear);
}

const kTiles = { light: '#9CC6D3', dark: '#24505F' } as const;
const kShades = { light: '#C9CFB7', dark: '#2E362D' } as const;
const kTrousers = { light: '#1C2128', dark: '#9AA3AD' } as const;
const kTyre = '#1B1E22';
const kFur = '#B4B0AC';
const kSeeThrough = 0.6;

export function playerPalette(theme: Theme): PlayerPalette {
  const p = paletteOf(theme);
  const solid = [
    p.ground, p.wall, p.roof, p.stone, p.trunk, p.crown, p.crown, p.water, kTiles[theme], p.coping, p.netFloor, p.net,
    p.brick, p.plainFloor, kShades[theme], p.glass, kTyre, ...p.carBodies, kFur,
    p.areas.exit.floor, p.areas.source.floor, p.areas.waiting.floor,
  ]; // prettier-ignore
  const finishes = solid.flatMap((hex, k) => [...linear(hex), isSeeThrough(k) ? kSeeThrough : 1]);
  return {
    finishes: Float32Array.from(finishes),
    ground: linear(p.ground),
    outside: linear(p.groundOutside),
    fine: linear(p.lineFine),
    coarse: linear(p.lineCoarse),
    edge: linear(p.edge),
    trousers: linear(kTrousers[theme]),
    shadowKeeps: p.shadowKeeps,
    disc: theme === 'dark' ? 0.5 : 0.3,
    sun: p.sun,
    sky: p.sky,
  };
}

/** Leaves and water. */
export function isSeeThrough(finish: number): boolean {
  return finish === 6 || finish === 7;
}

/** A shirt: an accent's number, or a colour of its own. */
export function shirtColour(theme: Theme, colour: number | string): Float32Array {
  const number = typeof colour === 'number' ? colour : colourNumber(0, colour);
  return linear(accentColour(paletteOf(theme), number));
}
