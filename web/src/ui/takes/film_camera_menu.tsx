// The key frames of the film camera, beside the other tools of the time line.

import type { VNode } from 'preact';
import { clockAt, type OpenTake } from '../../model/take_facts';
import type { CameraKey } from '../../scene/camera/film_camera';
import { Button, ToolButton } from '../widgets/buttons';
import { Menu } from '../widgets/menu';

export interface FilmCameraActions {
  keepView(): void;
  removeView(step: number): void;
  /** True: the camera is there at once. */
  cutView(step: number, cut: boolean): void;
  showMoment(step: number): void;
  filmCamera(on: boolean): void;
}

export interface FilmCameraProps {
  readonly keys: readonly CameraKey[];
  readonly on: boolean;
  readonly take: Pick<OpenTake, 'from' | 'stepTime'>;
  readonly actions: FilmCameraActions;
}

const kEases = 'The camera moves with ease from view to view, also in films.';
const kBegin = 'Move the camera and the playhead, and keep views: the camera then moves from one to the next.';

function View({ step, index, cut, take, actions }: Pick<FilmCameraProps, 'take' | 'actions'> & ViewPlace): VNode {
  return (
    <div class="camera-key">
      <Button act={() => actions.showMoment(step)}>
        View {index + 1} at {clockAt(take, step)}
      </Button>
      <ToolButton
        icon="cut"
        label={`Cut to view ${index + 1}`}
        iconOnly
        pressed={cut}
        tip="The camera is there at once, instead of travelling"
        act={() => actions.cutView(step, !cut)}
      />
      <ToolButton icon="close" label={`Remove view ${index + 1}`} iconOnly act={() => actions.removeView(step)} />
    </div>
  );
}

interface ViewPlace {
  readonly step: number;
  readonly index: number;
  readonly cut: boolean;
}

export function FilmCameraMenu({ keys, on, take, actions }: FilmCameraProps): VNode {
  const opener = {
    icon: 'camera',
    label: 'Camera',
    class: 'time-camera',
    pressed: on,
    tip: 'Key frames of the camera along the take',
  } as const;
  return (
    <span class="time-speed-holder">
      <Menu opener={opener} class="speed-pieces camera-keys" label="Film camera" placement="top-end">
        {() => (
          <>
            <div class="speed-add">
              <Button class="soft camera-keep" act={() => actions.keepView()}>
                Keep this view here
              </Button>
              <Button
                class="soft camera-leads"
                disabled={keys.length === 0}
                aria-pressed={on}
                act={() => actions.filmCamera(!on)}
              >
                Film camera
              </Button>
            </div>
            {keys.map(({ step, cut = false }, index) => (
              <View key={step} step={step} index={index} cut={cut} take={take} actions={actions} />
            ))}
            <p class="secondary">{keys.length > 0 ? kEases : kBegin}</p>
          </>
        )}
      </Menu>
    </span>
  );
}
