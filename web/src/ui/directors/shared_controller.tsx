// Who paused, builds or changed the place is named to the others; and whoever changes it can ask them first.

import { render, type VNode } from 'preact';
import { othersOf, type Consent } from '../../model/consent';
import { namesOf, sharedNews } from '../../model/shared_news';
import { PlaybackAction } from '../../protocol/messages';
import { Banner } from '../widgets/banner';
import { Button, Icon } from '../widgets/buttons';
import { Modal } from '../widgets/dialog';
import { element } from '../widgets/dom';
import type { SharedParts } from './lazy_shared';
import '../styles/shared.css';

/** What somebody did stays so long on the screen; the list of directors offers the way back longer [ms]. */
const kNewsStays = 20000;
/** An answer is waited for so long [s]; it is the server's time. */
const kAnswerIn = 15;

type Stage = 'choose' | 'asking' | 'refused';

export class SharedController {
  private readonly banner_ = element('section', { class: 'banner panel shared-banner', role: 'status' });
  private readonly dialog_ = element('div', { class: 'dialogs' });
  private stage_: Stage = 'choose';
  private until_ = 0;
  private minds_ = '';
  /** The last change has been read. */
  private seen_ = false;
  private change_ = '';
  private timer_ = 0;

  constructor(private readonly parts_: SharedParts) {
    const { client, store, page } = parts_;
    (page.querySelector('.banners') ?? page).prepend(this.banner_);
    page.append(this.dialog_);
    store.watch(['shared', 'directors', 'playing', 'title', 'replaying', 'asked'], () => this.showBanner());
    store.watch(['consent'], ({ consent }) => this.consentChanged(consent));
    store.watch(['directors'], () => othersOf(store.state).length === 0 && this.decide(true));
    client.on('scene', ({ world }) => this.noteChange(world));
    client.on('askAnswered', ({ allowed, client: by }) => this.answered(allowed, by));
    window.setInterval(() => this.tick(), 500);
  }

  private nameOf(client: number): string {
    return this.parts_.store.state.directors.find((one) => one.client === client)?.name ?? 'Somebody';
  }

  private tick(): void {
    if (this.parts_.store.state.asked) this.showBanner();
    if (this.stage_ === 'asking') this.drawDialog();
  }

  // The banner.

  private noteChange(world: number): void {
    const { change, changer, before } = this.parts_.store.state.shared;
    const now = `${world} ${change} ${changer} ${before}`;
    if (now === this.change_) return;
    this.change_ = now;
    this.seen_ = false;
    window.clearTimeout(this.timer_);
    this.timer_ = window.setTimeout(() => this.read(), kNewsStays);
    this.showBanner();
  }

  private read(): void {
    this.seen_ = true;
    this.showBanner();
  }

  private showBanner(): void {
    const { asked } = this.parts_.store.state;
    const news = sharedNews(this.parts_.store.state, this.seen_);
    this.banner_.hidden = !asked && !news;
    this.banner_.setAttribute('role', asked ? 'alert' : 'status');
    render(this.bannerContent(), this.banner_);
  }

  private bannerContent(): VNode | null {
    const { asked, directors } = this.parts_.store.state;
    if (asked) {
      const left = Math.max(0, Math.ceil((asked.until - performance.now()) / 1000));
      return (
        <>
          <Icon name="directors" size={24} />
          <div class="banner-words">
            <strong>{`${this.nameOf(asked.client)} would like to ${asked.wish}.`}</strong>
            <span class="secondary" aria-hidden="true">{`Without an answer it is done in ${left} s.`}</span>
          </div>
          <div class="banner-buttons">
            <Button act={() => this.reply(false)}>Not now</Button>
            <Button class="solid" act={() => this.reply(true)}>
              Allow
            </Button>
          </div>
        </>
      );
    }
    const news = sharedNews(this.parts_.store.state, this.seen_);
    if (!news || directors.length === 0) return null;
    const act = news.offer === 'play' ? PlaybackAction.Play : PlaybackAction.GoBack;
    return (
      <Banner icon="directors" title={news.text}>
        <div class="banner-buttons">
          <Button class="solid" act={() => this.parts_.client.send({ type: 'Playback', action: act })}>
            {news.offerText}
          </Button>
        </div>
        {news.offer === 'back' && (
          <button type="button" class="notice-close" aria-label="Close the message" onClick={() => this.read()}>
            <Icon name="close" />
          </button>
        )}
      </Banner>
    );
  }

  private reply(allow: boolean): void {
    const { client, store } = this.parts_;
    const { asked } = store.state;
    store.set({ asked: null });
    if (asked) client.send({ type: 'AnswerAsk', number: asked.number, allow });
  }

  // The dialog.

  private consentChanged(consent: Consent | null): void {
    if (consent) this.stage_ = 'choose';
    this.drawDialog();
  }

  private decide(goes: boolean): void {
    const { client, store } = this.parts_;
    const { consent } = store.state;
    if (!consent) return;
    if (this.stage_ === 'asking') client.send({ type: 'AskOthers', request: '' });
    this.stage_ = 'choose';
    store.set({ consent: null });
    if (goes) consent.then();
    else consent.never();
  }

  private ask(): void {
    const { client, store } = this.parts_;
    this.stage_ = 'asking';
    this.until_ = performance.now() + 1000 * kAnswerIn;
    client.send({ type: 'AskOthers', request: store.state.consent!.wish.text });
    this.drawDialog();
  }

  private answered(allows: boolean, by: number): void {
    if (this.stage_ !== 'asking') return;
    this.stage_ = 'refused';
    if (allows) return this.decide(true);
    this.minds_ = this.nameOf(by);
    this.drawDialog();
  }

  private drawDialog(): void {
    const { consent } = this.parts_.store.state;
    render(consent && this.dialogContent(consent), this.dialog_);
  }

  private dialogContent({ wish }: Consent): VNode {
    const others = othersOf(this.parts_.store.state).map(({ name }) => name);
    const are =
      others.length > 1 ? `${others.length} others are directing here.` : `${others[0]} is directing here, too.`;
    const left = Math.max(0, Math.ceil((this.until_ - performance.now()) / 1000));
    const title = {
      choose: `${are} ${wish.question}`,
      asking: `${namesOf(others)} ${others.length > 1 ? 'are' : 'is'} asked.`,
      refused: `${this.minds_} would rather not now.`,
    }[this.stage_];
    const choice = (label: string, act: () => void, solid = false): VNode => (
      <Button key={label} class={solid ? 'solid' : 'soft'} autofocus={solid} act={act}>
        {label}
      </Button>
    );
    return (
      <Modal title={title} class="help consent" closes="" close={() => this.decide(false)}>
        {this.stage_ === 'asking' && <p class="secondary">{`Who does not answer in ${left} s agrees.`}</p>}
        <div class="consent-choices">
          {choice('Cancel', () => this.decide(false))}
          {choice(wish.yes, () => this.decide(true))}
          {this.stage_ === 'choose' && choice('Ask them', () => this.ask(), true)}
        </div>
      </Modal>
    );
  }
}
