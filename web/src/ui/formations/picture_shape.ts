// A picture or an SVG file as places, upright as it is seen.

import { maskOfPixels, readSize } from '../../model/picture_mask';
import type { GroundPoint } from '../../model/plane';
import { spreadOver } from '../../model/spread';
import { element } from '../widgets/dom';
import { svgPlaces } from './svg_shape';

/** A picture is read with at most so many pixels on a side. */
const kMostPixels = 400;
/** A larger drawing is not read [bytes]. */
const kMostBytes = 4 << 20;

export type PictureAnswer =
  | { readonly places: readonly GroundPoint[]; readonly gap: number }
  /** Why there are none. */
  | { readonly why: string };

async function pixelPlaces(file: File, count: number): Promise<PictureAnswer> {
  const picture = await createImageBitmap(file).catch(() => null);
  if (!picture) return { why: `“${file.name}” is no picture that this browser can read.` };
  const { width, height } = readSize(picture.width, picture.height, kMostPixels);
  const pen = element('canvas', { width, height }).getContext('2d', { willReadFrequently: true });
  pen?.drawImage(picture, 0, 0, width, height);
  picture.close();
  const data = pen?.getImageData(0, 0, width, height).data ?? [];
  const spread = spreadOver(maskOfPixels(data, width, height), count);
  if (spread.places.length >= Math.max(1, count)) return spread;
  return { why: `“${file.name}” has too little that is dark for ${count} people: dark is where they stand.` };
}

export async function picturePlaces(file: File, count: number): Promise<PictureAnswer> {
  const isSvg = file.type === 'image/svg+xml' || /\.svg$/i.test(file.name);
  if (!isSvg) return pixelPlaces(file, count);
  if (file.size > kMostBytes) return { why: `“${file.name}” is larger than 4 MB: simplify it.` };
  const read = await svgPlaces(await file.text(), count);
  return read ?? { why: `“${file.name}” has no lines or areas for ${count} people.` };
}
