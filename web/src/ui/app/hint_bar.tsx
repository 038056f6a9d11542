// Shown on the first visit: how to make a point, a line and an area, and how to move the camera. The words follow the
// last input device; what is done is ticked.

import type { StudioActions } from '../../model/studio_actions';
import { kHintSteps, type InputKind } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { Button, Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

interface Words {
  readonly title: string;
  readonly does: string;
}

const kWords: Record<InputKind, readonly Words[]> = {
  touch: [
    { title: 'One finger', does: 'drags a point' },
    { title: 'Two together', does: 'move a line' },
    { title: 'Three or more', does: 'carry an area' },
    { title: 'Empty ground', does: 'moves the camera' },
  ],
  mouse: [
    { title: 'Drag', does: 'pulls a point' },
    { title: 'Shift + drag', does: 'spans a line' },
    { title: 'Ctrl or Alt + drag', does: 'lassoes an area' },
    { title: 'Empty ground', does: 'moves the camera' },
  ],
};

const kHalo = 'class="halo"';
const kHandle = 'class="handle"';

const kPictures = [
  `<circle cx="20" cy="20" r="17" class="reach"/><circle ${kHalo} cx="20" cy="20" r="9.5"/><circle ${kHandle} cx="20" cy="20" r="4.2"/>`,
  `<circle ${kHalo} cx="8" cy="30" r="8"/><circle ${kHalo} cx="32" cy="10" r="8"/><path class="bar" d="M8 30 32 10"/>` +
    `<circle ${kHandle} cx="8" cy="30" r="4"/><circle ${kHandle} cx="32" cy="10" r="4"/>`,
  `<path class="hull" d="M20 7 33 31 7 31Z"/><circle ${kHalo} cx="20" cy="7" r="7"/><circle ${kHalo} cx="7" cy="31" r="7"/>` +
    `<circle ${kHalo} cx="33" cy="31" r="7"/><path class="outline" d="M20 7 33 31 7 31Z"/><circle ${kHandle} cx="20" cy="7" r="3.6"/>` +
    `<circle ${kHandle} cx="7" cy="31" r="3.6"/><circle ${kHandle} cx="33" cy="31" r="3.6"/>`,
  `<path class="arrows" d="M20 4v32 M4 20h32 M15.5 8.5 20 4l4.500 4.500 M15.500 31.500 20 36l4.500-4.500 M8.500 15.500 4 20l4.500 4.500 M31.500 15.500 36 20l-4.500 4.500"/>`,
];

export class HintBar {
  readonly root = element('section', { class: 'hint panel', 'aria-label': 'How to steer the crowd' });

  constructor(store: StudioStore, actions: StudioActions) {
    store.watch(['hint', 'link', 'loaded'], ({ hint, link, loaded }) => {
      this.root.hidden = !hint || !loaded || link.phase === 'lost';
    });
    drawPanel(this.root, store, ['tried', 'input'], ({ tried, input }) => (
      <>
        {kHintSteps.map((step, i) => (
          <div key={step} class={tried.includes(step) ? 'hint-item done' : 'hint-item'}>
            <svg
              class="hint-picture"
              width="40"
              height="40"
              viewBox="0 0 40 40"
              aria-hidden="true"
              dangerouslySetInnerHTML={{ __html: kPictures[i]! }}
            />
            <div class="hint-words">
              <strong>{kWords[input][i]!.title}</strong>
              <span class="secondary">{kWords[input][i]!.does}</span>
            </div>
            <span class="hint-tick">
              <Icon name="check" />
              <span class="unseen">done</span>
            </span>
          </div>
        ))}
        <Button class="soft hint-done" act={() => actions.dismissHint()}>
          Got it
        </Button>
      </>
    ));
  }
}
