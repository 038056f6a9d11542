// What a button opens above everything else: Escape, a press outside or a choice closes it, and the button has the focus again.
// It stands in the browser's top layer, beside its button and inside the window whatever their sizes.

import type { Placement } from '@floating-ui/dom';
import { keepBeside } from './beside';
import { setAttribute } from './dom';

export class Popover {
  private follow_: (() => void) | null = null;

  constructor(
    private readonly button_: HTMLElement,
    private readonly panel_: HTMLElement,
    private readonly placement_: Placement = 'bottom-start',
    /** What it stands beside, where that is more than the button. */
    private readonly beside_: () => Element = () => button_,
  ) {
    button_.setAttribute('aria-expanded', 'false');
    panel_.classList.add('popover');
    panel_.setAttribute('popover', 'manual');
    panel_.hidden = true;
    button_.addEventListener('click', () => (this.isOpen ? this.close(true) : this.open()));
    panel_.addEventListener('keydown', (event) => this.pressed(event));
    button_.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && this.isOpen) this.pressed(event);
      if (event.key !== 'ArrowDown' || this.isOpen) return;
      event.preventDefault();
      event.stopPropagation();
      this.open();
    });
    document.addEventListener('pointerdown', (event) => this.pointed(event), true);
  }

  get isOpen(): boolean {
    return !this.panel_.hidden;
  }

  open(): void {
    this.panel_.hidden = false;
    // Browsers of before 2024 have no top layer for it: there it stands in its panel.
    this.panel_.showPopover?.();
    setAttribute(this.button_, 'aria-expanded', 'true');
    const how = { placement: this.placement_, shrinks: true };
    this.follow_ = keepBeside(this.beside_(), this.panel_, how, () => this.close(false));
    const items = this.items();
    (items.find((item) => item.getAttribute('aria-current') === 'true') ?? items[0])?.focus();
  }

  close(giveFocusBack: boolean): void {
    if (!this.isOpen) return;
    this.follow_?.();
    this.follow_ = null;
    this.panel_.hidePopover?.();
    this.panel_.hidden = true;
    setAttribute(this.button_, 'aria-expanded', 'false');
    if (giveFocusBack) this.button_.focus();
  }

  private items(): HTMLElement[] {
    return [...this.panel_.querySelectorAll<HTMLElement>('button, input, select')].filter((item) => !item.hidden);
  }

  private pointed(event: Event): void {
    const target = event.target as Node;
    if (!this.panel_.contains(target) && !this.button_.contains(target)) this.close(false);
  }

  private pressed(event: KeyboardEvent): void {
    if (event.key === 'Escape') {
      event.stopPropagation();
      this.close(true);
      return;
    }
    if (event.key === 'Tab') return this.close(false);
    const { target } = event;
    // Fields and choices have arrow keys of their own.
    if (target instanceof HTMLInputElement || target instanceof HTMLSelectElement) return;
    const items = this.items();
    const at = items.indexOf(document.activeElement as HTMLElement);
    const next = this.nextIndex(event.key, at, items.length);
    if (next === null || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    items[next]!.focus();
  }

  private nextIndex(key: string, at: number, count: number): number | null {
    if (key === 'ArrowDown') return (at + 1) % count;
    if (key === 'ArrowUp') return (at + count - 1) % count;
    if (key === 'Home') return 0;
    return key === 'End' ? count - 1 : null;
  }
}
