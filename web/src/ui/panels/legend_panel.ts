// What the colours of an overlay mean, and for Cost the figures of the chosen character.

import { OverlayKind } from '../../protocol/messages';
import { element, setText } from '../widgets/dom';
import { formatLength } from '../../model/formatters';
import type { StudioState } from '../../model/studio_state';
import type { FieldScale } from '../../model/field_scale';
import type { StudioStore } from '../../model/studio_store';

interface LegendText {
  readonly title: string;
  readonly about: string;
  readonly ends: readonly string[];
}

/** The numbers under the ramp: every fifth contour. */
export function rampEnds(ramp: FieldScale): string[] {
  const count = Math.max(1, Math.round(ramp.max / (5 * ramp.step)));
  const ends = Array.from({ length: count + 1 }, (_, i) => String(Number(((ramp.max * i) / count).toPrecision(3))));
  if (ramp.beyond) ends[count] += '+';
  return ends;
}

function costText(state: StudioState): LegendText {
  const title = 'Cost to its place';
  const ends = state.ramp ? rampEnds(state.ramp) : ['near', 'far'];
  if (state.chosen < 0) return { title, about: 'Tap a character to see its field.', ends };
  const lines = state.ramp ? ` One line per ${state.ramp.step === 1 ? 'unit' : state.ramp.step}.` : '';
  return { title, about: `Character ${state.chosen}.${lines}`, ends };
}

/** The words for the shown overlay; null where there is none. */
export function legendText(state: StudioState): LegendText | null {
  switch (state.overlay) {
    case OverlayKind.None:
    case OverlayKind.Reach:
      return null;
    case OverlayKind.Cost:
      return costText(state);
    case OverlayKind.Field:
      return {
        title: 'Field of obstacles',
        about: 'It pushes the mesh away from their middle.',
        ends: ['none', 'strong'],
      };
    case OverlayKind.Density:
      return { title: 'Density', about: 'Characters on the ground, as costs see them.', ends: ['free', 'crowded'] };
  }
}

export class LegendPanel {
  private readonly title_ = element('h2');
  private readonly about_ = element('p', { class: 'secondary' });
  private readonly ends_ = element('div', { class: 'ramp-ends secondary' });
  private readonly figures_ = element('dl');
  readonly root = element(
    'section',
    { class: 'legend panel', 'aria-label': 'Legend' },
    this.title_,
    this.about_,
    element('div', { class: 'ramp' }),
    this.ends_,
    this.figures_,
  );

  constructor(store: StudioStore) {
    store.watch(['overlay', 'chosen', 'cost', 'ramp'], (state) => this.show(state));
  }

  private show(state: StudioState): void {
    const text = legendText(state);
    this.root.hidden = text === null;
    if (!text) return;
    setText(this.title_, text.title);
    setText(this.about_, text.about);
    this.ends_.replaceChildren(...text.ends.map((end) => element('span', {}, end)));
    const { cost } = state;
    this.figures_.hidden = state.overlay !== OverlayKind.Cost || state.chosen < 0 || cost === null;
    if (!cost) return;
    this.figures_.replaceChildren(
      ...this.figure('Cost from here', formatLength(cost.cost)),
      ...this.figure('Way to walk', `${formatLength(cost.way)} m`),
      ...this.figure('Straight line', `${formatLength(cost.straight)} m`),
    );
  }

  private figure(label: string, value: string): HTMLElement[] {
    return [element('dt', { class: 'secondary' }, label), element('dd', {}, value)];
  }
}
