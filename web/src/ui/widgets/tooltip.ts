// One tooltip for everything with `data-tip`; shown for the mouse and for keyboard focus, never for fingers. It stands in the
// browser's top layer, above what is open.

import { keepBeside } from './beside';
import { element, setText } from './dom';

const kDelayMs = 450;

export class Tooltip {
  private readonly text_ = element('span');
  private readonly key_ = element('kbd');
  readonly root = element(
    'div',
    { class: 'tooltip passive', role: 'tooltip', popover: 'manual', hidden: true },
    this.text_,
    this.key_,
  );
  private timer_ = 0;
  private follow_: (() => void) | null = null;

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
    this.hide();
    this.root.hidden = false;
    this.root.showPopover?.();
    this.follow_ = keepBeside(owner, this.root, { placement: 'bottom', shrinks: false }, () => this.hide());
  }

  private hide(): void {
    window.clearTimeout(this.timer_);
    this.follow_?.();
    this.follow_ = null;
    if (!this.root.hidden) this.root.hidePopover?.();
    this.root.hidden = true;
  }
}
