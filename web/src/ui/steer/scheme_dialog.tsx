// The choice of a control scheme, and the reminder while one is in use.

import { render } from 'preact';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

const kOwn = {
  name: '',
  title: 'The studio’s own',
  description: 'Fingers, mouse and keys as the help tells.',
} as const;

export class SchemeDialog {
  readonly root = element('dialog', { class: 'help schemes', 'aria-labelledby': 'schemes-title' });

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    this.root.addEventListener('close', () => actions_.showSchemes(false));
    this.root.addEventListener('click', (event) => {
      if (event.target === this.root) this.root.close();
    });
    store_.watch(['schemesOpen'], ({ schemesOpen }) => {
      if (schemesOpen && !this.root.open) this.show();
      if (!schemesOpen && this.root.open) this.root.close();
    });
  }

  private show(): void {
    this.draw();
    this.root.showModal();
    this.root.querySelector<HTMLInputElement>('input:checked')?.focus();
  }

  private draw(): void {
    const { schemes, scheme } = this.store_.state;
    render(
      <>
        <header>
          <h2 id="schemes-title">Control</h2>
          <button type="button" aria-label="Close the list" onClick={() => this.root.close()}>
            <Icon name="close" />
          </button>
        </header>
        <div class="scheme-list" role="radiogroup" aria-labelledby="schemes-title">
          {[kOwn, ...schemes].map(({ name, title, description }) => (
            <label key={name} class="scheme-row">
              <input
                type="radio"
                name="scheme"
                value={name}
                checked={name === scheme}
                onChange={() => this.actions_.chooseScheme(name)}
              />
              <span class="scheme-words">
                <strong>{title}</strong>
                <span class="secondary">{description}</span>
              </span>
            </label>
          ))}
        </div>
      </>,
      this.root,
    );
  }
}

/** Tells which scheme is in use, and ends it. */
export class SchemeBanner {
  readonly root = element('section', { class: 'banner scheme-banner panel', 'aria-label': 'Control in use' });

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['scheme', 'schemes'], ({ scheme, schemes }) => {
      const info = schemes.find(({ name }) => name === scheme);
      this.root.hidden = info === undefined;
      if (!info) return null;
      return (
        <>
          <Icon name="steer" size={24} />
          <div class="banner-words">
            <strong>{info.title}</strong>
            <span class="secondary">{info.description}</span>
          </div>
          <button type="button" class="soft" onClick={() => actions.chooseScheme('')}>
            Leave
          </button>
        </>
      );
    });
  }
}
