// The key frames of the film camera, beside the other tools of the time line.

import { formatClock } from '../../model/formatters';
import type { CameraKey } from '../../scene/camera/film_camera';
import { element, setPressed } from '../widgets/dom';
import { Popover } from '../widgets/popover';
import { toolButton } from '../widgets/tool_button';

export interface FilmCameraActions {
  keepView(): void;
  removeView(step: number): void;
  showMoment(step: number): void;
  filmCamera(on: boolean): void;
}

export class FilmCameraMenu {
  private readonly button_ = toolButton({
    icon: 'camera',
    label: 'Camera',
    className: 'time-camera',
    tip: 'Key frames of the camera along the take',
  });
  private readonly list_ = element('div', {
    class: 'speed-pieces camera-keys panel',
    role: 'group',
    'aria-label': 'Film camera',
  });
  readonly root = element('span', { class: 'time-speed-holder' }, this.button_, this.list_);
  private keys_: readonly CameraKey[] = [];
  private on_ = false;
  private stepTime_ = 1 / 60;

  constructor(private readonly actions_: FilmCameraActions) {
    new Popover(this.button_, this.list_, 'top-end', () => this.fill());
  }

  show(keys: readonly CameraKey[], on: boolean, stepTime: number): void {
    [this.keys_, this.on_, this.stepTime_] = [keys, on, stepTime];
    setPressed(this.button_, on);
    if (!this.list_.hidden) this.fill();
  }

  private fill(): void {
    const keep = element('button', { type: 'button', class: 'soft camera-keep' }, 'Keep this view here');
    keep.addEventListener('click', () => this.actions_.keepView());
    const leads = element(
      'button',
      { type: 'button', class: 'soft camera-leads', disabled: this.keys_.length === 0 },
      'Film camera',
    );
    setPressed(leads, this.on_);
    leads.addEventListener('click', () => this.actions_.filmCamera(!this.on_));
    const rows = this.keys_.map((key, i) => this.row(key, i));
    const note = element(
      'p',
      { class: 'secondary' },
      rows.length > 0
        ? 'The camera moves with ease from view to view, also in films.'
        : 'Move the camera and the playhead, and keep views: the camera then moves from one to the next.',
    );
    this.list_.replaceChildren(element('div', { class: 'speed-add' }, keep, leads), ...rows, note);
  }

  private row({ step }: CameraKey, index: number): HTMLElement {
    const clock = formatClock(step * this.stepTime_);
    const go = element('button', { type: 'button', class: 'soft' }, `View ${index + 1} at ${clock}`);
    go.addEventListener('click', () => this.actions_.showMoment(step));
    const remove = toolButton({
      icon: 'close',
      label: `Remove view ${index + 1}`,
      iconOnly: true,
      act: () => this.actions_.removeView(step),
    });
    return element('div', { class: 'camera-key' }, go, remove);
  }
}
