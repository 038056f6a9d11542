// Names the kind of a control for a moment, above its fingers.

import { element, setText } from './dom';
import { accentColour } from './group_marks';
import type { ScreenPoint } from '../view/camera_types';

const SHOWN_MS = 1200;

export class ControlChip {
  readonly root = element('div', { class: 'control-chip passive', 'aria-hidden': 'true', hidden: true });
  private until = 0;
  private place: (() => ScreenPoint | null) | null = null;

  /** `place` is asked with every drawn frame, as the fingers move. */
  show(kind: string, colour: number, place: () => ScreenPoint | null, now: number): void {
    setText(this.root, kind);
    this.root.style.setProperty('--accent', accentColour(colour));
    this.place = place;
    this.until = now + SHOWN_MS;
  }

  /** Call with every drawn frame; `now` by performance.now(). */
  update(now: number): void {
    const at = now < this.until ? (this.place?.() ?? null) : null;
    this.root.hidden = at === null;
    if (at) this.root.style.transform = `translate(-50%, -100%) translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
  }
}
