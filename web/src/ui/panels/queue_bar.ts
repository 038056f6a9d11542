// The active group's queue: a chip per order, with its number, what it is, and when it is done. A chip that is chosen
// offers what can be done with its order; chips are dragged into another order.

import type { OrderActions } from '../../model/order_actions';
import type { QueueItem, StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { element, setAttribute, setPressed, setText } from '../widgets/dom';
import { accentVariable } from '../widgets/group_marks';
import { icon, type IconName } from '../widgets/icons';
import { RowDrag } from '../widgets/row_drag';
import { ToolbarFocus } from '../widgets/toolbar_focus';

interface ActDef {
  readonly icon: IconName;
  readonly label: string;
  readonly tip: string;
  readonly key?: string;
}

function act(def: ActDef, run: () => void): HTMLButtonElement {
  const button = element(
    'button',
    {
      type: 'button',
      class: 'queue-act',
      'aria-label': def.label,
      'aria-keyshortcuts': def.key,
      'data-key': def.key,
      'data-tip': def.tip,
    },
    icon(def.icon, 18),
    element('span', { class: 'label' }, def.label),
  );
  button.addEventListener('click', run);
  return button;
}

export class QueueBar {
  private readonly chips_ = element('div', { class: 'queue-chips' });
  private readonly title_ = element('span', { class: 'queue-title' });
  private readonly insert_: HTMLButtonElement;
  private readonly earlier_: HTMLButtonElement;
  private readonly later_: HTMLButtonElement;
  private readonly add_: HTMLButtonElement;
  private readonly acts_: HTMLElement;
  readonly root: HTMLElement;
  private readonly focus_: ToolbarFocus;
  private readonly drag_: RowDrag;
  private items_: readonly QueueItem[] = [];
  private key_ = '';

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: OrderActions,
  ) {
    const insert = {
      icon: 'plus',
      label: 'Insert',
      tip: 'The next order that is drawn comes before this one',
    } as const;
    this.insert_ = act(insert, () => actions_.insertBefore(store_.state.picked));
    setPressed(this.insert_, false);
    const earlier = { icon: 'earlier', label: 'Earlier', tip: 'Comes before the one before it' } as const;
    this.earlier_ = act(earlier, () => this.move(-1));
    const later = { icon: 'later', label: 'Later', tip: 'Comes after the one after it' } as const;
    this.later_ = act(later, () => this.move(1));
    const cancel = { icon: 'close', label: 'Cancel', tip: 'Takes this order out of the queue' } as const;
    const drop = act(cancel, () => actions_.cancelOrder(store_.state.picked));
    const add = { icon: 'plus', label: 'Add', tip: 'New orders come last, as with Shift' } as const;
    this.add_ = act(add, () =>
      actions_.setStyle({ mode: store_.state.style.mode === 'append' ? 'replace' : 'append' }),
    );
    const skip = { icon: 'step', label: 'Skip', key: 'Y', tip: 'Goes on to the next order' } as const;
    const sequence = {
      icon: 'places',
      label: 'Formations',
      tip: 'Formations that are taken up along the way',
    } as const;
    const formations = act(sequence, () => store_.set({ sequencing: true }));
    this.acts_ = element('div', { class: 'queue-acts' }, this.title_, this.insert_, this.earlier_, this.later_, drop);
    const row = element(
      'div',
      { class: 'queue-row' },
      this.chips_,
      this.add_,
      formations,
      act(skip, () => actions_.skipOrder()),
    );
    const bar = element('div', { class: 'queue-bar', role: 'toolbar', 'aria-label': 'Queue' }, this.acts_, row);
    this.root = element('section', { class: 'queue panel', 'aria-label': 'Queue of orders' }, bar);
    this.drag_ = new RowDrag(this.chips_, (from, to) => this.dropped(from, to));
    this.focus_ = new ToolbarFocus(bar, store_);
    store_.watch(['style'], ({ style }) => setPressed(this.add_, style.mode === 'append'));
    store_.watch(['queue', 'picked', 'insertBefore', 'groups', 'active', 'loaded'], (state) => this.show(state));
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

  private show(state: StudioState): void {
    this.root.hidden = !state.loaded || state.queue.length === 0;
    this.root.style.setProperty('--accent', accentVariable(state.groups[state.active]?.colour ?? 0));
    const key = state.queue.map(({ id, kind }) => `${id} ${kind}`).join();
    this.items_ = state.queue;
    if (key !== this.key_) {
      this.key_ = key;
      this.drag_.cancel();
      const focused = this.chips_.contains(document.activeElement);
      this.chips_.replaceChildren(...state.queue.map((item, k) => this.chip(item, k)));
      if (focused) this.chips_.querySelector<HTMLElement>('button')?.focus();
      this.focus_.refresh();
    }
    state.queue.forEach((item, k) => this.update(this.chips_.children[k]!, item, k, state));
    this.showActs(state);
  }

  private showActs({ queue, picked, insertBefore }: StudioState): void {
    const index = queue.findIndex(({ id }) => id === picked);
    const hidden = index < 0;
    if (this.acts_.hidden !== hidden) {
      this.acts_.hidden = hidden;
      this.focus_.refresh();
    }
    const inserting = insertBefore !== 0 && insertBefore === picked;
    setText(this.title_, inserting ? `Draw it, before ${index + 1}` : `Order ${index + 1}`);
    setPressed(this.insert_, inserting);
    setAttribute(this.earlier_, 'aria-disabled', String(index <= 0));
    setAttribute(this.later_, 'aria-disabled', String(index + 1 >= queue.length));
  }

  private chip({ word }: QueueItem, index: number): HTMLButtonElement {
    const chip = element(
      'button',
      { type: 'button', class: 'queue-chip', 'data-tip': 'What to do with this order; drag it to another place' },
      element('span', { class: 'order-number' }, String(index + 1)),
      element('span', { class: 'queue-word' }, word),
      element('span', { class: 'queue-span secondary' }),
    );
    chip.addEventListener('click', () => {
      const item = this.items_[index];
      if (item && !this.drag_.consumeClick()) this.actions_.pickOrder(item.id);
    });
    this.drag_.watch(chip);
    return chip;
  }

  private update(chip: Element, item: QueueItem, index: number, state: StudioState): void {
    setPressed(chip, item.id === state.picked);
    chip.classList.toggle('cannot', !item.arrives);
    chip.classList.toggle('inserting', item.id === state.insertBefore);
    const text = item.arrives ? item.span : 'no way';
    setText(chip.lastElementChild!, text);
    const when = item.arrives ? (item.span ? `, done in ${item.span}` : '') : ', cannot be reached';
    setAttribute(chip, 'aria-label', `Order ${index + 1}, ${item.word}${when}`);
  }
}
