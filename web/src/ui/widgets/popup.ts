// A panel that a button opens: Escape, a press outside or a choice closes it.

import { setAttribute } from './dom';

export class Popup {
  constructor(
    private readonly button_: HTMLElement,
    private readonly panel_: HTMLElement,
    private readonly opened_: () => void = () => undefined,
  ) {
    button_.setAttribute('aria-expanded', 'false');
    panel_.hidden = true;
    button_.addEventListener('click', () => (this.isOpen ? this.close(true) : this.open()));
    panel_.addEventListener('keydown', (event) => this.pressed(event));
    button_.addEventListener('keydown', (event) => {
      if (event.key === 'ArrowDown' && !this.isOpen) {
        event.preventDefault();
        event.stopPropagation();
        this.open();
      }
    });
    document.addEventListener('pointerdown', (event) => this.pointed(event), true);
  }

  get isOpen(): boolean {
    return !this.panel_.hidden;
  }

  open(): void {
    this.panel_.hidden = false;
    setAttribute(this.button_, 'aria-expanded', 'true');
    this.opened_();
    const items = this.items();
    (items.find((item) => item.getAttribute('aria-current') === 'true') ?? items[0])?.focus();
  }

  close(giveFocusBack: boolean): void {
    if (!this.isOpen) return;
    this.panel_.hidden = true;
    setAttribute(this.button_, 'aria-expanded', 'false');
    if (giveFocusBack) this.button_.focus();
  }

  private items(): HTMLElement[] {
    return [...this.panel_.querySelectorAll<HTMLElement>('button, input')].filter((item) => !item.hidden);
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
    if (event.key === 'Tab') this.close(false);
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
