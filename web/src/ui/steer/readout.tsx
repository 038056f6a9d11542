// How the crowd does, in plain words; on request the figures: people, step time, lag, swaps, and what the plan's
// objective comes to.

import type { VNode } from 'preact';
import { formatCount, formatFigure, formatMs } from '../../model/formatters';
import { kObjectives, objectiveFigure, objectiveOf, objectivesFor, objectiveText } from '../../model/objective';
import { plainWords } from '../../model/plain_words';
import { standingSum } from '../../model/standing';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { Button, Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { Held } from '../widgets/held';
import { drawPanel } from '../widgets/panel';
import { Sparkline } from '../widgets/sparkline';

/** Frames per point of a sparkline: it shows about ten seconds. */
const kEvery = 12;

interface FigureProps {
  readonly name: string;
  readonly label: string;
  readonly value: string;
  readonly unit: string;
  readonly before?: string;
  readonly spark?: Sparkline;
  readonly tip?: string;
}

function Figure({ name, label, value, unit, before = '', spark, tip }: FigureProps): VNode {
  return (
    <div class={`figure figure-${name}`} data-tip={tip}>
      <span class="figure-label secondary">{label}</span>
      {spark && <Held make={() => spark.root} />}
      <span class="figure-value">
        <span class="figure-before secondary">{before}</span>
        <strong class="value">{value}</strong>
        <span class="unit secondary">{unit}</span>
      </span>
    </div>
  );
}

interface Props {
  readonly state: StudioState;
  readonly actions: StudioActions;
}

function Words({ state, actions }: Props): VNode {
  const words = plainWords(state);
  return (
    <button
      type="button"
      class="plain"
      aria-label={state.figures ? 'Figures of the crowd' : undefined}
      aria-expanded={state.figures}
      data-tip="Shows figures, or hides them"
      onClick={() => actions.toggleFigures()}
    >
      <span class="plain-words">
        <strong class="plain-people">{words.people}</strong>
        <span class="plain-does">{words.does}</span>
        <span class="plain-barred unseen">{words.barred}</span>
        <span class="plain-items">{words.items}</span>
        <span class="plain-slow">{words.barred === '' ? words.slow : ''}</span>
      </span>
      <Icon name="chevron" />
    </button>
  );
}

/** What the chosen objective comes to; all of them in the tip. */
function Objective({ state, actions }: Props): VNode {
  const { parameters, walks } = state;
  const shown = objectivesFor(parameters);
  const chosen = objectiveOf(parameters);
  const all = kObjectives.map((_, index) => objectiveText(index, walks)).join(', ');
  return (
    <div
      class="figure figure-objective"
      hidden={shown.length === 0}
      data-tip={`What matters when people are given their spots. The walks at present: ${all}`}
    >
      <select
        class="objective"
        aria-label="What matters when people are given their spots"
        value={chosen}
        onChange={({ currentTarget }) => actions.setObjective(Number(currentTarget.value))}
      >
        {kObjectives.map(({ label }, index) => (
          <option key={label} value={index} hidden={!shown.includes(index)} disabled={!shown.includes(index)}>
            {label}
          </option>
        ))}
      </select>
      <span class="figure-value">
        <strong class="value">{chosen < 0 ? '' : objectiveFigure(chosen, walks)}</strong>
      </span>
    </div>
  );
}

export class Readout {
  readonly root = element('section', { class: 'readout panel', 'aria-label': 'How the crowd does' });
  private readonly stepSpark_ = new Sparkline(16, 1);
  private readonly lagSpark_ = new Sparkline(0, 1);
  private readonly swapsSpark_ = new Sparkline(0, 0.2);
  /** As of when figures were shown last: they would not be read, did they change with every frame. */
  private shown_: Pick<StudioState, 'stepMs' | 'lag' | 'swaps' | 'walks'> | null = null;

  constructor(store: StudioStore, actions: StudioActions) {
    drawPanel(this.root, store, ['parameters', 'frames', 'figures'], (state) => {
      this.root.classList.toggle('open', state.figures);
      this.observe(state);
      const { barred } = standingSum(state.standings);
      const { stepMs, lag, swaps, walks } = this.shown_ ?? state;
      return (
        <>
          <Words state={state} actions={actions} />
          {barred !== '' && (
            <Button class="soft plain-show" data-tip={`${barred}: shows them`} act={() => actions.showBarred()}>
              Show
            </Button>
          )}
          {state.figures && (
            <div class="figures">
              <Figure name="characters" label="People" value={formatCount(state.characters)} unit="people" />
              <Figure
                name="ms"
                label="Computing"
                value={formatMs(stepMs)}
                unit="ms"
                spark={this.stepSpark_}
                tip="What the computer takes for a 60th of a second; above the dashes, 16 ms, the crowd is slower than it should be"
              />
              <Figure
                name="lag"
                label="Behind"
                before="behind"
                value={formatFigure(lag)}
                unit="m"
                spark={this.lagSpark_}
                tip="19 of 20 people are nearer to their spots than this"
              />
              <Figure
                name="swaps"
                label="New spots"
                value={formatFigure(swaps)}
                unit="/s"
                spark={this.swapsSpark_}
                tip="How often a person takes another spot without an order, each second"
              />
              <Objective state={{ ...state, walks }} actions={actions} />
            </div>
          )}
        </>
      );
    });
  }

  private observe(state: StudioState): void {
    if (this.shown_ && state.frames % kEvery !== 1) return;
    const { stepMs, lag, swaps, walks } = state;
    this.shown_ = { stepMs, lag, swaps, walks };
    this.stepSpark_.push(stepMs);
    this.lagSpark_.push(lag);
    this.swapsSpark_.push(swaps);
  }
}
