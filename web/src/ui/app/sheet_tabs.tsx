// The tabs of the sheet of a phone: formations, orders, or the camera's buttons.

import { render } from 'preact';
import type { StudioStore } from '../../model/studio_store';
import { element } from '../widgets/dom';

const kTabs = [
  { tab: 'formation', label: 'Formation' },
  { tab: 'orders', label: 'Orders' },
  { tab: 'view', label: 'View' },
] as const;
type Tab = (typeof kTabs)[number]['tab'];

const kForward = new Set(['ArrowRight', 'ArrowDown']);
const kBack = new Set(['ArrowLeft', 'ArrowUp']);

export class SheetTabs {
  readonly root = element('div', { class: 'tabs panel', role: 'tablist', 'aria-label': 'Tools' });
  private tab_: Tab = 'formation';
  private queued_ = 0;

  /** `sheet` has the chosen one in `data-tab`. */
  constructor(
    store: StudioStore,
    private readonly sheet_: HTMLElement,
  ) {
    this.root.addEventListener('keydown', (event) => this.moved(event));
    store.watch(['queue'], ({ queue }) => {
      this.queued_ = queue.length;
      this.draw();
    });
  }

  private choose(tab: Tab): void {
    this.tab_ = tab;
    this.draw();
  }

  private draw(): void {
    this.sheet_.dataset['tab'] = this.tab_;
    const count = (tab: Tab): string => (tab === 'orders' && this.queued_ > 0 ? ` · ${this.queued_}` : '');
    const tabs = kTabs.map(({ tab, label }) => (
      <button
        key={tab}
        type="button"
        role="tab"
        data-tab={tab}
        aria-selected={tab === this.tab_}
        tabIndex={tab === this.tab_ ? 0 : -1}
        onClick={() => this.choose(tab)}
      >
        {label}
        {count(tab)}
      </button>
    ));
    render(tabs, this.root);
  }

  private moved(event: KeyboardEvent): void {
    const step = kForward.has(event.key) ? 1 : kBack.has(event.key) ? -1 : 0;
    if (step === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const at = kTabs.findIndex(({ tab }) => tab === this.tab_);
    this.choose(kTabs[(at + step + kTabs.length) % kTabs.length]!.tab);
    this.root.querySelector<HTMLElement>('[aria-selected="true"]')?.focus();
  }
}
