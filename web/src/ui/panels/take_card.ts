// The card of a take that has just been kept: picture, name, length, and what can be done with it.

import { showPicture } from '../../link/answers';
import { canShareLinks, copyLink } from '../../link/shared_link';
import type { TakeActions } from '../../model/take_actions';
import { formatLengthOf, takeTitle, type ShelvedTake } from '../../model/take_facts';
import { element, setText } from '../widgets/dom';
import { icon, type IconName } from '../widgets/icons';
import { toolButton } from '../widgets/tool_button';

/** What the card is about. */
export type CardKind = 'kept' | 'cut off' | 'removed';

const kHeadings: Readonly<Record<CardKind, string>> = {
  kept: 'Take kept',
  'cut off': 'This recording was cut off, and is safe',
  removed: 'Take removed',
};

export class TakeCard {
  private readonly heading_ = element('h2', { class: 'card-heading' });
  private readonly picture_ = element('img', { class: 'card-picture', alt: '', width: 320, height: 180 });
  private readonly name_ = element('input', {
    type: 'text',
    class: 'card-name',
    maxlength: 80,
    'aria-label': 'Name of the take',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  private readonly about_ = element('p', { class: 'card-about secondary' });
  private readonly tools_ = element('div', { class: 'card-tools' });
  private readonly undo_ = element(
    'button',
    { type: 'button', class: 'solid card-undo' },
    icon('undo'),
    'Bring it back',
  );
  readonly root = element('section', {
    class: 'take-card panel',
    role: 'dialog',
    'aria-label': 'Take kept',
    hidden: true,
  });
  private readonly share_ = this.tool('link', 'Copy link', (take) => void this.copyLink(take), 'soft card-share');
  private readonly said_ = element('p', { class: 'card-said secondary', role: 'status', hidden: true });
  private take_: ShelvedTake | null = null;
  private kind_: CardKind = 'kept';

  constructor(private readonly actions_: TakeActions) {
    const close = toolButton({
      icon: 'close',
      label: 'Close the card',
      iconOnly: true,
      className: 'card-close',
      act: () => actions_.closeCard(),
    });
    this.tools_.append(
      this.tool('play', 'Play', (take) => actions_.openTake(take.name), 'solid card-play'),
      this.tool('cut', 'Trim', (take) => actions_.openTake(take.name, true), 'soft card-trim'),
      this.tool('takes', 'Export', (take) => actions_.exportTake(take.name), 'soft card-export'),
      this.tool('download', 'Save file', (take) => actions_.saveTake(take), 'soft card-save'),
      this.share_,
      this.tool('close', 'Remove', (take) => actions_.removeTake(take), 'soft card-remove'),
    );
    this.undo_.addEventListener('click', () => this.take_ && actions_.restoreTake(this.take_));
    this.name_.addEventListener('change', () => this.rename());
    this.name_.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter') this.name_.blur();
    });
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      actions_.closeCard();
    });
    this.root.append(
      element('div', { class: 'card-head' }, this.heading_, close),
      this.picture_,
      this.name_,
      this.about_,
      this.tools_,
      this.said_,
      this.undo_,
    );
  }

  /** The take that the card is about; null while it is closed. */
  get take(): ShelvedTake | null {
    return this.root.hidden ? null : this.take_;
  }

  /** `picture` is an address of its own, empty for none. */
  show(take: ShelvedTake, kind: CardKind, picture: string): void {
    this.take_ = take;
    this.kind_ = kind;
    const removed = kind === 'removed';
    setText(this.heading_, kHeadings[kind]);
    this.root.setAttribute('aria-label', kHeadings[kind]);
    if (document.activeElement !== this.name_) this.name_.value = takeTitle(take);
    setText(this.about_, `${formatLengthOf(take.seconds)} · ${take.characters} people · ${take.scenario}`);
    this.picture_.hidden = picture === '';
    if (picture !== '') showPicture(this.picture_, picture);
    this.name_.disabled = removed;
    this.share_.hidden = !canShareLinks();
    this.said_.hidden = true;
    this.tools_.hidden = removed;
    this.undo_.hidden = !removed;
    this.root.hidden = false;
  }

  close(): void {
    this.root.hidden = true;
  }

  private async copyLink(take: ShelvedTake): Promise<void> {
    const said = await copyLink('take', `takes/${take.name}`);
    if (this.take_ !== take) return;
    setText(this.said_, said);
    this.said_.hidden = false;
  }

  private rename(): void {
    const title = this.name_.value.trim();
    if (this.take_ && this.kind_ !== 'removed' && title !== takeTitle(this.take_))
      this.actions_.renameTake(this.take_, title);
  }

  private tool(name: IconName, label: string, act: (take: ShelvedTake) => void, className: string): HTMLButtonElement {
    const button = element('button', { type: 'button', class: className }, icon(name), label);
    button.addEventListener('click', () => {
      this.rename();
      if (this.take_) act(this.take_);
    });
    return button;
  }
}
