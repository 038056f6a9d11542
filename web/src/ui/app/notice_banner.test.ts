// @vitest-environment jsdom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { NoticeLevel, type Notice } from '../../protocol/messages';
import { NoticeBanner } from './notice_banner';
import type { StudioActions } from '../../model/studio_actions';
import { StudioStore } from '../../model/studio_store';

describe('NoticeBanner', () => {
  let store: StudioStore;
  let root: HTMLElement;
  const actions = { showNoticePlace: vi.fn(), dismissNotice: vi.fn() };

  beforeEach(() => {
    vi.useFakeTimers();
    vi.clearAllTimers();
    vi.clearAllMocks();
    store = new StudioStore();
    root = new NoticeBanner(store, actions as unknown as StudioActions).root;
  });

  function tell(level: NoticeLevel, more: Partial<Notice> = {}): void {
    store.set({
      notice: { type: 'Notice', level, code: 'rejected', text: 'No.', hasPlace: false, x: 0, y: 0, ...more },
    });
  }
  const show = () => root.querySelector<HTMLButtonElement>('.notice-show')!;

  it('says what and where, and shows the spot', () => {
    tell(NoticeLevel.Warning, { hasPlace: true, x: 3.44, y: -2 });
    expect(root.hidden).toBe(false);
    expect(root.querySelector('strong')!.textContent).toBe('No.');
    expect(root.querySelector('.banner-words')!.textContent).toBe('No.'); // No code, no coordinates.
    expect(root.dataset['code']).toBe('rejected');
    expect(show().hidden).toBe(false);
    show().click();
    expect(actions.showNoticePlace).toHaveBeenCalledTimes(1);
  });

  it('has nothing to show where the place is not known', () => {
    tell(NoticeLevel.Error);
    expect(show().hidden).toBe(true);
  });

  it('tells info, warning and error apart, and keeps errors until they are closed', () => {
    const pictures = new Set<string>();
    for (const [level, name, role] of [
      [0, 'info', 'status'],
      [1, 'warning', 'status'],
      [2, 'error', 'alert'],
    ] as const) {
      tell(level);
      expect([root.dataset['level'], root.getAttribute('role')]).toEqual([name, role]);
      pictures.add(root.firstElementChild!.innerHTML);
    }
    expect(pictures.size).toBe(3);
    vi.advanceTimersByTime(60000);
    expect(actions.dismissNotice).not.toHaveBeenCalled();
    tell(NoticeLevel.Warning);
    vi.advanceTimersByTime(6001);
    expect(actions.dismissNotice).toHaveBeenCalledTimes(1);
  });
});
