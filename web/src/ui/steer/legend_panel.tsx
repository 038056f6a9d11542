// What the colours of an overlay mean, and for Cost the figures of the chosen character.

import type { VNode } from 'preact';
import type { FieldScale } from '../../model/field_scale';
import { formatLength } from '../../model/formatters';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { OverlayKind } from '../../protocol/messages';
import { element } from '../widgets/dom';
import { drawPanel } from '../widgets/panel';

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
  const title = 'Effort to its spot';
  const ends = state.ramp ? rampEnds(state.ramp) : ['near', 'far'];
  if (state.chosen < 0) return { title, about: 'Tap a person to see how hard each way is.', ends };
  const lines = state.ramp ? ` A line every ${state.ramp.step}.` : '';
  return { title, about: `Person ${state.chosen}: far, slow and crowded ground is hard.${lines}`, ends };
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
        title: 'Push of obstacles',
        about: 'It pushes the formation away from their middle.',
        ends: ['none', 'strong'],
      };
    case OverlayKind.Density:
      return { title: 'Density', about: 'How many people stand on a square metre.', ends: ['free', 'crowded'] };
  }
}

function Figures({ state }: { readonly state: StudioState }): VNode | null {
  const { cost } = state;
  if (state.overlay !== OverlayKind.Cost || state.chosen < 0 || !cost) return null;
  const figures = [
    ['Effort from here', formatLength(cost.cost)],
    ['Way to walk', `${formatLength(cost.way)} m`],
    ['Straight line', `${formatLength(cost.straight)} m`],
  ] as const;
  return (
    <dl>
      {figures.map(([label, value]) => (
        <>
          <dt class="secondary">{label}</dt>
          <dd>{value}</dd>
        </>
      ))}
    </dl>
  );
}

export class LegendPanel {
  readonly root = element('section', { class: 'legend panel', 'aria-label': 'Legend' });

  constructor(store: StudioStore) {
    drawPanel(this.root, store, ['overlay', 'chosen', 'cost', 'ramp'], (state) => {
      const text = legendText(state);
      this.root.hidden = text === null;
      if (!text) return null;
      return (
        <>
          <h2>{text.title}</h2>
          <p class="secondary">{text.about}</p>
          <div class="ramp" />
          <div class="ramp-ends secondary">
            {text.ends.map((end) => (
              <span key={end}>{end}</span>
            ))}
          </div>
          <Figures state={state} />
        </>
      );
    });
  }
}
