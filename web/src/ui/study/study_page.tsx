// The page of a run: the card or the bar of its stage, messages, and the way to stop.

import type { VNode } from 'preact';
import type { MessageSender } from '../../link/studio_client';
import { StudyStage, type AnswerFrame, type StudyForm, type StudyState } from '../../protocol/messages';
import { Banner } from '../widgets/banner';
import { Button, Logo } from '../widgets/buttons';
import { Modal } from '../widgets/dialog';
import { ReplayBar, TrialBar, type Moment } from './bars';
import { FormCard, StageCard } from './cards';

export interface StudyView {
  /** Where the run stands; null: nothing came from the server yet. */
  readonly state: StudyState | null;
  /** The form that is asked, and its number among all. */
  readonly form: { readonly form: StudyForm; readonly number: number } | null;
  readonly moment: Moment;
  /** The share of the trials that is done. */
  readonly done: number;
  /** A button of the card was pressed, and nothing has come of it yet. */
  readonly busy: boolean;
  readonly lost: boolean;
  /** A message at the lower edge. */
  readonly toast: { readonly text: string; readonly error: boolean } | null;
  /** The person is asked whether to stop for good. */
  readonly stopping: boolean;
}

export interface StudyActions {
  readonly client: MessageSender;
  /** What the card's button says. */
  goOn(): void;
  answer(answers: AnswerFrame[]): void;
  giveUp(): void;
  askStop(asks: boolean): void;
  /** The person stops for good. */
  stop(): void;
  /** Tries to reach a lost server now. */
  retry(): void;
}

interface Props {
  readonly view: StudyView;
  readonly actions: StudyActions;
}

const kOver: readonly StudyStage[] = [StudyStage.Thanks, StudyStage.BrokenOff, StudyStage.Elsewhere];

function Head({ view: { state, done }, actions }: Props): VNode {
  const kind = state?.test ? ' · test of the page' : '';
  const over = !state || state.run === 0 || kOver.includes(state.stage);
  return (
    <header class="study-head">
      <Logo />
      <strong>Muster study</strong>
      <span class="secondary study-run">{state && state.run > 0 ? `Run ${state.run}${kind}` : kind.slice(3)}</span>
      <progress class="study-progress" max={1} value={done} aria-label="Done" hidden={over} />
      <button type="button" class="study-stop" hidden={over} onClick={() => actions.askStop(true)}>
        Stop taking part
      </button>
    </header>
  );
}

function Stop({ actions }: Pick<Props, 'actions'>): VNode {
  return (
    <Modal title="Stop taking part?" class="help study-dialog" closes="" close={() => actions.askStop(false)}>
      <p>You may stop at any time, without giving a reason. What you did until now is kept.</p>
      <div class="study-buttons">
        <Button act={() => actions.askStop(false)}>Keep taking part</Button>
        <Button class="solid" act={() => actions.stop()}>
          Stop for good
        </Button>
      </div>
    </Modal>
  );
}

function Lost({ actions }: Pick<Props, 'actions'>): VNode {
  return (
    <section class="banner study-lost panel" role="alert">
      <Banner icon="lost" title="Connection lost" text="The run waits, and nothing is lost. Trying again…">
        <div class="banner-buttons">
          <Button act={() => actions.retry()}>Try now</Button>
        </div>
      </Banner>
    </section>
  );
}

function Main({ view: { state, form, busy }, actions }: Props): VNode {
  const stage = state?.stage;
  return (
    <div class="study-main">
      {form && stage === StudyStage.Form ? (
        <FormCard key={form.number} form={form.form} busy={busy} send={(all) => actions.answer(all)} />
      ) : (
        <StageCard key={`${stage} ${state?.trial}`} state={state} busy={busy} act={() => actions.goOn()} />
      )}
    </div>
  );
}

export function StudyPage(props: Props): VNode {
  const { view, actions } = props;
  const { state, moment, toast } = view;
  const stage = state?.stage;
  const isTrial = state !== null && stage === StudyStage.Trial;
  const isReplay = state !== null && stage === StudyStage.Replay;
  return (
    <>
      <div class="study-page" hidden={isTrial || isReplay} inert={view.lost}>
        <Head {...props} />
        {!isTrial && !isReplay && <Main {...props} />}
      </div>
      {isTrial && (
        <TrialBar
          key={state.trial}
          state={state}
          moment={moment}
          giveUp={() => actions.giveUp()}
          stop={() => actions.askStop(true)}
        />
      )}
      {isReplay && <ReplayBar state={state} moment={moment} client={actions.client} />}
      <div class="study-toast panel" role="status" hidden={!toast} data-error={toast?.error ? '' : undefined}>
        {toast?.text}
      </div>
      {view.lost && <Lost actions={actions} />}
      {view.stopping && <Stop actions={actions} />}
    </>
  );
}
