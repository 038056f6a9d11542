// One tooltip for everything with `data-tip`; shown for the mouse and for keyboard focus, never for fingers.

import { element, setText } from './dom';

const DELAY_MS = 450;
const GAP = 8;

export class Tooltip {
  private readonly text = element('span');
  private readonly key = element('kbd');
  readonly root = element('div', { class: 'tooltip passive', role: 'tooltip', hidden: true }, this.text, this.key);
  private timer = 0;

  constructor(page: Document) {
    page.addEventListener('pointerover', (event) => this.hover(event));
    page.addEventListener('focusin', (event) => this.focus(event.target as Element));
    page.addEventListener('focusout', () => this.hide());
    page.addEventListener('pointerdown', () => this.hide(), true);
    page.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.hide();
    });
  }

  private hover(event: PointerEvent): void {
    const owner = (event.target as Element).closest?.('[data-tip]') ?? null;
    this.hide();
    if (event.pointerType === 'mouse' && owner) this.timer = window.setTimeout(() => this.show(owner), DELAY_MS);
  }

  private focus(target: Element): void {
    const owner = target.closest?.('[data-tip]');
    if (owner && target.matches(':focus-visible')) this.show(owner);
  }

  private show(owner: Element): void {
    setText(this.text, owner.getAttribute('data-tip') ?? '');
    const key = owner.getAttribute('data-key');
    setText(this.key, key ?? '');
    this.key.hidden = !key;
    this.root.hidden = false;
    const at = owner.getBoundingClientRect();
    const size = this.root.getBoundingClientRect();
    const left = Math.min(Math.max(GAP, at.left + (at.width - size.width) / 2), window.innerWidth - size.width - GAP);
    const below = at.bottom + GAP;
    const top = below + size.height > window.innerHeight - GAP ? at.top - GAP - size.height : below;
    this.root.style.left = `${left}px`;
    this.root.style.top = `${top}px`;
  }

  private hide(): void {
    window.clearTimeout(this.timer);
    this.root.hidden = true;
  }
}
