// A small picture of the scene as it is drawn now.

import type { StudioScene } from '../scene/studio_scene';

type PictureView = Pick<StudioScene, 'stats' | 'wake'>;

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

/** The scene's next picture as PNG, cut to the middle of that width and height; null where the browser cannot. */
export function takePicture(
  view: PictureView,
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): Promise<Blob | null> {
  return new Promise((done) => {
    afterNextPicture(view, () => {
      const small = document.createElement('canvas');
      small.width = width;
      small.height = height;
      const scale = Math.max(width / canvas.width, height / canvas.height);
      const [w, h] = [canvas.width * scale, canvas.height * scale];
      const context = small.getContext('2d');
      if (!context) return done(null);
      context.imageSmoothingQuality = 'high';
      context.drawImage(canvas, (width - w) / 2, (height - h) / 2, w, h);
      small.toBlob(done, 'image/png');
    });
  });
}
