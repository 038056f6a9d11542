// The choice of a control scheme, and the reminder while one is in use.

import type { SchemeInfo } from '../../protocol/messages';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { element, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';

const kOwn = {
  name: '',
  title: 'The studio’s own',
  description: 'Fingers, mouse and keys as the help tells.',
} as const;

export class SchemeDialog {
  readonly root = element('dialog', { class: 'help schemes', 'aria-labelledby': 'schemes-title' });
  private readonly list_ = element('div', {
    class: 'scheme-list',
    role: 'radiogroup',
    'aria-labelledby': 'schemes-title',
  });

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    const close = element('button', { type: 'button', 'aria-label': 'Close the list' }, icon('close'));
    close.addEventListener('click', () => this.root.close());
    this.root.addEventListener('close', () => actions_.showSchemes(false));
    this.root.addEventListener('click', (event) => {
      if (event.target === this.root) this.root.close();
    });
    const title = element('h2', { id: 'schemes-title' }, 'Control');
    this.root.append(element('header', {}, title, close), this.list_);
    store_.watch(['schemesOpen'], ({ schemesOpen }) => {
      if (schemesOpen && !this.root.open) this.show();
      if (!schemesOpen && this.root.open) this.root.close();
    });
  }

  private show(): void {
    const { schemes, scheme } = this.store_.state;
    const rows = [kOwn, ...schemes].map((one) => this.row(one, one.name === scheme));
    this.list_.replaceChildren(...rows);
    this.root.showModal();
    this.list_.querySelector<HTMLInputElement>('input:checked')?.focus();
  }

  private row({ name, title, description }: Pick<SchemeInfo, 'name' | 'title' | 'description'>, checked: boolean) {
    const input = element('input', { type: 'radio', name: 'scheme', value: name, checked });
    input.addEventListener('change', () => this.actions_.chooseScheme(name));
    const words = element(
      'span',
      { class: 'scheme-words' },
      element('strong', {}, title),
      element('span', { class: 'secondary' }, description),
    );
    return element('label', { class: 'scheme-row' }, input, words);
  }
}

/** Tells which scheme is in use, and ends it. */
export class SchemeBanner {
  private readonly text_ = element('strong');
  private readonly how_ = element('span', { class: 'secondary' });
  private readonly leave_ = element('button', { type: 'button', class: 'soft' }, 'Leave');
  readonly root = element(
    'section',
    { class: 'banner scheme-banner panel', 'aria-label': 'Control in use' },
    icon('steer', 24),
    element('div', { class: 'banner-words' }, this.text_, this.how_),
    this.leave_,
  );

  constructor(store: StudioStore, actions: StudioActions) {
    this.leave_.addEventListener('click', () => actions.chooseScheme(''));
    store.watch(['scheme', 'schemes'], ({ scheme, schemes }) => {
      const info = schemes.find(({ name }) => name === scheme);
      this.root.hidden = info === undefined;
      setText(this.text_, info?.title ?? '');
      setText(this.how_, info?.description ?? '');
    });
  }
}
