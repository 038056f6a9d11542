// Below the top row, one above the other: the lost connection with what is safe, and a message of the server.

import { NoticeLevel, type Notice } from '../protocol/messages';
import { element, setText } from './dom';
import { formatClock } from './formatters';
import { icon, type IconName } from './icons';
import { noticeDetail } from './notices';
import type { StudioActions } from './studio_actions';
import type { StudioState, StudioStore } from './studio_state';

/** What a lost connection means for the visitor. */
export function lostText(recorded: number, secondsToRetry: number): string {
  const safe = recorded >= 0 ? ` Your take is safe up to ${formatClock(recorded)}.` : '';
  const again = secondsToRetry > 0 ? `Trying again in ${secondsToRetry} s.` : 'Trying again now.';
  return `The crowd waits.${safe} ${again}`;
}

export class LostBanner {
  private readonly title = element('strong', {}, 'Connection lost');
  private readonly text = element('span', { class: 'secondary' });
  private readonly retry = element('button', { type: 'button', class: 'soft' }, 'Try now');
  private readonly goOn = element('button', {
    type: 'button', class: 'solid', 'aria-disabled': 'true', 'data-tip': 'Go on without server: soon',
  }, 'Go on without server');
  readonly root = element('section', { class: 'banner panel', role: 'alert' },
    icon('lost', 24), element('div', { class: 'banner-words' }, this.title, this.text),
    element('div', { class: 'banner-buttons' }, this.retry, this.goOn));

  constructor(private readonly store: StudioStore, actions: StudioActions) {
    this.retry.addEventListener('click', () => actions.retry());
    store.watch(['link', 'recorded'], (state) => this.show(state));
    window.setInterval(() => this.show(store.state), 500);
  }

  private show(state: StudioState): void {
    const { link } = state;
    // While an attempt runs after a loss the banner stays, or it would blink.
    if (link.phase === 'connecting' && state.loaded) {
      setText(this.text, lostText(this.store.state.recorded, 0));
      return;
    }
    this.root.hidden = link.phase !== 'lost';
    if (link.phase !== 'lost') return;
    setText(this.title, state.loaded ? 'Connection lost' : 'No server');
    const seconds = Math.max(0, Math.ceil((link.retryAt - Date.now()) / 1000));
    setText(this.text, state.loaded ? lostText(state.recorded, seconds) : `The studio’s server does not answer. Trying again in ${seconds} s.`);
  }
}

const LEVELS: Record<NoticeLevel, { readonly name: string; readonly icon: IconName }> = {
  [NoticeLevel.Info]: { name: 'info', icon: 'info' },
  [NoticeLevel.Warning]: { name: 'warning', icon: 'warning' },
  [NoticeLevel.Error]: { name: 'error', icon: 'error' },
};

/** What is no error goes by itself [ms]. */
const NOTICE_MS = 6000;

export class NoticeBanner {
  private readonly text = element('strong');
  private readonly detail = element('span', { class: 'secondary' });
  private readonly show = element('button', { type: 'button', class: 'soft notice-show', 'data-tip': 'Brings the spot into view' }, 'Show');
  private readonly close = element('button', { type: 'button', class: 'notice-close', 'aria-label': 'Close the message' }, icon('close'));
  readonly root = element('section', { class: 'banner notice panel' },
    icon('warning', 24), element('div', { class: 'banner-words' }, this.text, this.detail), this.show, this.close);
  private timer = 0;

  constructor(store: StudioStore, private readonly actions: StudioActions) {
    this.show.addEventListener('click', () => actions.showNoticePlace());
    this.close.addEventListener('click', () => actions.dismissNotice());
    store.watch(['notice'], ({ notice }) => {
      this.root.hidden = notice === null;
      window.clearTimeout(this.timer);
      if (notice) this.fill(notice);
    });
  }

  private fill(notice: Notice): void {
    const level = LEVELS[notice.level];
    const isError = notice.level === NoticeLevel.Error;
    this.root.setAttribute('role', isError ? 'alert' : 'status');
    this.root.dataset['level'] = level.name;
    this.root.replaceChild(icon(level.icon, 24), this.root.firstElementChild!);
    setText(this.text, notice.text);
    setText(this.detail, noticeDetail(notice));
    this.show.hidden = !notice.hasPlace;
    if (!isError) this.timer = window.setTimeout(() => this.actions.dismissNotice(), NOTICE_MS);
  }
}
