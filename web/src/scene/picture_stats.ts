// What pictures cost. `?stats` in the page's address shows it.

export class PictureStats {
  /** Of the last picture. */
  drawCalls = 0;
  /** Of the last picture. */
  triangles = 0;
  /**
   * JavaScript time of the last picture, and of one frame of the server taken since the picture before, on average
   * [ms].
   */
  pictureMs = 0;
  /** Time of the frames taken since the last picture [ms]. */
  framesTakenMs = 0;
  /** Their number. */
  framesTaken = 0;
  /** Pictures drawn. */
  pictures = 0;
  /** Number of the server's frame whose controls, meshes and places the last picture shows; 0 before the first.
   * Characters run about a frame behind. */
  shownFrame = 0;
  /** Called in the task that has drawn a picture, while the canvas still holds it. */
  afterPicture?: (() => void) | undefined;

  /** A picture of this frame is drawn; `start` by performance.now() [ms]. */
  finish(start: number, frame: number | undefined): void {
    this.pictureMs = performance.now() - start + this.framesTakenMs / Math.max(1, this.framesTaken);
    this.framesTakenMs = 0;
    this.framesTaken = 0;
    this.pictures += 1;
    if (frame !== undefined) this.shownFrame = frame;
    this.afterPicture?.();
  }
}

/** The figures alone. */
export type ViewStats = Omit<PictureStats, 'finish'>;
