// The panel of whoever measures: tools, the curve of evacuation, and a card for each line and area.

import { render, type VNode } from 'preact';
import type { Measures } from '../../model/measures/measures';
import { Button, toolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
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

function Evacuation({ of, actions }: { readonly of: Measures; readonly actions: MeasureActions }): VNode {
  const { evacuation, since, time } = of;
  const { now, series, lastOut } = evacuation;
  const samples = [...series.samples, ...(now ? [now] : [])];
  return (
    <section class="measure-card measure-evacuation" aria-label="Evacuation">
      <header>
        <h3>Evacuation</h3>
        {toolButton('download', 'Save the evacuation as CSV', () => actions.saveEvacuation(), { iconOnly: true })}
      </header>
      <Figures
        of={{
          Inside: now ? String(now.inside) : '–',
          'Out by exits': now ? String(now.out) : '–',
          'Last one out after': withUnit(lastOut, 's', 1),
        }}
      />
      <div class="plots plots-one">
        <Plot
          quantity="People"
          unit="persons"
          least={5}
          from={since}
          to={time}
          curves={[
            { name: 'inside', points: samples.map((s) => [s.time, s.inside]), stepped: true },
            { name: 'out', points: samples.map((s) => [s.time, s.out]), stepped: true },
          ]}
        />
      </div>
    </section>
  );
}

export class MeasurePanel {
  readonly root = element('section', { class: 'measure-panel panel', 'aria-label': 'Measures', hidden: true });
  private tool_: MeasureTool | null = null;
  private said_ = kIdle;

  constructor(
    private readonly actions_: MeasureActions,
    private readonly measures_: Measures,
  ) {}

  setTool(tool: MeasureTool | null): void {
    this.tool_ = tool;
    this.root.toggleAttribute('data-drawing', tool !== null);
    this.say(tool ? kHints[tool] : kIdle);
  }

  say(text: string): void {
    this.said_ = text;
    this.update();
  }

  update(): void {
    if (this.root.hidden) return;
    const { actions_: actions, measures_: measures, tool_: drawn } = this;
    const { list, time, longestGap: gap } = measures;
    const tool = (name: MeasureTool, label: string): VNode => (
      <Button aria-pressed={name === drawn} act={() => actions.draw(name)}>
        {label}
      </Button>
    );
    render(
      <>
        <header>
          <h2>Measures</h2>
          {toolButton('download', 'Save all as one CSV table', () => actions.saveAll(), { word: 'All' })}
          {toolButton('close', 'Close the measures', () => actions.leaveMeasures(), { iconOnly: true })}
        </header>
        <div class="measure-tools" role="group" aria-label="Draw">
          {tool('line', 'New line')}
          {tool('area', 'New area')}
        </div>
        <p class="secondary measure-hint" role="status">
          {this.said_}
        </p>
        <div class="measure-cards">
          {[...list].reverse().map((one) => (
            <MeasureCard key={one.id} one={one} time={time} actions={actions} />
          ))}
        </div>
        <Evacuation of={measures} actions={actions} />
        <p class="secondary measure-foot">{gap > 0 ? `Frames were at most ${gap.toFixed(2)} s apart.` : ''}</p>
      </>,
      this.root,
    );
  }
}
