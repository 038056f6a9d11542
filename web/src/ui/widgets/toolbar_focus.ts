// One Tab stop per toolbar; arrow keys, Home and End move inside it.

import type { StudioStore } from '../../model/studio_store';

const kForward = new Set(['ArrowRight', 'ArrowDown']);
const kBack = new Set(['ArrowLeft', 'ArrowUp']);

export class ToolbarFocus {
  /** Layouts and a lost connection hide or disable buttons; the Tab stop moves to one that can be reached. */
  constructor(
    private readonly root_: HTMLElement,
    store: StudioStore,
  ) {
    root_.addEventListener('keydown', (event) => this.moved(event));
    root_.addEventListener('focusin', (event) => this.enter(event.target as HTMLElement));
    store.watch(['layout', 'link', 'replaying', 'demonstration'], () => this.refresh());
  }

  /** After buttons came, went or were hidden. */
  refresh(): void {
    const buttons = this.buttons();
    const current = buttons.find((button) => button.tabIndex === 0) ?? buttons[0];
    for (const button of buttons) button.tabIndex = button === current ? 0 : -1;
  }

  private buttons(): HTMLElement[] {
    return [...this.root_.querySelectorAll<HTMLElement>('button')].filter((button) => this.canBeReached(button));
  }

  private canBeReached(button: HTMLElement): boolean {
    if (button.closest('[hidden], [inert]') !== null || (button as HTMLButtonElement).disabled) return false;
    // A list that a button opens has keys of its own.
    const list = button.closest('[role="group"]');
    if (list !== null && this.root_.contains(list)) return false;
    for (let node: HTMLElement | null = button; node !== null && node !== this.root_; node = node.parentElement) {
      if (getComputedStyle(node).display === 'none') return false;
    }
    return true;
  }

  private enter(target: HTMLElement): void {
    const buttons = this.buttons();
    if (!buttons.includes(target)) return;
    for (const button of buttons) button.tabIndex = button === target ? 0 : -1;
  }

  private moved(event: KeyboardEvent): void {
    const buttons = this.buttons();
    const at = buttons.indexOf(document.activeElement as HTMLElement);
    if (at < 0) return;
    const next = this.nextIndex(event.key, at, buttons.length);
    if (next === null) return;
    event.preventDefault();
    event.stopPropagation();
    buttons[next]!.focus();
  }

  private nextIndex(key: string, at: number, count: number): number | null {
    if (kForward.has(key)) return (at + 1) % count;
    if (kBack.has(key)) return (at + count - 1) % count;
    if (key === 'Home') return 0;
    return key === 'End' ? count - 1 : null;
  }
}
