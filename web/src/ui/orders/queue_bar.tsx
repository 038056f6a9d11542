// The active group's queue: a chip per order, with its number, what it is, and when it is done. A chip that is chosen
// offers what can be done with its order; chips are dragged into another order.

import type { VNode } from 'preact';
import type { OrderActions } from '../../model/order_actions';
import type { QueueItem, StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { toolButton, type ToolButtonProps } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { accentVariable } from '../widgets/group_marks';
import type { IconName } from '../widgets/icons';
import { drawPanel } from '../widgets/panel';
import { RowDrag } from '../widgets/row_drag';
import { ToolbarFocus } from '../widgets/toolbar_focus';

function act(icon: IconName, label: string, run: () => void, more: Partial<ToolButtonProps> = {}): VNode {
  return toolButton(icon, label, run, { ...more, class: 'queue-act', iconSize: 18 });
}

function nameOf({ word, span, arrives }: QueueItem, index: number): string {
  const when = arrives ? (span ? `, done in ${span}` : '') : ', cannot be reached';
  return `Order ${index + 1}, ${word}${when}`;
}

export class QueueBar {
  readonly root = element('section', { class: 'queue panel', 'aria-label': 'Queue of orders' });
  private readonly bar_ = element('div', { class: 'queue-bar', role: 'toolbar', 'aria-label': 'Queue' });
  private readonly focus_: ToolbarFocus;
  private drag_: RowDrag | null = null;
  private readonly watched_ = new WeakSet<HTMLElement>();
  private items_: readonly QueueItem[] = [];
  private key_ = '';

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: OrderActions,
  ) {
    this.root.append(this.bar_);
    const fields = ['queue', 'picked', 'insertBefore', 'groups', 'active', 'loaded', 'style'] as const;
    drawPanel(this.bar_, store_, fields, (state) => {
      this.observe(state);
      return (
        <>
          {this.acts(state)}
          <div class="queue-row">
            <div class="queue-chips" ref={this.holdChips}>
              {state.queue.map((item, k) => this.chip(item, k, state))}
            </div>
            {this.tools(state)}
          </div>
        </>
      );
    });
    this.focus_ = new ToolbarFocus(this.bar_, store_);
    store_.watch(['queue', 'picked'], () => this.focus_.refresh());
  }

  private readonly holdChips = (chips: HTMLElement | null): void => {
    if (chips) this.drag_ ??= new RowDrag(chips, (from, to) => this.dropped(from, to));
  };

  private observe(state: StudioState): void {
    this.root.hidden = !state.loaded || state.queue.length === 0;
    this.root.style.setProperty('--accent', accentVariable(state.groups[state.active]?.colour ?? 0));
    this.items_ = state.queue;
    const key = state.queue.map(({ id, kind }) => `${id} ${kind}`).join();
    // What is dragged may have gone.
    if (key !== this.key_) this.drag_?.cancel();
    this.key_ = key;
  }

  private move(by: number): void {
    const { queue, picked } = this.store_.state;
    const index = queue.findIndex(({ id }) => id === picked);
    if (index >= 0) this.actions_.moveOrder(picked, index + by);
  }

  private dropped(from: number, to: number): void {
    const item = this.items_[from];
    if (item) this.actions_.moveOrder(item.id, to);
  }

  /** Of the chosen order. */
  private acts({ queue, picked, insertBefore }: StudioState): VNode {
    const { actions_: actions } = this;
    const index = queue.findIndex(({ id }) => id === picked);
    const inserting = insertBefore !== 0 && insertBefore === picked;
    return (
      <div class="queue-acts" hidden={index < 0}>
        <span class="queue-title">{inserting ? `Draw it, before ${index + 1}` : `Order ${index + 1}`}</span>
        {act('plus', 'Insert', () => actions.insertBefore(picked), {
          tip: 'The next order that is drawn comes before this one',
          pressed: inserting,
        })}
        {act('earlier', 'Earlier', () => this.move(-1), { tip: 'Comes before the one before it', idle: index <= 0 })}
        {act('later', 'Later', () => this.move(1), {
          tip: 'Comes after the one after it',
          idle: index + 1 >= queue.length,
        })}
        {act('close', 'Cancel', () => actions.cancelOrder(picked), { tip: 'Takes this order out of the queue' })}
      </div>
    );
  }

  private tools({ style }: StudioState): VNode {
    const { actions_: actions } = this;
    const appends = style.mode === 'append';
    return (
      <>
        {act('plus', 'Add', () => actions.setStyle({ mode: appends ? 'replace' : 'append' }), {
          tip: 'New orders come last, as with Shift',
          pressed: appends,
        })}
        {act('places', 'On the way', () => this.store_.set({ sequencing: true }), {
          tip: 'Formations that the group changes to on the way',
        })}
        {act('step', 'Skip', () => actions.skipOrder(), { shortcut: 'Y', tip: 'Goes on to the next order' })}
      </>
    );
  }

  private chip(item: QueueItem, index: number, { picked, insertBefore }: StudioState): VNode {
    const marks = `${item.arrives ? '' : ' cannot'}${item.id === insertBefore ? ' inserting' : ''}`;
    const pressed = (): void => {
      if (!this.drag_?.consumeClick()) this.actions_.pickOrder(item.id);
    };
    return (
      <button
        key={`${item.id} ${item.kind}`}
        type="button"
        class={`queue-chip${marks}`}
        aria-label={nameOf(item, index)}
        aria-pressed={item.id === picked}
        data-tip="What to do with this order; drag it to another place"
        ref={this.watchChip}
        onClick={pressed}
      >
        <span class="order-number">{index + 1}</span>
        <span class="queue-word">{item.word}</span>
        <span class="queue-span secondary">{item.arrives ? item.span : 'no way'}</span>
      </button>
    );
  }

  private readonly watchChip = (chip: HTMLElement | null): void => {
    if (!chip || this.watched_.has(chip)) return;
    this.watched_.add(chip);
    // Its list may be made after it.
    queueMicrotask(() => this.drag_?.watch(chip));
  };
}
