// The groups: colour, mark, name and count; the pressed one is what formations act on.

import { ChipDrag } from '../widgets/chip_drag';
import type { OrderActions } from '../../model/order_actions';
import { element, setAttribute, setPressed, setText } from '../widgets/dom';
import { formatCount } from '../../model/formatters';
import { accentVariable, groupMark } from '../widgets/group_marks';
import type { StudioActions } from '../../model/studio_actions';
import type { GroupInfo, StudioState } from '../../model/studio_state';
import { toolButton } from '../widgets/tool_button';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import type { StudioStore } from '../../model/studio_store';

/** With more groups than this only the active one's chip has its name. */
const kNamed = 4;
/** Two presses within this time are a double press [ms]. */
const kTwice = 500;
/** So much of the chip beside it is in sight, too [CSS px]. */
const kBeside = 24;

export class GroupChips {
  readonly root = element('div', { class: 'groups panel', role: 'toolbar', 'aria-label': 'Groups' });
  private readonly add_ = toolButton({
    icon: 'plus',
    label: 'Add a group',
    iconOnly: true,
    className: 'add-group',
    act: () => this.actions_.openDialog('group'),
  });
  private readonly focus_: ToolbarFocus;
  private last_ = { index: -1, time: -kTwice };
  private shownKey_ = '';
  private active_ = 0;
  private groups_: readonly number[] = [];
  private readonly drag_ = new ChipDrag(
    (chip) => this.groups_[[...this.root.children].indexOf(chip)],
    (into, dragged) => this.orders_.merge(into, dragged),
  );

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
    private readonly orders_: OrderActions,
  ) {
    this.focus_ = new ToolbarFocus(this.root, store);
    store.watch(['groups', 'active', 'selected'], (state) => this.show(state));
  }

  private show(state: StudioState): void {
    const key = state.groups.map((group) => `${group.id} ${group.name} ${group.colour}`).join('|');
    if (key !== this.shownKey_) {
      this.shownKey_ = key;
      this.root.replaceChildren(...state.groups.map((group, i) => this.chip(group, i)), this.add_);
      this.groups_ = state.groups.map(({ id }) => id);
      this.focus_.refresh();
    }
    this.root.hidden = state.groups.length === 0;
    this.root.classList.toggle('many', state.groups.length > kNamed);
    state.groups.forEach((group, i) => this.update(this.root.children[i]!, group, state));
    if (state.active !== this.active_) this.reveal(state.active);
  }

  /** Where chips are scrolled, the active group's is in sight. */
  private reveal(active: number): void {
    this.active_ = active;
    const chip = this.root.children[active] as HTMLElement | undefined;
    if (!chip) return;
    const [left, right] = [chip.offsetLeft, chip.offsetLeft + chip.offsetWidth];
    if (left < this.root.scrollLeft) this.root.scrollLeft = left - kBeside;
    else if (right > this.root.scrollLeft + this.root.clientWidth)
      this.root.scrollLeft = right - this.root.clientWidth + kBeside;
  }

  private chip(group: GroupInfo, index: number): HTMLButtonElement {
    const chip = element(
      'button',
      {
        type: 'button',
        class: 'chip',
        'data-tip': `Choose ${group.name}; twice: bring it into view; drag it onto another to join them`,
        'data-key': 'G',
      },
      groupMark(group.colour),
      element('span', { class: 'chip-name' }, group.name),
      element('span', { class: 'chip-count secondary' }),
    );
    chip.style.setProperty('--accent', accentVariable(group.colour));
    chip.addEventListener('click', (event) => {
      if (this.drag_.consumeClick()) return;
      if (event.shiftKey || event.ctrlKey || event.metaKey) this.orders_.choose(index, true);
      else this.pressed(index, event.timeStamp);
    });
    this.drag_.watch(chip, group.id);
    return chip;
  }

  /** The second press in a short time brings the group into view. */
  private pressed(index: number, time: number): void {
    const twice = this.last_.index === index && time - this.last_.time < kTwice;
    this.last_ = { index, time: twice ? -kTwice : time };
    if (twice) this.actions_.frameGroup(index);
    else this.actions_.setActiveGroup(index);
  }

  private update(chip: Element, group: GroupInfo, state: StudioState): void {
    setPressed(chip, state.groups[state.active]?.id === group.id);
    chip.classList.toggle('chosen', state.selected.length > 1 && state.selected.includes(group.id));
    chip.classList.toggle('empty', group.count === 0);
    setText(chip.lastElementChild!, formatCount(group.count));
    setAttribute(chip, 'aria-label', `${group.name}, ${group.count} characters`);
  }
}
