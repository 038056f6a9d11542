// The panel of whoever measures: tools, the curve of evacuation, and a card for each line and area.

import type { Measures } from '../../model/measures/measures';
import { element, setPressed, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { Figures, MeasureCard, withUnit, type CardActions } from './measure_card';
import { Plot } from './plot';

export type MeasureTool = 'line' | 'area';

export interface MeasureActions extends CardActions {
  /** Draws one, or no longer. */
  draw(tool: MeasureTool): void;
  saveAll(): void;
  saveEvacuation(): void;
  leaveMeasures(): void;
}

const kHints: Record<MeasureTool, string> = {
  line: 'Drag from one end of the line to the other.',
  area: 'Drag from corner to corner of the area.',
};
const kIdle = 'Draw a line across a door to count people, or an area for density and speed.';

function button(label: string, act: () => void, ...children: (Node | string)[]): HTMLButtonElement {
  const made = element('button', { type: 'button', 'aria-label': label, 'data-tip': label }, ...children);
  made.addEventListener('click', act);
  return made;
}

export class MeasurePanel {
  private readonly tools_: Readonly<Record<MeasureTool, HTMLButtonElement>>;
  private readonly hint_ = element('p', { class: 'secondary measure-hint', role: 'status' }, kIdle);
  private readonly evacuation_ = new Plot('People', 'persons', 5);
  private readonly figures_ = new Figures();
  private readonly cards_ = element('div', { class: 'measure-cards' });
  private readonly byId_ = new Map<number, MeasureCard>();
  private readonly foot_ = element('p', { class: 'secondary measure-foot' });
  readonly root: HTMLElement;

  constructor(private readonly actions_: MeasureActions) {
    const tool = (name: MeasureTool, label: string): HTMLButtonElement => {
      const made = element('button', { type: 'button', class: 'soft', 'aria-pressed': 'false' }, label);
      made.addEventListener('click', () => actions_.draw(name));
      return made;
    };
    this.tools_ = { line: tool('line', 'New line'), area: tool('area', 'New area') };
    this.root = element(
      'section',
      { class: 'measure-panel panel', 'aria-label': 'Measures', hidden: true },
      element(
        'header',
        {},
        element('h2', {}, 'Measures'),
        button('Save all as one CSV table', () => actions_.saveAll(), icon('download'), 'All'),
        button('Close the measures', () => actions_.leaveMeasures(), icon('close')),
      ),
      element('div', { class: 'measure-tools', role: 'group', 'aria-label': 'Draw' }, ...Object.values(this.tools_)),
      this.hint_,
      this.cards_,
      this.evacuationCard(),
      this.foot_,
    );
  }

  private evacuationCard(): HTMLElement {
    return element(
      'section',
      { class: 'measure-card measure-evacuation', 'aria-label': 'Evacuation' },
      element(
        'header',
        {},
        element('h3', {}, 'Evacuation'),
        button('Save the evacuation as CSV', () => this.actions_.saveEvacuation(), icon('download')),
      ),
      this.figures_.root,
      element('div', { class: 'plots plots-one' }, this.evacuation_.root),
    );
  }

  setTool(tool: MeasureTool | null): void {
    for (const [name, one] of Object.entries(this.tools_)) setPressed(one, name === tool);
    this.root.toggleAttribute('data-drawing', tool !== null);
    setText(this.hint_, tool ? kHints[tool] : kIdle);
  }

  say(text: string): void {
    setText(this.hint_, text);
  }

  update(measures: Measures): void {
    const { list, time } = measures;
    for (const id of this.byId_.keys()) if (!list.some((one) => one.id === id)) this.drop(id);
    for (const one of list) {
      let card = this.byId_.get(one.id);
      if (!card) {
        card = new MeasureCard(one, this.actions_);
        this.byId_.set(one.id, card);
        this.cards_.prepend(card.root);
      }
      card.update(one, time);
    }
    this.updateEvacuation(measures);
    const gap = measures.longestGap;
    setText(this.foot_, gap > 0 ? `Frames were at most ${gap.toFixed(2)} s apart.` : '');
  }

  private drop(id: number): void {
    this.byId_.get(id)?.root.remove();
    this.byId_.delete(id);
  }

  private updateEvacuation({ evacuation, since, time }: Measures): void {
    const { now, series, lastOut } = evacuation;
    this.figures_.show({
      Inside: now ? String(now.inside) : '–',
      'Out by exits': now ? String(now.out) : '–',
      'Last one out after': withUnit(lastOut, 's', 1),
    });
    const last = now ? [now] : [];
    const samples = [...series.samples, ...last];
    this.evacuation_.draw(since, time, [
      { name: 'inside', points: samples.map((s) => [s.time, s.inside]), stepped: true },
      { name: 'out', points: samples.map((s) => [s.time, s.out]), stepped: true },
    ]);
  }
}
