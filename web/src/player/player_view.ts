// The picture of a player: canvas, camera, and a stage that is made when the player comes into view and given back when it
// leaves, as browsers have few WebGL contexts.

import type { Theme } from '../model/view_settings';
import { CrowdMoment } from './play/crowd_moment';
import { Stage } from './draw/stage';
import type { LoadedCrowd } from './file/loaded_crowd';
import { Follower, wholeAim } from './play/framing';
import { ViewCamera } from './play/view_camera';

const kMostPixels = 2;
/** Pictures that take longer than this, so many on end, lose their shadows [s]. */
const kSlow = 0.055;
const kSlowOnEnd = 12;
/** Controls count up to this share of the picture. */
const kMostCovered = 0.25;

export interface ViewSettings {
  readonly theme: Theme;
  /** The camera goes with the crowd. */
  readonly follows: boolean;
  /** Controls cover so much of the picture from below [px]. */
  readonly covered: number;
}

export class PlayerView {
  readonly camera: ViewCamera;
  readonly moment: CrowdMoment;
  private canvas_: HTMLCanvasElement;
  private stage_: Stage | null = null;
  private follower_: Follower | null = null;
  private aspect_ = 0;
  private slow_ = 0;
  private fine_ = true;

  /** `place` holds the canvas. `broken` is told a sentence where nothing can be drawn. */
  constructor(
    private readonly loaded_: LoadedCrowd,
    private readonly place_: HTMLElement,
    private settings_: ViewSettings,
    private readonly restored_: () => void,
  ) {
    this.camera = new ViewCamera(loaded_.head.camera);
    this.moment = new CrowdMoment(loaded_);
    this.canvas_ = this.makeCanvas();
  }

  /** Throws CannotDraw where the browser cannot draw. */
  set(settings: ViewSettings): void {
    const { follows, covered } = this.settings_;
    const again = settings.follows !== follows || settings.covered !== covered;
    this.settings_ = settings;
    this.stage_?.setTheme(settings.theme);
    if (again) this.aspect_ = 0;
  }

  /** Gives back what the graphics card holds, until the next picture. */
  rest(): void {
    if (!this.stage_) return;
    this.stage_.release();
    this.stage_ = null;
    this.canvas_.remove();
    this.canvas_ = this.makeCanvas();
  }

  /** Draws the picture of a time. Throws CannotDraw where the browser cannot. */
  draw(time: number): void {
    const pixel = Math.min(kMostPixels, this.fine_ ? window.devicePixelRatio || 1 : 1);
    const width = Math.max(1, Math.round(this.place_.clientWidth * pixel));
    const height = Math.max(1, Math.round(this.place_.clientHeight * pixel));
    this.stage_ ??= this.makeStage();
    if (this.stage_.lost) return;
    if (this.canvas_.width !== width || this.canvas_.height !== height) {
      this.canvas_.width = width;
      this.canvas_.height = height;
    }
    this.frame(width / height, time);
    this.moment.goTo(time);
    this.stage_.draw(this.moment, this.camera, pixel);
  }

  /** Where a point is in the picture [CSS px]. */
  screenOf(x: number, y: number, z: number): { x: number; y: number } {
    const [across, up] = this.camera.screen(x, y, z);
    const { clientWidth, clientHeight } = this.place_;
    return { x: (0.5 + 0.5 * across) * clientWidth, y: (0.5 - 0.5 * up) * clientHeight };
  }

  /** How long the last picture took while it played [s]: where many are slow, pictures become simpler. */
  took(seconds: number): void {
    this.slow_ = seconds > kSlow ? this.slow_ + 1 : 0;
    if (this.slow_ < kSlowOnEnd || !this.fine_) return;
    this.fine_ = false;
    if (this.stage_) this.stage_.fine = false;
  }

  private frame(aspect: number, time: number): void {
    this.camera.aspect = aspect;
    if (aspect !== this.aspect_) {
      this.aspect_ = aspect;
      this.camera.covered = Math.min(kMostCovered, this.settings_.covered / Math.max(1, this.place_.clientHeight));
      this.follower_ = this.settings_.follows ? new Follower(this.loaded_, this.camera) : null;
      if (!this.follower_) this.camera.aim(wholeAim(this.loaded_, this.camera));
    }
    if (this.follower_) this.camera.aim(this.follower_.at(time));
  }

  private makeStage(): Stage {
    const stage = new Stage(this.canvas_, this.loaded_, this.settings_.theme);
    stage.fine = this.fine_;
    return stage;
  }

  private makeCanvas(): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    canvas.setAttribute('part', 'picture');
    canvas.setAttribute('aria-hidden', 'true');
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => {
      if (canvas !== this.canvas_) return;
      this.stage_ = null;
      this.restored_();
    });
    this.place_.prepend(canvas);
    return canvas;
  }
}
