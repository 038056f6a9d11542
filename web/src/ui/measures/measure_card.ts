// What one line or area has measured: figures, plots, its place, its name, its table.

import { kWindow, type AreaMeasure, type LineMeasure, type Measure } from '../../model/measures/measures';
import type { GroundPoint } from '../../model/plane';
import { numberField } from '../widgets/fields';
import { buildIcon } from '../widgets/build_icons';
import { element, setPressed, setText } from '../widgets/dom';
import { icon } from '../widgets/icons';
import { Plot, type PlotPoint } from './plot';

export interface CardActions {
  rename(id: number, name: string): void;
  hide(id: number, hidden: boolean): void;
  remove(id: number): void;
  save(id: number): void;
  /** Other ends of a line, or corners of an area: it begins anew. */
  place(id: number, points: readonly GroundPoint[]): void;
}

/** Points of a curve of flow. */
const kFlowPoints = 120;
const kFar = { min: -1e5, max: 1e5, unit: 'm' };

export function withUnit(value: number, unit: string, digits = 2): string {
  return Number.isFinite(value) ? `${value.toFixed(digits)} ${unit}` : '–';
}

/** Names and values, side by side. */
export class Figures {
  readonly root = element('dl', { class: 'measure-figures' });
  private readonly values_ = new Map<string, HTMLElement>();

  show(figures: Readonly<Record<string, string>>): void {
    for (const [name, value] of Object.entries(figures)) {
      const known = this.values_.get(name);
      if (known) setText(known, value);
      else {
        const made = element('dd', {}, value);
        this.values_.set(name, made);
        this.root.append(element('div', {}, element('dt', {}, name), made));
      }
    }
  }
}

function iconButton(label: string, picture: Element, act: () => void): HTMLButtonElement {
  const button = element('button', { type: 'button', 'aria-label': label, 'data-tip': label }, picture);
  button.addEventListener('click', act);
  return button;
}

/** Curves are drawn from when on it measures. */
export class MeasureCard {
  readonly root = element('section', { class: 'measure-card' });
  private readonly figures_ = new Figures();
  private readonly plots_: readonly [Plot, Plot];
  private readonly hide_: HTMLButtonElement;
  private readonly place_ = element('div', { class: 'build-fields' });
  private placed_ = '';

  constructor(
    private one_: Measure,
    private readonly actions_: CardActions,
  ) {
    const { id, name, kind } = one_;
    const title = element('input', {
      type: 'text',
      maxlength: 40,
      value: name,
      'aria-label': 'Name',
      autocomplete: 'off',
    });
    title.addEventListener('change', () => {
      if (title.value.trim()) actions_.rename(id, title.value.trim());
      title.value = this.one_.name;
    });
    this.hide_ = iconButton('Hide', icon('watch'), () => actions_.hide(id, !this.one_.hidden));
    this.hide_.setAttribute('aria-pressed', 'false');
    const acts = [
      this.hide_,
      iconButton('Save as CSV', icon('download'), () => actions_.save(id)),
      iconButton('Remove', buildIcon('remove'), () => actions_.remove(id)),
    ];
    this.plots_ =
      kind === 'line'
        ? [new Plot('N', 'persons', 5), new Plot(`Flow, ${kWindow} s`, '1/s', 1)]
        : [new Plot('Density', '1/m²', 1), new Plot('Speed', 'm/s', 1.5)];
    this.root.append(
      element('header', {}, title, ...acts),
      this.figures_.root,
      element('div', { class: 'plots' }, ...this.plots_.map(({ root }) => root)),
      element('details', {}, element('summary', {}, 'Place'), this.place_),
    );
  }

  update(one: Measure, time: number): void {
    this.one_ = one;
    this.root.setAttribute('aria-label', one.name);
    setPressed(this.hide_, one.hidden);
    if (one.kind === 'line') this.updateLine(one, time);
    else this.updateArea(one, time);
    const points = one.kind === 'line' ? [one.a, one.b] : [...one.record.polygon];
    const key = JSON.stringify(points);
    if (key === this.placed_) return;
    this.placed_ = key;
    this.place_.replaceChildren(...this.placeFields(points));
  }

  private updateLine(one: LineMeasure, time: number): void {
    const { record, since, a, b } = one;
    const figures = record.figures(time, kWindow, since);
    const width = Math.hypot(b.x - a.x, b.y - a.y);
    const both = `${figures.rightFlow.toFixed(2)} / ${figures.leftFlow.toFixed(2)} /s`;
    this.figures_.show({
      'Persons who crossed, N': String(figures.persons),
      'With the arrow / against it': `${figures.right} / ${figures.left}`,
      [`Flow of the last ${kWindow} s`]: both,
      'Mean flow since the first person': withUnit(figures.meanFlow, '/s'),
      'Mean flow per metre of the line': withUnit(figures.meanFlow / width, '/s/m'),
    });
    const [crossed, flow] = this.plots_;
    const curve = (direction: 1 | -1): PlotPoint[] => {
      let count = 0;
      const points: PlotPoint[] = [[since, 0]];
      for (const crossing of record.crossings)
        if (crossing.direction === direction) points.push([crossing.time, ++count]);
      return [...points, [time, count]];
    };
    crossed.draw(since, time, [
      { name: 'with', points: curve(1), stepped: true },
      { name: 'against', points: curve(-1), stepped: true },
    ]);
    const flows = Array.from({ length: kFlowPoints + 1 }, (_, k) => {
      const at = since + ((time - since) * k) / kFlowPoints;
      return { at, ...record.flowAt(at, kWindow, since) };
    });
    flow.draw(since, time, [
      { points: flows.map(({ at, right }) => [at, right]) },
      { points: flows.map(({ at, left }) => [at, left]) },
    ]);
  }

  private updateArea({ record, since }: AreaMeasure, time: number): void {
    const { samples, last } = record.series;
    this.figures_.show({
      Persons: last ? String(last.persons) : '–',
      Area: withUnit(record.size, 'm²'),
      Density: withUnit(last?.density ?? NaN, '/m²'),
      'Mean speed': withUnit(last?.speed ?? NaN, 'm/s'),
    });
    const [density, speed] = this.plots_;
    density.draw(since, time, [{ points: samples.map((s) => [s.time, s.density]) }]);
    speed.draw(since, time, [{ points: samples.map((s) => [s.time, s.speed]) }]);
  }

  /** Ends of a line; of an area, which is a rectangle, two corners. */
  private placeFields(points: readonly GroundPoint[]): HTMLElement[] {
    const isLine = points.length === 2;
    const ends = isLine ? points : [points[0]!, points[2]!];
    const field = (k: number, axis: 'x' | 'y'): HTMLElement =>
      numberField(`${k === 0 ? 'From' : 'To'} ${axis}`, ends[k]![axis], kFar, (value) => {
        const [from, to] = ends.map((end, n) => (n === k ? { ...end, [axis]: value } : end));
        if (!from || !to || (from.x === to.x && from.y === to.y)) return;
        if (!isLine && (from.x === to.x || from.y === to.y)) return;
        this.actions_.place(this.one_.id, isLine ? [from, to] : rectangle(from, to));
      });
    return [field(0, 'x'), field(0, 'y'), field(1, 'x'), field(1, 'y')];
  }
}

/** The corners of a rectangle with these two opposite ones. */
export function rectangle(from: GroundPoint, to: GroundPoint): GroundPoint[] {
  return [from, { x: to.x, y: from.y }, to, { x: from.x, y: to.y }];
}
