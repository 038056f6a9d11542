// What is round the stages of a run: the card, the bars of trials, messages, and the way to stop.

import { StudyStage, type StudyState } from '../../protocol/messages';
import type { LinkState } from '../../model/link_state';
import { element, setText } from '../widgets/dom';
import { icon, logo } from '../widgets/icons';

export interface ShellActions {
  /** The person stops for good. */
  stop(): void;
  /** Tries to reach a lost server now. */
  retry(): void;
}

/** Messages vanish after this time [ms]. */
const kToast = 4000;
const kOver: readonly StudyStage[] = [StudyStage.Thanks, StudyStage.BrokenOff, StudyStage.Elsewhere];

export class StudyShell {
  private readonly main_ = element('div', { class: 'study-main' });
  private readonly run_ = element('span', { class: 'secondary study-run' });
  private readonly progress_ = element('progress', { class: 'study-progress', max: 1, value: 0, 'aria-label': 'Done' });
  private readonly stop_ = element('button', { type: 'button', class: 'study-stop' }, 'Stop taking part');
  private readonly page_: HTMLElement;
  private readonly toast_ = element('div', { class: 'study-toast panel', role: 'status', hidden: true });
  private readonly lostText_ = element('span', { class: 'secondary' });
  private readonly lost_: HTMLElement;
  private readonly dialog_: HTMLDialogElement;
  private timer_ = 0;
  private known_ = false;

  constructor(root: HTMLElement, bars: readonly HTMLElement[], actions: ShellActions) {
    this.page_ = element(
      'div',
      { class: 'study-page' },
      element(
        'header',
        { class: 'study-head' },
        logo(),
        element('strong', {}, 'Muster study'),
        this.run_,
        this.progress_,
        this.stop_,
      ),
      this.main_,
    );
    const retry = element('button', { type: 'button', class: 'soft' }, 'Try now');
    retry.addEventListener('click', () => actions.retry());
    this.lost_ = element(
      'section',
      { class: 'banner study-lost panel', role: 'alert', hidden: true },
      icon('lost', 24),
      element('div', { class: 'banner-words' }, element('strong', {}, 'Connection lost'), this.lostText_),
      element('div', { class: 'banner-buttons' }, retry),
    );
    this.dialog_ = this.stopDialog(() => actions.stop());
    this.stop_.addEventListener('click', () => this.askStop());
    this.stop_.hidden = true;
    for (const bar of bars) bar.hidden = true;
    root.append(this.page_, ...bars, this.toast_, this.lost_, this.dialog_);
  }

  private stopDialog(stop: () => void): HTMLDialogElement {
    const yes = element('button', { type: 'button', class: 'solid' }, 'Stop for good');
    const no = element('button', { type: 'button', class: 'soft' }, 'Keep taking part');
    const dialog = element(
      'dialog',
      { class: 'study-dialog', 'aria-labelledby': 'study-stop-title' },
      element('h2', { id: 'study-stop-title' }, 'Stop taking part?'),
      element('p', {}, 'You may stop at any time, without giving a reason. What you did until now is kept.'),
      element('div', { class: 'study-buttons' }, no, yes),
    );
    no.addEventListener('click', () => dialog.close());
    yes.addEventListener('click', () => {
      dialog.close();
      stop();
    });
    return dialog;
  }

  askStop(): void {
    this.dialog_.showModal();
  }

  /** Puts a card on the page, in place of the scene or of the card before. */
  showCard(card: HTMLElement): void {
    this.page_.hidden = false;
    this.main_.replaceChildren(card);
    this.page_.scrollTop = 0;
    const heading = card.querySelector<HTMLElement>('h1');
    heading?.focus({ preventScroll: true });
  }

  /** Takes the card away: a trial is on show. */
  showScene(): void {
    this.page_.hidden = true;
    this.main_.replaceChildren();
  }

  /** What was refused may be tried again. */
  enableButtons(): void {
    for (const button of this.main_.querySelectorAll('button')) button.disabled = false;
  }

  showRun(state: StudyState): void {
    this.known_ = true;
    const kind = state.test ? ' · test of the page' : '';
    setText(this.run_, state.run > 0 ? `Run ${state.run}${kind}` : kind.slice(3));
    this.stop_.hidden = state.run === 0 || kOver.includes(state.stage);
    this.progress_.hidden = this.stop_.hidden;
    if (state.trial > 0) this.progress_.value = (state.trial - 1) / Math.max(1, state.trials);
  }

  showLink(link: LinkState): void {
    const lost = link.phase !== 'open' && this.known_;
    this.lost_.hidden = !lost;
    setText(this.lostText_, 'The run waits, and nothing is lost. Trying again…');
    this.page_.inert = lost;
  }

  /** A message at the lower edge. */
  tell(text: string, error = false): void {
    window.clearTimeout(this.timer_);
    this.toast_.hidden = false;
    this.toast_.toggleAttribute('data-error', error);
    setText(this.toast_, text);
    this.timer_ = window.setTimeout(() => (this.toast_.hidden = true), kToast);
  }
}
