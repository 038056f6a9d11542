// A formation that lies on the ground to be looked at: what is said of its places, and whether it is taken up.

import type { ShapeActions } from '../../model/shape_actions';
import type { StudioStore } from '../../model/studio_store';
import { Button, Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

export class TryBar {
  readonly root = element('section', { class: 'try-bar panel', 'aria-label': 'Formation on the ground', hidden: true });

  constructor(store: StudioStore, shapes: Pick<ShapeActions, 'endTry'>) {
    drawPanel(this.root, store, ['trying', 'stand'], ({ trying, stand }) => (
      <>
        <div class="try-said">
          <span class="try-title">{trying?.title}</span>
          <span class={`try-words${stand?.warns ? ' warns' : ''}`} role="status">
            {stand?.text ?? '…'}
          </span>
        </div>
        <Button act={() => shapes.endTry('change')}>Change…</Button>
        <Button class="solid" act={() => shapes.endTry('take')}>
          Use it
        </Button>
        <button type="button" class="try-drop" aria-label="Drop it" onClick={() => shapes.endTry('drop')}>
          <Icon name="close" />
        </button>
      </>
    ));
    store.watch(['trying'], ({ trying }) => {
      const opens = trying !== null && this.root.hidden;
      this.root.hidden = trying === null;
      if (opens) this.root.querySelector<HTMLElement>('.solid')!.focus();
    });
    window.addEventListener('keydown', (event) => this.escape(event, shapes), true);
  }

  private escape(event: KeyboardEvent, shapes: Pick<ShapeActions, 'endTry'>): void {
    if (event.key !== 'Escape' || this.root.hidden || event.defaultPrevented) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    shapes.endTry('drop');
  }
}
