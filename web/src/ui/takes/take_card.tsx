// The card of a take that has just been kept: picture, name, length, and what can be done with it.

import { render, type VNode } from 'preact';
import { hasEngine, showPicture } from '../../link/answers';
import { canShareLinks, copyLink } from '../../link/shared_link';
import type { TakeActions } from '../../model/take_actions';
import { formatLengthOf, takeTitle, type ShelvedTake } from '../../model/take_facts';
import { Button, Icon, toolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import type { IconName } from '../widgets/icons';

/** What the card is about. */
export type CardKind = 'kept' | 'cut off' | 'removed';

const kHeadings: Readonly<Record<CardKind, string>> = {
  kept: 'Take kept',
  'cut off': 'This recording was cut off, and is safe',
  removed: 'Take removed',
};

interface Act {
  readonly icon: IconName;
  readonly label: string;
  readonly class: string;
  readonly act: (take: ShelvedTake) => void;
}

export class TakeCard {
  readonly root = element('section', {
    class: 'take-card panel',
    role: 'dialog',
    'aria-label': 'Take kept',
    hidden: true,
  });
  private name_: HTMLInputElement | null = null;
  private image_: HTMLImageElement | null = null;
  private take_: ShelvedTake | null = null;
  private kind_: CardKind = 'kept';
  private picture_ = '';
  /** What became of a link. */
  private said_ = '';
  private readonly acts_: readonly Act[];

  constructor(private readonly actions_: TakeActions) {
    const share: Act[] =
      hasEngine() && !canShareLinks()
        ? []
        : [{ icon: 'link', label: 'Share', class: 'soft card-share', act: (take) => void this.share(take) }];
    this.acts_ = [
      { icon: 'play', label: 'Play', class: 'solid card-play', act: ({ name }) => actions_.openTake(name) },
      { icon: 'cut', label: 'Trim', class: 'soft card-trim', act: ({ name }) => actions_.openTake(name, true) },
      { icon: 'takes', label: 'Export', class: 'soft card-export', act: ({ name }) => actions_.exportTake(name) },
      { icon: 'download', label: 'Save file', class: 'soft card-save', act: (take) => actions_.saveTake(take) },
      ...share,
      { icon: 'close', label: 'Remove', class: 'soft card-remove', act: (take) => actions_.removeTake(take) },
    ];
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      actions_.closeCard();
    });
  }

  /** The take that the card is about; null while it is closed. */
  get take(): ShelvedTake | null {
    return this.root.hidden ? null : this.take_;
  }

  /** `picture` is an address of its own, empty for none. */
  show(take: ShelvedTake, kind: CardKind, picture: string): void {
    [this.take_, this.kind_, this.picture_, this.said_] = [take, kind, picture, ''];
    this.root.setAttribute('aria-label', kHeadings[kind]);
    this.root.hidden = false;
    this.draw();
    if (document.activeElement !== this.name_) this.name_!.value = takeTitle(take);
    if (picture !== '') showPicture(this.image_!, picture);
  }

  close(): void {
    this.root.hidden = true;
  }

  private draw(): void {
    const take = this.take_!;
    const removed = this.kind_ === 'removed';
    render(
      <>
        <div class="card-head">
          <h2 class="card-heading">{kHeadings[this.kind_]}</h2>
          {toolButton('close', 'Close the card', () => this.actions_.closeCard(), {
            iconOnly: true,
            class: 'card-close',
          })}
        </div>
        <img
          class="card-picture"
          alt=""
          width={320}
          height={180}
          hidden={this.picture_ === ''}
          ref={(made) => void (this.image_ = made)}
        />
        {this.nameField(removed)}
        <p class="card-about secondary">
          {`${formatLengthOf(take.seconds)} · ${take.characters} people · ${take.scenario}`}
        </p>
        <div class="card-tools" hidden={removed}>
          {this.acts_.map((one) => this.button(one))}
        </div>
        <p class="card-said secondary" role="status" hidden={this.said_ === ''}>
          {this.said_}
        </p>
        <Button
          icon="undo"
          class="solid card-undo"
          hidden={!removed}
          act={() => this.take_ && this.actions_.restoreTake(this.take_)}
        >
          Bring it back
        </Button>
      </>,
      this.root,
    );
  }

  private nameField(disabled: boolean): VNode {
    return (
      <input
        type="text"
        class="card-name"
        maxLength={80}
        aria-label="Name of the take"
        autocomplete="off"
        spellcheck={false}
        disabled={disabled}
        ref={(made) => void (this.name_ = made)}
        onChange={() => this.rename()}
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === 'Enter') event.currentTarget.blur();
          if (event.key === 'Escape') this.actions_.closeCard();
        }}
      />
    );
  }

  private button({ icon, label, class: name, act }: Act): VNode {
    const pressed = (): void => {
      this.rename();
      if (this.take_) act(this.take_);
    };
    return (
      <button key={label} type="button" class={name} onClick={pressed}>
        <Icon name={icon} />
        {label}
      </button>
    );
  }

  private async share(take: ShelvedTake): Promise<void> {
    const [title, path] = [takeTitle(take), `takes/${take.name}`];
    let said = '';
    if (hasEngine()) said = await copyLink('take', path);
    else {
      const { showShare } = await import('../places/share_dialog');
      await showShare({ kind: 'take', title, fragment: `shelved=${take.name}`, path }).catch(
        () => (said = 'The server does not answer: try again.'),
      );
    }
    if (this.take_ !== take) return;
    this.said_ = said;
    this.draw();
  }

  private rename(): void {
    const title = this.name_?.value.trim() ?? '';
    if (this.take_ && this.kind_ !== 'removed' && title !== takeTitle(this.take_))
      this.actions_.renameTake(this.take_, title);
  }
}
