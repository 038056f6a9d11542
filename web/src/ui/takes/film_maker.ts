// Makes a film of the open take in the page: every picture is sought, drawn and encoded (WebCodecs; MP4, or WebM where the
// browser does not encode H.264).

import { filmSteps, type OpenTake } from '../../model/take_facts';

export interface FilmWish {
  readonly fps: number;
  readonly width: number;
  readonly height: number;
}

export interface Film {
  readonly blob: Blob;
  /** "mp4" or "webm" */
  readonly ending: string;
}

/** What the maker needs of the page. */
export interface FilmSource {
  /** Shows that step of the take and draws the scene's picture of it onto the canvas. */
  draw(step: number, onto: HTMLCanvasElement): Promise<void>;
}

/** True where this browser can encode films. */
export function canMakeFilms(): boolean {
  return typeof VideoEncoder !== 'undefined';
}

export class FilmMaker {
  private cancelled_ = false;

  constructor(private readonly source_: FilmSource) {}

  cancel(): void {
    this.cancelled_ = true;
  }

  /** Null where it was cancelled. Throws a sentence where the browser cannot. */
  async make(take: OpenTake, wish: FilmWish, progress: (share: number) => void): Promise<Film | null> {
    const { beginFilm } = await import('./film_writer');
    const canvas = document.createElement('canvas');
    canvas.width = wish.width;
    canvas.height = wish.height;
    const writer = await beginFilm(canvas, wish.fps);
    const steps = filmSteps(take, wish.fps);
    for (const [i, step] of steps.entries()) {
      if (this.cancelled_) {
        await writer.cancel();
        return null;
      }
      if (step !== steps[i - 1]) await this.source_.draw(step, canvas);
      await writer.add();
      progress((i + 1) / steps.length);
    }
    return { blob: await writer.finish(), ending: writer.ending };
  }
}
