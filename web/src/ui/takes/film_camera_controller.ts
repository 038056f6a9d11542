// The film camera of the open take: its key frames, kept in this browser, and whether it leads the view.

import { poseAt, readKeys, withKey, withoutKey, type CameraKey } from '../../scene/camera/film_camera';
import type { CameraControls } from '../../scene/camera/camera_controls';
import { readSetting, writeSetting } from '../widgets/theme';

const kKey = 'muster.film.';

export class FilmCameraController {
  private take_ = '';
  private keys_: readonly CameraKey[] = [];
  private on_ = false;

  /** `changed` is called when keys change, or the camera is switched. */
  constructor(
    private readonly camera_: Pick<CameraControls, 'pose' | 'glideToPose'>,
    private readonly changed_: () => void,
    private readonly storage_: () => Storage = () => window.localStorage,
  ) {}

  get keys(): readonly CameraKey[] {
    return this.keys_;
  }

  /** True where it leads the view while the take plays. */
  get on(): boolean {
    return this.on_;
  }

  /** Another take is open; none for an empty name. */
  open(take: string): void {
    if (take === this.take_) return;
    this.take_ = take;
    this.keys_ = take ? readKeys(readSetting(this.storage_, kKey + take)) : [];
    this.on_ = this.keys_.length > 0;
    this.changed_();
  }

  /** The view as it is becomes the key frame of this moment. */
  keep(step: number): void {
    if (!this.take_) return;
    this.set(withKey(this.keys_, step, this.camera_.pose), true);
  }

  remove(step: number): void {
    const keys = withoutKey(this.keys_, step);
    this.set(keys, this.on_ && keys.length > 0);
  }

  switch(on: boolean): void {
    this.set(this.keys_, on && this.keys_.length > 0);
  }

  /** The take shows this moment. */
  observe(step: number): void {
    const pose = this.on_ ? poseAt(this.keys_, step) : null;
    if (pose) this.camera_.glideToPose(pose, performance.now(), 0);
  }

  private set(keys: readonly CameraKey[], on: boolean): void {
    if (keys !== this.keys_ && this.take_) writeSetting(this.storage_, kKey + this.take_, JSON.stringify(keys));
    this.keys_ = keys;
    this.on_ = on;
    this.changed_();
  }
}
