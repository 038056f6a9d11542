// The shelf: all takes that the server keeps, the newest first.

import { render, type VNode } from 'preact';
import { showPicture } from '../../link/answers';
import type { TakeActions } from '../../model/take_actions';
import { formatAge, formatBytes, formatLengthOf, takeTitle, type ShelvedTake } from '../../model/take_facts';
import { Button, Icon, toolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { Held } from '../widgets/held';
import { UndoRow } from '../widgets/undo_row';

/** What is said below a take's name. */
function factsOf(take: ShelvedTake, now: number): string {
  const facts = [formatLengthOf(take.seconds), formatAge(take.changed, now), formatBytes(take.bytes)];
  if (take.recording) return ['recording', ...facts].join(' · ');
  if ('copyOnly' in take) return ['in this browser only', ...facts].join(' · ');
  return (take.finished ? facts : ['cut off', ...facts]).join(' · ');
}

function NoPicture(): VNode {
  return (
    <span class="shelf-no-picture">
      <Icon name="takes" size={24} />
    </span>
  );
}

export class TakeShelf {
  readonly root = element('section', {
    class: 'take-shelf panel',
    role: 'dialog',
    'aria-label': 'Takes',
    popover: 'manual',
    hidden: true,
  });
  private takes_: readonly ShelvedTake[] = [];
  private open_ = '';
  /** What can be brought back. */
  private removed_: ShelvedTake | null = null;

  /** `picture` gives a take's address of its picture; `openFile` lets the visitor choose one. */
  constructor(
    private readonly actions_: TakeActions,
    private readonly picture_: (take: ShelvedTake) => string,
    private readonly openFile_: () => void,
    private readonly now_: () => number = () => Date.now() / 1000,
  ) {
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      actions_.closeShelf();
    });
    this.draw();
  }

  setOpen(open: boolean): void {
    if (open !== this.root.hidden) return;
    this.root.hidden = !open;
    if (!open) this.removed_ = null;
    this.draw();
    // In the top layer, above all panels.
    if (open) this.root.showPopover?.();
    else this.root.hidePopover?.();
    if (open) this.root.querySelector<HTMLElement>('.shelf-item-open, .shelf-close')?.focus();
  }

  setTakes(takes: readonly ShelvedTake[], openName: string): void {
    [this.takes_, this.open_] = [takes, openName];
    this.draw();
  }

  /** After a take was removed. */
  offerUndo(take: ShelvedTake): void {
    this.removed_ = take;
    this.draw();
  }

  private draw(): void {
    const { actions_: actions, takes_: takes } = this;
    render(
      <>
        <div class="shelf-head">
          <h2>Takes</h2>
          <Button icon="open" act={this.openFile_}>
            Open a file…
          </Button>
          {toolButton('close', 'Close the shelf', () => actions.closeShelf(), { iconOnly: true, class: 'shelf-close' })}
        </div>
        {this.undo()}
        <ul class="shelf-list">{takes.map((take) => this.item(take))}</ul>
        <p class="shelf-empty secondary" hidden={takes.length > 0}>
          No take yet. Record one: it is kept here, whatever happens to the page.
        </p>
      </>,
      this.root,
    );
  }

  private undo(): VNode | null {
    const take = this.removed_;
    if (!take) return null;
    const back = (): void => {
      this.root.querySelector<HTMLElement>('.shelf-close')?.focus();
      this.removed_ = null;
      this.draw();
      this.actions_.restoreTake(take);
    };
    return <UndoRow key={take.name} title={takeTitle(take)} back={back} />;
  }

  private item(take: ShelvedTake): VNode {
    const { actions_: actions } = this;
    const title = takeTitle(take);
    return (
      <li key={take.name} class="shelf-item">
        <button
          type="button"
          class="shelf-item-open"
          aria-current={take.name === this.open_ ? 'true' : undefined}
          aria-label={`Play ${title}, ${formatLengthOf(take.seconds)}`}
          disabled={take.recording}
          onClick={() => actions.openTake(take.name)}
        >
          {take.picture ? <Held key={this.picture_(take)} make={() => this.image(take)} /> : <NoPicture />}
          <span class="shelf-words">
            <strong>{title}</strong>
            <span class="secondary">{factsOf(take, this.now_())}</span>
            {take.title && take.title !== take.scenario && (
              <span class="secondary shelf-scenario">{take.scenario}</span>
            )}
          </span>
        </button>
        <span class="shelf-tools">
          {!('copyOnly' in take) && (
            <>
              {toolButton('export', `Export ${title}`, () => actions.exportTake(take.name), {
                iconOnly: true,
                disabled: take.recording,
              })}
              {toolButton('download', `Save ${title} as a file`, () => actions.saveTake(take), {
                iconOnly: true,
                disabled: take.recording,
              })}
            </>
          )}
          {toolButton('close', `Remove ${title}`, () => actions.removeTake(take), {
            iconOnly: true,
            disabled: take.recording,
          })}
        </span>
      </li>
    );
  }

  private image(take: ShelvedTake): HTMLImageElement {
    const image = element('img', { alt: '', loading: 'lazy', width: 128, height: 72 });
    showPicture(image, this.picture_(take));
    return image;
  }
}
