// What stands between the trials: forms, what comes next, a pause, the end.

import { Component, type ComponentChildren, type VNode } from 'preact';
import { StudyStage, TrialEnd, type AnswerFrame, type StudyForm, type StudyState } from '../../protocol/messages';
import { formatClock } from '../../model/formatters';
import { linesOf } from './how_to';
import { answerOf, missingText, Question } from './questions';
import { Button } from '../widgets/buttons';

/** How the last trial went, in one sentence; empty for none. */
export function endText({ ended, seconds, collected, items }: StudyState): string {
  const time = formatClock(seconds);
  switch (ended) {
    case TrialEnd.Done:
      return `All items collected in ${time}.`;
    case TrialEnd.TimeOver:
      return `The time is over: ${collected} of ${items} items collected.`;
    case TrialEnd.GivenUp:
      return `Given up after ${time}, with ${collected} items collected.`;
    case TrialEnd.Practised:
      return 'The practice is over.';
    case TrialEnd.None:
      return '';
  }
}

/** What a card's button does, until which it cannot be pressed again. */
export interface CardAct {
  /** It has been pressed, and nothing has come of it yet. */
  readonly busy: boolean;
  readonly act: () => void;
}

interface CardProps extends CardAct {
  readonly title: string;
  readonly button: string;
  readonly soft?: boolean;
  readonly children: ComponentChildren;
}

/** It is read from its heading on. */
class Heading extends Component<{ readonly text: string }> {
  private root_: HTMLElement | null = null;

  override componentDidMount(): void {
    this.root_!.closest('.study-page')?.scrollTo?.(0, 0);
    this.root_!.focus({ preventScroll: true });
  }

  override render({ text }: { readonly text: string }): VNode {
    return (
      <h1 tabIndex={-1} ref={(made) => void (this.root_ = made)}>
        {text}
      </h1>
    );
  }
}

function Card({ title, button, soft = false, busy, act, children }: CardProps): VNode {
  return (
    <section class="study-card panel">
      <Heading text={title} />
      {children}
      {button && (
        <div class="study-buttons">
          <button type="button" class={`${soft ? 'soft' : 'solid'} study-next`} disabled={busy} onClick={act}>
            {button}
          </button>
        </div>
      )}
    </section>
  );
}

const kNoTouch =
  'This part is done with fingers, and this screen takes no touches. Tell whoever runs the study, and go on at a touch screen.';

/** The next trial waits. */
function Ready({ state, ...act }: CardAct & { readonly state: StudyState }): VNode {
  const { practice, scheme, schemeTitle, environment, environmentText, items, least, limit, trial, trials } = state;
  const last = endText(state);
  const device = state.touch ? 'Use your fingers on the screen.' : 'Use the mouse.';
  const cannot = state.touch && navigator.maxTouchPoints === 0;
  const start = practice ? 'Start the practice' : 'Start';
  return (
    <Card
      title={practice ? `Practice: ${schemeTitle}` : environment}
      button={cannot ? 'Start all the same' : start}
      soft={cannot}
      {...act}
    >
      {cannot && <p class="study-warning">{kNoTouch}</p>}
      {last && <p class="study-last secondary">{last}</p>}
      <p class="study-text">
        {practice
          ? `Collect the golden hexagons: lead the crowd so that somebody touches each. Try the control for ${Math.round(least)} seconds to ${Math.round(limit / 60)} minutes; nothing counts yet.`
          : `${environmentText} Lead the crowd so that somebody touches each of the ${items} golden hexagons, as fast as you can.`}
      </p>
      <div class="study-control">
        <strong>{practice ? device : `${schemeTitle}. ${device}`}</strong>
        <dl class="help-rows study-how">
          {linesOf(scheme).map(([withWhat, does]) => (
            <>
              <dt>{withWhat}</dt>
              <dd>{does}</dd>
            </>
          ))}
        </dl>
      </div>
      <p class="secondary">
        {`Part ${trial} of ${trials}. Rest as long as you like; the clock runs from the moment you start.`}
      </p>
    </Card>
  );
}

interface Words {
  readonly title: string;
  readonly text: string;
  readonly button: string;
}

const kWaiting: Words = { title: 'Muster', text: 'Waiting for the server of the study…', button: '' };
const kWords: Readonly<Partial<Record<StudyStage, Words>>> = {
  [StudyStage.Paused]: {
    title: 'Paused',
    text: 'The connection was lost for a moment. The crowd and the clock have waited; nothing is lost.',
    button: 'Go on',
  },
  [StudyStage.Elsewhere]: {
    title: 'This run goes on in another window',
    text: 'A run is shown in one window at a time. You may bring it back here.',
    button: 'Go on here',
  },
  [StudyStage.Thanks]: {
    title: 'Thank you',
    text: 'That was all. Your answers and inputs are stored.',
    button: 'Next person',
  },
  [StudyStage.BrokenOff]: {
    title: 'Stopped',
    text: 'Thank you for the time you took. What you did until now is kept and marked as broken off.',
    button: 'Next person',
  },
};

/** The card of a stage; null: nothing came from the server yet. */
export function StageCard({ state, ...act }: CardAct & { readonly state: StudyState | null }): VNode {
  if (state?.stage === StudyStage.Ready) return <Ready state={state} {...act} />;
  const { title, text, button } = (state && kWords[state.stage]) ?? kWaiting;
  const over = state?.stage === StudyStage.Thanks || state?.stage === StudyStage.BrokenOff;
  return (
    <Card title={title} button={button} soft={over} {...act}>
      <p class="study-text">{text}</p>
      {over && <p class="secondary">{`Run ${state.run}${state.test ? ', a test of the page' : ''}.`}</p>}
    </Card>
  );
}

export interface FormCardProps {
  readonly form: StudyForm;
  readonly busy: boolean;
  /** Gets the answers once all that are needed are there. */
  readonly send: (answers: AnswerFrame[]) => void;
}

export class FormCard extends Component<FormCardProps> {
  private missing_: readonly string[] = [];

  private readonly submit = (event: Event): void => {
    event.preventDefault();
    const root = event.currentTarget as HTMLFormElement;
    const given = this.props.form.questions.map((question) => ({
      question,
      answer: answerOf(question, new FormData(root)),
    }));
    const missing = given.filter(({ question, answer }) => answer === null && question.needed);
    this.missing_ = missing.map(({ question: { name } }) => name);
    this.forceUpdate();
    if (missing.length === 0) return this.props.send(given.flatMap(({ answer }) => answer ?? []));
    root.querySelector<HTMLElement>(`[name="${this.missing_[0]}"]`)?.focus();
  };

  override render({ form, busy }: FormCardProps): VNode {
    return (
      <form class="study-card panel" noValidate onSubmit={this.submit}>
        <Heading text={form.schemeTitle === '' ? form.title : `${form.title} – ${form.schemeTitle}`} />
        {form.text && <p class="study-text">{form.text}</p>}
        {form.questions.map((question) => (
          <Question
            key={question.name}
            question={question}
            missing={this.missing_.includes(question.name) ? missingText(question) : ''}
          />
        ))}
        {form.source && <p class="study-source secondary">{`Source: ${form.source}`}</p>}
        <div class="study-buttons">
          <Button type="submit" class="solid study-next" disabled={busy}>
            Continue
          </Button>
        </div>
      </form>
    );
  }
}
