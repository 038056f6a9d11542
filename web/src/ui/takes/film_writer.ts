// Writes pictures of a canvas as a film. Loaded when the first film is made.

import {
  BufferTarget,
  CanvasSource,
  Mp4OutputFormat,
  Output,
  QUALITY_HIGH,
  WebMOutputFormat,
  getFirstEncodableVideoCodec,
} from 'mediabunny';

/** Codecs in the order of preference; the first is for MP4. */
const kCodecs = ['avc', 'vp9', 'vp8', 'av1'] as const;

export class FilmWriter {
  private readonly target_ = new BufferTarget();
  private readonly output_: Output;
  private readonly video_: CanvasSource;
  private time_ = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly fps_: number,
    codec: (typeof kCodecs)[number],
    /** "mp4" or "webm" */
    readonly ending: string,
  ) {
    const format = ending === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat();
    this.output_ = new Output({ format, target: this.target_ });
    this.video_ = new CanvasSource(canvas, { codec, bitrate: QUALITY_HIGH });
    this.output_.addVideoTrack(this.video_, { frameRate: fps_ });
  }

  start(): Promise<void> {
    return this.output_.start();
  }

  /** The canvas as it is now is the next picture. */
  async add(): Promise<void> {
    await this.video_.add(this.time_ / this.fps_, 1 / this.fps_);
    this.time_ += 1;
  }

  async finish(): Promise<Blob> {
    await this.output_.finalize();
    if (!this.target_.buffer) throw new Error('The film could not be written.');
    return new Blob([this.target_.buffer], { type: `video/${this.ending}` });
  }

  cancel(): Promise<void> {
    return this.output_.cancel();
  }
}

/** Throws a sentence where the browser encodes no film of that size. */
export async function beginFilm(canvas: HTMLCanvasElement, fps: number): Promise<FilmWriter> {
  const { width, height } = canvas;
  const codec = await getFirstEncodableVideoCodec([...kCodecs], { width, height });
  const known = kCodecs.find((one) => one === codec);
  if (!known) throw new Error('This browser encodes no film of that size.');
  const writer = new FilmWriter(canvas, fps, known, known === 'avc' ? 'mp4' : 'webm');
  await writer.start();
  return writer;
}
