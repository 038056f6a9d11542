// Pictures of the people of a take without what is around them, one PNG with transparency for each moment.

import { filmSteps, type OpenTake } from '../../model/take_facts';
import type { FilmWish } from './film_maker';
import { ZipStore } from './zip_store';

/** What the maker needs of the page. */
export interface SeriesSource {
  /** Shows that step of the take. */
  show(step: number): Promise<void>;
  /** Draws the people before a dark and a bright background onto the two canvases. */
  drawPeople(dark: HTMLCanvasElement, bright: HTMLCanvasElement): Promise<void>;
}

/**
 * The picture that looks like `dark` before black and like `bright` before white: what differs between them shines
 * through. It is written to `dark`.
 */
export function cutOut(dark: Uint8ClampedArray, bright: Uint8ClampedArray): void {
  for (let i = 0; i < dark.length; i += 4) {
    const through = bright[i]! - dark[i]! + bright[i + 1]! - dark[i + 1]! + bright[i + 2]! - dark[i + 2]!;
    const alpha = Math.max(0, Math.min(1, 1 - through / 765));
    for (let c = 0; c < 3; ++c) dark[i + c] = alpha > 0 ? dark[i + c]! / alpha : 0;
    dark[i + 3] = Math.round(255 * alpha);
  }
}

function canvasOf({ width, height }: FilmWish): HTMLCanvasElement {
  return Object.assign(document.createElement('canvas'), { width, height });
}

export class PictureSeries {
  private cancelled_ = false;

  constructor(private readonly source_: SeriesSource) {}

  cancel(): void {
    this.cancelled_ = true;
  }

  /** A ZIP; null where it was cancelled. */
  async make(take: OpenTake, wish: FilmWish, progress: (share: number) => void): Promise<Blob | null> {
    const [dark, bright] = [canvasOf(wish), canvasOf(wish)];
    const steps = filmSteps(take, wish.fps);
    const zip = new ZipStore();
    for (const [i, step] of steps.entries()) {
      if (this.cancelled_) return null;
      await this.source_.show(step);
      await this.source_.drawPeople(dark, bright);
      await zip.add(`picture-${String(i + 1).padStart(5, '0')}.png`, await this.picture(dark, bright));
      progress((i + 1) / steps.length);
    }
    return zip.finish();
  }

  private async picture(dark: HTMLCanvasElement, bright: HTMLCanvasElement): Promise<Blob> {
    const { width, height } = dark;
    const [pen, other] = [dark, bright].map((canvas) => canvas.getContext('2d', { willReadFrequently: true })!);
    const pixels = pen!.getImageData(0, 0, width, height);
    cutOut(pixels.data, other!.getImageData(0, 0, width, height).data);
    pen!.putImageData(pixels, 0, 0);
    const blob = await new Promise<Blob | null>((done) => dark.toBlob(done, 'image/png'));
    if (!blob) throw new Error('This browser makes no pictures of that size.');
    return blob;
  }
}
