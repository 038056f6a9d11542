// The shelf: all takes that the server keeps, the newest first.

import { showPicture } from '../../link/answers';
import type { TakeActions } from '../../model/take_actions';
import { formatAge, formatBytes, formatLengthOf, takeTitle, type ShelvedTake } from '../../model/take_facts';
import { element, setText } from '../widgets/dom';
import { icon, type IconName } from '../widgets/icons';
import { toolButton } from '../widgets/tool_button';

export class TakeShelf {
  private readonly list_ = element('ul', { class: 'shelf-list' });
  private readonly empty_ = element(
    'p',
    { class: 'shelf-empty secondary' },
    'No take yet. Record one: it is kept here, whatever happens to the page.',
  );
  private readonly undo_ = element('div', { class: 'shelf-undo', hidden: true });
  readonly root = element('section', {
    class: 'take-shelf panel',
    role: 'dialog',
    'aria-label': 'Takes',
    popover: 'manual',
    hidden: true,
  });

  /** `picture` gives a take's address of its picture; `openFile` lets the visitor choose one. */
  constructor(
    private readonly actions_: TakeActions,
    private readonly picture_: (take: ShelvedTake) => string,
    openFile: () => void,
    private readonly now_: () => number = () => Date.now() / 1000,
  ) {
    const close = toolButton({
      icon: 'close',
      label: 'Close the shelf',
      iconOnly: true,
      className: 'shelf-close',
      act: () => actions_.closeShelf(),
    });
    const open = element('button', { type: 'button', class: 'soft' }, icon('open'), 'Open a file…');
    open.addEventListener('click', openFile);
    this.root.append(
      element('div', { class: 'shelf-head' }, element('h2', {}, 'Takes'), open, close),
      this.undo_,
      this.list_,
      this.empty_,
    );
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      actions_.closeShelf();
    });
  }

  setOpen(open: boolean): void {
    if (open !== this.root.hidden) return;
    this.root.hidden = !open;
    // In the top layer, above all panels.
    if (open) this.root.showPopover?.();
    else this.root.hidePopover?.();
    if (open) this.root.querySelector<HTMLElement>('.shelf-item-open, .shelf-close')?.focus();
    else this.undo_.hidden = true;
  }

  setTakes(takes: readonly ShelvedTake[], openName: string): void {
    this.empty_.hidden = takes.length > 0;
    const focused = (document.activeElement as HTMLElement | null)?.dataset['key'];
    this.list_.replaceChildren(...takes.map((take) => this.item(take, take.name === openName)));
    if (focused) this.list_.querySelector<HTMLElement>(`[data-key="${focused}"]`)?.focus();
  }

  /** After a take was removed. */
  offerUndo(take: ShelvedTake): void {
    const back = element('button', { type: 'button', class: 'soft' }, icon('undo'), 'Bring it back');
    back.addEventListener('click', () => {
      this.root.querySelector<HTMLElement>('.shelf-close')?.focus();
      this.undo_.hidden = true;
      this.actions_.restoreTake(take);
    });
    this.undo_.replaceChildren(element('span', {}, `“${takeTitle(take)}” is removed.`), back);
    this.undo_.hidden = false;
    back.focus();
  }

  private item(take: ShelvedTake, open: boolean): HTMLElement {
    const title = takeTitle(take);
    const picture = take.picture
      ? element('img', { alt: '', loading: 'lazy', width: 128, height: 72 })
      : element('span', { class: 'shelf-no-picture' }, icon('takes', 24));
    if (picture instanceof HTMLImageElement) showPicture(picture, this.picture_(take));
    const words = element('span', { class: 'shelf-words' }, element('strong', {}, title));
    const about = element('span', { class: 'secondary' });
    const notes = [formatLengthOf(take.seconds), formatAge(take.changed, this.now_()), formatBytes(take.bytes)];
    if (take.recording) notes.unshift('recording');
    else if ('copyOnly' in take) notes.unshift('in this browser only');
    else if (!take.finished) notes.unshift('cut off');
    setText(about, notes.join(' · '));
    words.append(about);
    if (take.title && take.title !== take.scenario)
      words.append(element('span', { class: 'secondary shelf-scenario' }, take.scenario));
    const main = element(
      'button',
      {
        type: 'button',
        class: 'shelf-item-open',
        'data-key': `open ${take.name}`,
        'aria-current': open ? 'true' : undefined,
        disabled: take.recording,
        'aria-label': `Play ${title}, ${formatLengthOf(take.seconds)}`,
      },
      picture,
      words,
    );
    main.addEventListener('click', () => this.actions_.openTake(take.name));
    const tools = element('span', { class: 'shelf-tools' });
    if (!('copyOnly' in take))
      tools.append(
        this.tool('takes', `Export ${title}`, take, () => this.actions_.exportTake(take.name)),
        this.tool('download', `Save ${title} as a file`, take, () => this.actions_.saveTake(take)),
      );
    tools.append(this.tool('close', `Remove ${title}`, take, () => this.actions_.removeTake(take)));
    return element('li', { class: 'shelf-item' }, main, tools);
  }

  private tool(name: IconName, label: string, take: ShelvedTake, act: () => void): HTMLButtonElement {
    const button = toolButton({ icon: name, label, iconOnly: true, act });
    button.dataset['key'] = `${name} ${take.name}`;
    button.disabled = take.recording;
    return button;
  }
}
