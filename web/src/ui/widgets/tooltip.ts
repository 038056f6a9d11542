// One tooltip for everything with `data-tip`; shown for the mouse and for keyboard focus, never for fingers.

import { element, setText } from './dom';

const kDelayMs = 450;
const kGap = 8;

export class Tooltip {
  private readonly text_ = element('span');
  private readonly key_ = element('kbd');
  readonly root = element('div', { class: 'tooltip passive', role: 'tooltip', hidden: true }, this.text_, this.key_);
  private timer_ = 0;

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
    if (event.pointerType === 'mouse' && owner) this.timer_ = window.setTimeout(() => this.show(owner), kDelayMs);
  }

  private focus(target: Element): void {
    const owner = target.closest?.('[data-tip]');
    if (owner && target.matches(':focus-visible')) this.show(owner);
  }

  private show(owner: Element): void {
    setText(this.text_, owner.getAttribute('data-tip') ?? '');
    const key = owner.getAttribute('data-key');
    setText(this.key_, key ?? '');
    this.key_.hidden = !key;
    this.root.hidden = false;
    const at = owner.getBoundingClientRect();
    const size = this.root.getBoundingClientRect();
    const left = Math.min(Math.max(kGap, at.left + (at.width - size.width) / 2), window.innerWidth - size.width - kGap);
    const below = at.bottom + kGap;
    const top = below + size.height > window.innerHeight - kGap ? at.top - kGap - size.height : below;
    this.root.style.left = `${left}px`;
    this.root.style.top = `${top}px`;
  }

  private hide(): void {
    window.clearTimeout(this.timer_);
    this.root.hidden = true;
  }
}
