// A message to the visitor: the server's, or one of the page's own.

import { NoticeLevel, type Notice } from '../../protocol/messages';
import type { StudioActions } from '../../model/studio_actions';
import type { StudioStore } from '../../model/studio_store';
import { Banner } from '../widgets/banner';
import { Button, Icon } from '../widgets/buttons';
import { element } from '../widgets/dom';
import type { IconName } from '../widgets/icons';
import { drawPanel } from '../widgets/panel';

const kLevels: Record<NoticeLevel, { readonly name: string; readonly icon: IconName }> = {
  [NoticeLevel.Info]: { name: 'info', icon: 'info' },
  [NoticeLevel.Warning]: { name: 'warning', icon: 'warning' },
  [NoticeLevel.Error]: { name: 'error', icon: 'error' },
};

/** Messages other than errors vanish after this time [ms]. */
const kNoticeMs = 6000;

export class NoticeBanner {
  readonly root = element('section', { class: 'banner notice panel' });
  private timer_ = 0;

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
  ) {
    store.watch(['notice'], ({ notice }) => {
      this.root.hidden = notice === null;
      window.clearTimeout(this.timer_);
      if (notice) this.tell(notice);
    });
    drawPanel(this.root, store, ['notice'], ({ notice }) => {
      if (!notice) return null;
      return (
        <Banner icon={kLevels[notice.level].icon} title={notice.text}>
          <Button
            class="soft notice-show"
            data-tip="Brings the spot into view"
            hidden={!notice.hasPlace}
            act={() => actions_.showNoticePlace()}
          >
            Show
          </Button>
          <button
            type="button"
            class="notice-close"
            aria-label="Close the message"
            onClick={() => actions_.dismissNotice()}
          >
            <Icon name="close" />
          </button>
        </Banner>
      );
    });
  }

  private tell({ level, code }: Notice): void {
    const isError = level === NoticeLevel.Error;
    this.root.setAttribute('role', isError ? 'alert' : 'status');
    this.root.dataset['level'] = kLevels[level].name;
    this.root.dataset['code'] = code;
    if (!isError) this.timer_ = window.setTimeout(() => this.actions_.dismissNotice(), kNoticeMs);
  }
}
