// The groups: colour, mark, name and count; the pressed one is what formations act on.

import type { VNode } from 'preact';
import { formatCount } from '../../model/formatters';
import type { OrderActions } from '../../model/order_actions';
import { standingSum } from '../../model/standing';
import type { StudioActions } from '../../model/studio_actions';
import type { GroupInfo, StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import { toolButton } from '../widgets/buttons';
import { ChipDrag } from '../widgets/chip_drag';
import { element } from '../widgets/dom';
import { GroupMark } from '../widgets/group_icons';
import { accentVariable } from '../widgets/group_marks';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';

/** With more groups than this only the active one's chip has its name. */
const kNamed = 4;
/** Two presses within this time are a double press [ms]. */
const kTwice = 500;
/** So much of the chip beside it is in sight, too [CSS px]. */
const kBeside = 24;

export class GroupChips {
  readonly root = element('div', { class: 'groups panel', role: 'toolbar', 'aria-label': 'Groups' });
  private readonly focus_: ToolbarFocus;
  private last_ = { index: -1, time: -kTwice };
  private groups_: readonly number[] = [];
  /** Whose chip was brought into sight, and among which. */
  private shown_ = '';
  private readonly watched_ = new WeakSet<HTMLElement>();
  private readonly drag_ = new ChipDrag(
    (chip) => this.groups_[[...this.root.children].indexOf(chip)],
    (into, dragged) => this.orders_.merge(into, dragged),
  );

  constructor(
    store: StudioStore,
    private readonly actions_: StudioActions,
    private readonly orders_: OrderActions,
  ) {
    drawPanel(this.root, store, ['groups', 'active', 'selected', 'standings'], (state) => (
      <>
        {state.groups.map((group, i) => this.chip(group, i, state))}
        {toolButton('plus', 'Add a group', () => this.actions_.openDialog('group'), {
          iconOnly: true,
          class: 'add-group',
        })}
      </>
    ));
    this.focus_ = new ToolbarFocus(this.root, store);
    store.watch(['groups', 'active', 'layout'], ({ groups, active, layout }) => {
      this.groups_ = groups.map(({ id }) => id);
      this.root.hidden = groups.length === 0;
      this.root.classList.toggle('many', groups.length > kNamed);
      this.focus_.refresh();
      const key = `${active} ${layout} ${groups.map(({ name }) => name).join()}`;
      if (key !== this.shown_) requestAnimationFrame(() => this.reveal(active));
      this.shown_ = key;
    });
  }

  /** Where chips are scrolled, the active group's is in sight. */
  private reveal(active: number): void {
    const chip = this.root.children[active] as HTMLElement | undefined;
    if (!chip) return;
    const [room, box] = [this.root.getBoundingClientRect(), chip.getBoundingClientRect()];
    if (box.left < room.left) this.root.scrollLeft += box.left - room.left - kBeside;
    else if (box.right > room.right) this.root.scrollLeft += box.right - room.right + kBeside;
  }

  private chip(group: GroupInfo, index: number, { groups, active, selected, standings }: StudioState): VNode {
    const { id, name, colour, count } = group;
    const barred = standingSum([standings[index] ?? []]).barred;
    const marks = `${barred === '' ? '' : ' barred'}${selected.length > 1 && selected.includes(id) ? ' chosen' : ''}${count === 0 ? ' empty' : ''}`;
    const pressed = (event: MouseEvent): void => {
      if (this.drag_.consumeClick()) return;
      if (event.shiftKey || event.ctrlKey || event.metaKey) this.orders_.choose(index, true);
      else this.pressed(index, event.timeStamp);
    };
    return (
      <button
        key={id}
        type="button"
        class={`chip${marks}`}
        style={{ '--accent': accentVariable(colour) }}
        aria-label={[`${name}, ${count} characters`, barred].filter((one) => one !== '').join(', ')}
        aria-pressed={groups[active]?.id === id}
        data-tip={`Choose ${name}; twice: bring it into view; drag it onto another to join them`}
        data-key="G"
        ref={(made) => this.watch(made, id)}
        onClick={pressed}
      >
        <GroupMark colour={colour} />
        <span class="chip-name">{name}</span>
        <span class="chip-count secondary">{formatCount(count)}</span>
      </button>
    );
  }

  private watch(chip: HTMLElement | null, id: number): void {
    if (!chip || this.watched_.has(chip)) return;
    this.watched_.add(chip);
    this.drag_.watch(chip, id);
  }

  /** The second press in a short time brings the group into view. */
  private pressed(index: number, time: number): void {
    const twice = this.last_.index === index && time - this.last_.time < kTwice;
    this.last_ = { index, time: twice ? -kTwice : time };
    if (twice) this.actions_.frameGroup(index);
    else this.actions_.setActiveGroup(index);
  }
}
