// The bars above a trial and above a replayed one: what it is, the clock, the items, and what can be done with it.

import { Component, type ComponentChildren, type VNode } from 'preact';
import { PlaybackAction, type StudyState } from '../../protocol/messages';
import type { MessageSender } from '../../link/studio_client';
import { formatClock } from '../../model/formatters';
import { Button, Icon } from '../widgets/buttons';
import { endText } from './cards';

/** A button that ends something asks once more; it forgets that after this time [ms]. */
const kSure = 4000;
const kSpeeds = [1, 2, 4, 8] as const;

/** What a frame tells. */
export interface Moment {
  readonly time: number;
  readonly playing: boolean;
  readonly speed: number;
  readonly collected: number;
}

interface BarProps {
  readonly title: string;
  readonly about: string;
  readonly items: number;
  readonly moment: Moment;
  readonly children: ComponentChildren;
}

function Bar({ title, about, items, moment: { time, collected }, children }: BarProps): VNode {
  return (
    <header class="study-bar panel">
      <div class="study-bar-words">
        <strong>{title}</strong>
        <span class="secondary">{about}</span>
      </div>
      <div class="study-figures">
        <strong class="study-clock" role="timer" aria-label="Time">
          {formatClock(time)}
        </strong>
        <span class="study-item-dot" aria-hidden="true" />
        <strong class="study-items">{`${collected} / ${items}`}</strong>
      </div>
      {children}
    </header>
  );
}

export interface TrialBarProps {
  readonly state: StudyState;
  readonly moment: Moment;
  readonly giveUp: () => void;
  /** The person wants to stop for good. */
  readonly stop: () => void;
}

export class TrialBar extends Component<TrialBarProps> {
  private sure_ = 0;

  override componentWillUnmount(): void {
    window.clearTimeout(this.sure_);
  }

  /** A practice may end without further questions. */
  private readonly pressed = (): void => {
    if (!this.props.state.practice && this.sure_ === 0) {
      this.sure_ = window.setTimeout(() => this.calm(), kSure);
      return this.forceUpdate();
    }
    this.calm();
    this.props.giveUp();
  };

  private calm(): void {
    window.clearTimeout(this.sure_);
    this.sure_ = 0;
    this.forceUpdate();
  }

  override render({ state, moment, stop }: TrialBarProps): VNode {
    const { practice, environment, schemeTitle, trial, trials, least, items } = state;
    return (
      <Bar
        title={practice ? 'Practice' : environment}
        about={practice ? 'Collect the golden hexagons' : `${schemeTitle} · ${trial} of ${trials}`}
        items={items}
        moment={moment}
      >
        <div class="study-ends">
          <Button class="soft study-end" disabled={moment.time < least} act={this.pressed}>
            {practice ? 'End practice' : this.sure_ > 0 ? 'Really give up?' : 'Give up'}
          </Button>
          <button type="button" class="study-stop" onClick={stop}>
            Stop taking part
          </button>
        </div>
      </Bar>
    );
  }
}

export interface ReplayBarProps {
  readonly state: StudyState;
  readonly moment: Moment;
  readonly client: MessageSender;
}

export function ReplayBar({ state, moment, client }: ReplayBarProps): VNode {
  const { environment, schemeTitle, trial, run, items } = state;
  const kind = state.test ? ' · test' : state.practice ? ' · practice' : '';
  const { playing } = moment;
  const play = (action: PlaybackAction): void => client.send({ type: 'Playback', action });
  return (
    <Bar
      title={`${environment} · ${schemeTitle}`}
      about={`Trial ${trial} of run ${run}${kind}. ${endText(state)}`}
      items={items}
      moment={moment}
    >
      <div class="study-transport">
        <button type="button" aria-label="From the start" onClick={() => play(PlaybackAction.Restart)}>
          <Icon name="restart" />
        </button>
        <Button
          class="solid"
          aria-label={playing ? 'Pause' : 'Play'}
          act={() => play(playing ? PlaybackAction.Pause : PlaybackAction.Play)}
        >
          <Icon name={playing ? 'pause' : 'play'} />
        </Button>
        <div class="segments" role="group" aria-label="Speed">
          {kSpeeds.map((factor) => (
            <button
              key={factor}
              type="button"
              aria-pressed={factor === moment.speed}
              onClick={() => client.send({ type: 'SetSpeed', factor })}
            >
              {`${factor}×`}
            </button>
          ))}
        </div>
      </div>
    </Bar>
  );
}
