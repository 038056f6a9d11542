// What people cannot do at a thing, said beside it, with what makes it fit.

import { render, type VNode } from 'preact';
import type { Mistake } from '../../model/place/motions';
import type { GroundPoint, ScreenPoint } from '../../model/plane';
import { Button } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { PanelLayout } from '../widgets/panel_layout';

/** More than these would hide the place. */
const kMost = 5;
/** From the middle of the thing, and from what panels cover [CSS px]. */
const kBeside = 18;
const kFromPanels = 12;
const kSize = { width: 232, height: 96 };

export interface NotesHost {
  toScreen(point: GroundPoint): ScreenPoint;
  choose(mistake: Mistake): void;
  fit(mistake: Mistake): void;
  readonly page: HTMLElement;
}

export class MistakeNotes {
  readonly root = element('div', { class: 'build-notes' });
  private key_ = '';

  constructor(private readonly host_: NotesHost) {}

  /** Call before every picture. */
  draw(mistakes: readonly Mistake[]): void {
    if (mistakes.length === 0 && this.key_ === '[]') return;
    const free = this.free();
    const within = (value: number, from: number, to: number): number => Math.round(Math.max(from, Math.min(value, to)));
    const notes = mistakes.slice(0, kMost).map((one) => {
      const [x, y] = one.thing.centre;
      const at = this.host_.toScreen({ x, y });
      const left = within(at.x + kBeside, free.left, free.right - kSize.width);
      return { one, left, top: within(at.y + kBeside, free.top, free.bottom - kSize.height) };
    });
    const key = JSON.stringify(notes.map(({ one: { thing, text }, left, top }) => [thing.id, text, left, top]));
    if (key === this.key_) return;
    this.key_ = key;
    render(
      notes.map((note) => this.note(note)),
      this.root,
    );
  }

  /** What panels leave free. */
  private free(): { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number } {
    const layout = PanelLayout.of(this.host_.page);
    const box = (area: 'left' | 'head' | 'foot' | 'sheet'): DOMRect => layout.area(area).getBoundingClientRect();
    const tops = [box('foot'), box('sheet')].filter(({ height }) => height > 0).map(({ top }) => top);
    return {
      left: box('left').right + kFromPanels,
      top: box('head').bottom + kFromPanels,
      right: window.innerWidth - kFromPanels,
      bottom: Math.min(window.innerHeight, ...tops) - kFromPanels,
    };
  }

  private note({ one, left, top }: { readonly one: Mistake; readonly left: number; readonly top: number }): VNode {
    return (
      <div key={one.thing.id} class="build-note panel" role="alert" style={`left: ${left}px; top: ${top}px`}>
        <button type="button" onClick={() => this.host_.choose(one)}>
          {one.text}
        </button>
        <Button class="solid" act={() => this.host_.fit(one)}>
          Make it fit
        </Button>
      </div>
    );
  }
}
