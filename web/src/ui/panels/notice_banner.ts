// A message to the visitor: the server's, or one of the page's own.

import { NoticeLevel, type Notice } from '../../protocol/messages';
import { element, setText } from '../widgets/dom';
import { icon, type IconName } from '../widgets/icons';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';

/** What stands under the sentence: the code, and where it happened. */
export function noticeDetail({ code, hasPlace, x, y }: Notice): string {
  const metres = (value: number): string => value.toFixed(1).replace('-', '\u2212');
  if (code === 'undo') return ''; // The sentence says it all.
  return hasPlace ? `${code} \u00b7 at ${metres(x)}, ${metres(y)} m` : code;
}

const kLevels: Record<NoticeLevel, { readonly name: string; readonly icon: IconName }> = {
  [NoticeLevel.Info]: { name: 'info', icon: 'info' },
  [NoticeLevel.Warning]: { name: 'warning', icon: 'warning' },
  [NoticeLevel.Error]: { name: 'error', icon: 'error' },
};

/** Messages other than errors vanish after this time [ms]. */
const kNoticeMs = 6000;

export class NoticeBanner {
  private readonly text_ = element('strong');
  private readonly detail_ = element('span', { class: 'secondary' });
  private readonly show_ = element(
    'button',
    { type: 'button', class: 'soft notice-show', 'data-tip': 'Brings the spot into view' },
    'Show',
  );
  private readonly close_ = element(
    'button',
    { type: 'button', class: 'notice-close', 'aria-label': 'Close the message' },
    icon('close'),
  );
  readonly root = element(
    'section',
    { class: 'banner notice panel' },
    icon('warning', 24),
    element('div', { class: 'banner-words' }, this.text_, this.detail_),
    this.show_,
    this.close_,
  );
  private timer_ = 0;

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    this.show_.addEventListener('click', () => actions_.showNoticePlace());
    this.close_.addEventListener('click', () => actions_.dismissNotice());
    store.watch(['notice'], ({ notice }) => {
      this.root.hidden = notice === null;
      window.clearTimeout(this.timer_);
      if (notice) this.fill(notice);
    });
  }

  private fill(notice: Notice): void {
    const level = kLevels[notice.level];
    const isError = notice.level === NoticeLevel.Error;
    this.root.setAttribute('role', isError ? 'alert' : 'status');
    this.root.dataset['level'] = level.name;
    this.root.replaceChild(icon(level.icon, 24), this.root.firstElementChild!);
    setText(this.text_, notice.text);
    setText(this.detail_, noticeDetail(notice));
    this.detail_.hidden = noticeDetail(notice) === '';
    this.show_.hidden = !notice.hasPlace;
    if (!isError) this.timer_ = window.setTimeout(() => this.actions_.dismissNotice(), kNoticeMs);
  }
}
