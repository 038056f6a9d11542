// A small picture of the scene as it is drawn now.

import type { StudioFrame } from '../model/studio_frame';
import type { StudioScene } from './studio_scene';
import { cropAround } from './picture_crop';

type PictureView = Pick<StudioScene, 'stats' | 'wake' | 'worldToScreen'>;

/** So many of the crowd tell where it is. */
const kSamples = 400;
/** A picture of what is kept that takes longer is done without [ms]. */
const kWait = 1500;

/** Calls `take` right after the next picture, while the canvas holds it. */
export function afterNextPicture(view: PictureView, take: () => void): void {
  const before = view.stats.afterPicture;
  view.stats.afterPicture = () => {
    view.stats.afterPicture = before;
    take();
    before?.();
  };
  view.wake();
}

/** The scene's next picture as PNG of that width and height, cut to the crowd; null where the browser cannot. */
export function takePicture(
  view: PictureView,
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
  crowd: Pick<StudioFrame, 'x' | 'y'> | null = null,
): Promise<Blob | null> {
  return new Promise((done) => {
    afterNextPicture(view, () => {
      const small = document.createElement('canvas');
      small.width = width;
      small.height = height;
      const context = small.getContext('2d');
      if (!context) return done(null);
      context.imageSmoothingQuality = 'high';
      const part = cropAround(spotsOf(view, canvas, crowd), canvas.width, canvas.height, width / height);
      context.drawImage(canvas, part.x, part.y, part.width, part.height, 0, 0, width, height);
      small.toBlob(done, 'image/png');
    });
  });
}

/** Of what is kept: small, and null where it takes too long. */
export function keptPicture(
  view: PictureView,
  canvas: HTMLCanvasElement,
  crowd: Pick<StudioFrame, 'x' | 'y'> | null = null,
): Promise<Blob | null> {
  const late = new Promise<null>((done) => window.setTimeout(() => done(null), kWait));
  return Promise.race([takePicture(view, canvas, 320, 180, crowd), late]);
}

/** Where the crowd stands on the canvas [its px]. */
function spotsOf(
  view: PictureView,
  canvas: HTMLCanvasElement,
  crowd: Pick<StudioFrame, 'x' | 'y'> | null,
): { x: number; y: number }[] {
  if (!crowd) return [];
  const ratio = canvas.width / Math.max(1, canvas.clientWidth);
  const every = Math.max(1, Math.ceil(crowd.x.length / kSamples));
  const spots = [];
  for (let i = 0; i < crowd.x.length; i += every) {
    const at = view.worldToScreen({ x: crowd.x[i] ?? 0, y: crowd.y[i] ?? 0 });
    spots.push({ x: at.x * ratio, y: at.y * ratio });
  }
  return spots;
}
