// The film camera of the open take: its key frames, which the take keeps, and whether it leads the view.

import {
  poseAt,
  readKeys,
  withCut,
  withKey,
  withKeyAt,
  withoutKey,
  type CameraKey,
} from '../../scene/camera/film_camera';
import type { CameraControls } from '../../scene/camera/camera_controls';
import { readSetting, writeSetting } from '../widgets/theme';

/** Where browsers of before kept keys. */
const kKey = 'muster.film.';

export interface FilmCameraParts {
  readonly camera: Pick<CameraControls, 'pose' | 'glideToPose'>;
  /** Keys have changed, or the camera is switched. */
  readonly changed: () => void;
  /** Keeps the keys with the take. */
  readonly keep: (keys: readonly CameraKey[]) => void;
  readonly storage?: () => Storage;
}

export class FilmCameraController {
  private take_: string | null = null;
  private keys_: readonly CameraKey[] = [];
  private on_ = false;

  constructor(private readonly parts_: FilmCameraParts) {}

  get keys(): readonly CameraKey[] {
    return this.keys_;
  }

  /** True where it leads the view while the take plays. */
  get on(): boolean {
    return this.on_;
  }

  /** The open take and its keys; null for none. */
  open(take: string | null, keys: readonly CameraKey[]): void {
    const same = JSON.stringify(keys) === JSON.stringify(this.keys_);
    if (take === this.take_ && same) return;
    if (take !== this.take_) {
      // A take that was changed is another one with the same camera.
      if (this.take_ === null || !same) this.on_ = keys.length > 0;
      this.take_ = take;
      const before = take && keys.length === 0 ? this.keptBefore(take) : [];
      if (before.length > 0) return this.set(before, true);
    }
    this.keys_ = keys;
    this.on_ = this.on_ && keys.length > 0;
    this.parts_.changed();
  }

  /** The view as it is becomes the key frame of this moment. */
  keep(step: number): void {
    if (this.take_ === null) return;
    const cut = this.keys_.find((key) => key.step === step)?.cut;
    this.set(withKey(this.keys_, step, this.parts_.camera.pose, cut), true);
  }

  remove(step: number): void {
    const keys = withoutKey(this.keys_, step);
    this.set(keys, this.on_ && keys.length > 0);
  }

  move(step: number, to: number): void {
    this.set(withKeyAt(this.keys_, step, to), this.on_);
  }

  cut(step: number, cut: boolean): void {
    this.set(withCut(this.keys_, step, cut), this.on_);
  }

  switch(on: boolean): void {
    this.set(this.keys_, on && this.keys_.length > 0);
  }

  /** The take shows this moment. */
  observe(step: number): void {
    const pose = this.on_ ? poseAt(this.keys_, step) : null;
    if (pose) this.parts_.camera.glideToPose(pose, performance.now(), 0);
  }

  private keptBefore(take: string): readonly CameraKey[] {
    const storage = this.parts_.storage ?? (() => window.localStorage);
    const keys = readKeys(readSetting(storage, kKey + take));
    if (keys.length > 0) writeSetting(storage, kKey + take, '[]');
    return keys;
  }

  private set(keys: readonly CameraKey[], on: boolean): void {
    const changes = keys !== this.keys_;
    this.keys_ = keys;
    this.on_ = on;
    if (changes) this.parts_.keep(keys);
    this.parts_.changed();
  }
}
