// Tools for orders, buttons for the chosen groups, and what they do meanwhile: manner, turns, stance, cohesion and squeeze,
// and the classes.

import { kManners, kStances, kTurns } from '../../model/commands';
import { classColour } from '../../model/roles';
import type { OrderActions } from '../../model/order_actions';
import type { StudioState, ToolName, UnitInfo } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { AreaKindWord } from '../../protocol/generated/words';
import { element, setAttribute, setPressed, setText } from '../widgets/dom';
import { accentVariable } from '../widgets/group_marks';
import { icon, type IconName } from '../widgets/icons';
import { Popover } from '../widgets/popover';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import { choiceRow, dial, switchRow } from '../widgets/settings_rows';

interface ButtonDef {
  readonly icon: IconName;
  readonly label: string;
  readonly key: string;
  readonly tip: string;
  readonly act: () => void;
}

const kTools: readonly (Omit<ButtonDef, 'act'> & { readonly tool: ToolName })[] = [
  { tool: 'steer', icon: 'steer', label: 'Steer', key: 'Esc', tip: 'Fingers and mouse shape the formation' },
  {
    tool: 'order',
    icon: 'order',
    label: 'Order',
    key: 'O',
    tip: 'Press: go there. Drag: the front, from left to right. From the formation: its way',
  },
  {
    tool: 'cut',
    icon: 'cut',
    label: 'Cut',
    key: 'X',
    tip: 'Draw across a formation to divide it, from one to another to join them',
  },
  { tool: 'follow', icon: 'follow', label: 'Follow', key: 'J', tip: 'Then press on the group to follow' },
  { tool: 'guard', icon: 'guard', label: 'Guard', key: 'U', tip: 'Then drag the rectangle to guard' },
  {
    tool: 'leave',
    icon: 'leave',
    label: 'Leave',
    key: 'Shift+X',
    tip: 'Then press on an exit; elsewhere: by all exits',
  },
  { tool: 'wait', icon: 'wait', label: 'Wait', key: 'Shift+U', tip: 'Then press on the area where they shall wait' },
];

/** Tools that are shown where there is an area of that kind. */
const kNeeds: Partial<Record<ToolName, AreaKindWord>> = { leave: 'exit', wait: 'waiting' };

const kIdle: Omit<UnitInfo, 'id'> = {
  orders: [],
  held: false,
  patrols: false,
  conduct: { stance: 'normal', cohesion: 0, squeeze: 1, avoids: false },
  classes: [],
};

function unitOf(state: StudioState): Omit<UnitInfo, 'id'> {
  return state.units[state.active] ?? kIdle;
}

function tile(def: ButtonDef, pressed: boolean): HTMLButtonElement {
  const button = element(
    'button',
    {
      type: 'button',
      class: 'order-tile',
      'aria-label': def.label,
      'aria-pressed': pressed ? 'false' : undefined,
      'aria-keyshortcuts': def.key,
      'data-key': def.key,
      'data-tip': def.tip,
    },
    icon(def.icon),
    element('span', { class: 'label' }, def.label),
  );
  button.addEventListener('click', () => def.act());
  return button;
}

export class OrdersPanel {
  private readonly tools_ = element('div', { class: 'order-tools' });
  private readonly buttons_ = element('div', { class: 'order-buttons' });
  private readonly legend_ = element('ul', { class: 'class-legend', 'aria-label': 'Classes' });
  private readonly bar_ = element(
    'div',
    { class: 'order-bar', role: 'toolbar', 'aria-label': 'Orders' },
    this.tools_,
    this.buttons_,
  );
  private readonly details_ = element('div', { class: 'order-details panel', role: 'group', 'aria-label': 'Conduct' });
  readonly root = element('section', { class: 'orders panel', 'aria-label': 'Orders' }, this.bar_, this.legend_);
  private readonly hold_: HTMLButtonElement;
  private readonly patrol_: HTMLButtonElement;
  private readonly undo_: HTMLButtonElement;
  private readonly redo_: HTMLButtonElement;
  private legendKey_ = '';

  constructor(
    private readonly store_: StudioStore,
    private readonly actions_: OrderActions,
  ) {
    this.addTools();
    const button = (def: ButtonDef, pressed = false): HTMLButtonElement => {
      const made = tile(def, pressed);
      this.buttons_.append(made);
      return made;
    };
    const stop = { icon: 'stop', label: 'Stop', key: 'S', tip: 'Drops all orders and stands' } as const;
    button({ ...stop, act: () => actions_.stop() });
    const hold = { icon: 'hold', label: 'Hold', key: 'K', tip: 'Waits; the queue stays' } as const;
    this.hold_ = button({ ...hold, act: () => actions_.toggleHold() }, true);
    const patrol = { icon: 'patrol', label: 'Patrol', key: 'B', tip: 'Its orders again and again' } as const;
    this.patrol_ = button({ ...patrol, act: () => actions_.togglePatrol() }, true);
    const more = { icon: 'dials', label: 'Conduct', key: '', tip: 'How orders are carried out' } as const;
    const opener = button({ ...more, act: () => undefined });
    const undo = { icon: 'undo', label: 'Undo', key: 'Z', tip: '' } as const;
    this.undo_ = button({ ...undo, act: () => actions_.undo() });
    const redo = { icon: 'redo', label: 'Redo', key: 'Shift+Z', tip: '' } as const;
    this.redo_ = button({ ...redo, act: () => actions_.undo(true) });
    this.addDetails();
    this.root.append(this.details_);
    new Popover(opener, this.details_, 'left-start');
    new ToolbarFocus(this.bar_, store_);
    store_.watch(['groups', 'active', 'units', 'history', 'loaded'], (state) => this.show(state));
  }

  private addTools(): void {
    for (const { tool, ...def } of kTools) {
      const button = tile({ ...def, act: () => this.actions_.toggleTool(tool) }, true);
      button.dataset['tool'] = tool;
      this.store_.watch(['tool'], (state) => setPressed(button, state.tool === tool));
      this.tools_.append(button);
      const needs = kNeeds[tool];
      if (needs)
        this.store_.watch(['areas'], ({ areas }) => (button.hidden = !areas.some(({ kind }) => kind === needs)));
    }
  }

  private addDetails(): void {
    const style = this.styleRows();
    const conduct = this.conductRows();
    this.details_.append(element('h2', {}, 'Orders'), ...style, element('h2', {}, 'Conduct'), ...conduct);
  }

  /** How new orders are given. */
  private styleRows(): HTMLElement[] {
    const { actions_: actions, store_: store } = this;
    const way = choiceRow(
      'Way',
      kManners,
      ['In formation, waiting for the last', 'Each by the shortest way (Alt)'],
      (manner) => actions.setStyle({ manner }),
    );
    const turns = choiceRow(
      'Turns',
      kTurns,
      [
        'Faces along its way',
        'Its rear becomes its front',
        'Faces one way until it has arrived',
        'Each to a near place: arrives first',
      ],
      (turn) => actions.setStyle({ turn }),
    );
    const append = switchRow('Add to the queue', 'New orders come last, as with Shift', (on) =>
      actions.setStyle({ mode: on ? 'append' : 'replace' }),
    );
    store.watch(['style'], ({ style }) => {
      way.show(style.manner);
      turns.show(style.turn);
      append.show(style.mode === 'append');
    });
    return [way.root, turns.root, append.root];
  }

  /** How the chosen groups behave. */
  private conductRows(): HTMLElement[] {
    const { actions_: actions, store_: store } = this;
    const stance = choiceRow('Meets others', kStances, ['Both make room', 'Holds its ground', 'Makes room'], (word) =>
      actions.setConduct({ stance: word }),
    );
    const cohesion = dial('Cohesion', ['own pace', 'the slowest’s'], (value) =>
      actions.setConduct({ cohesion: value }),
    );
    const squeeze = dial('Squeeze', ['keeps its width', 'gives it up'], (value) =>
      actions.setConduct({ squeeze: value }),
    );
    const avoids = switchRow('Give way', 'Its mesh keeps clear of others and of moving obstacles', (on) =>
      actions.setConduct({ avoids: on }),
    );
    store.watch(['units', 'active'], (state) => {
      const { conduct } = unitOf(state);
      stance.show(conduct.stance);
      cohesion.show(conduct.cohesion);
      squeeze.show(conduct.squeeze);
      avoids.show(conduct.avoids);
    });
    return [stance.root, cohesion.root, squeeze.root, avoids.root];
  }

  private show(state: StudioState): void {
    this.root.hidden = !state.loaded;
    const unit = unitOf(state);
    const colour = state.groups[state.active]?.colour ?? 0;
    this.root.style.setProperty('--accent', accentVariable(colour));
    setPressed(this.hold_, unit.held);
    setPressed(this.patrol_, unit.patrols);
    setText(this.hold_.lastElementChild!, unit.held ? 'Go on' : 'Hold');
    setAttribute(this.hold_, 'aria-label', unit.held ? 'Go on' : 'Hold');
    this.showHistory(state.history);
    this.showLegend(unit);
  }

  private showHistory({ undo, undoLabel, redo, redoLabel }: StudioState['history']): void {
    const show = (button: HTMLElement, count: number, tip: string): void => {
      setAttribute(button, 'aria-disabled', String(count === 0));
      setAttribute(button, 'data-tip', tip);
    };
    show(this.undo_, undo, undo > 0 ? `Takes back: ${undoLabel}` : 'Takes back what you did last');
    show(this.redo_, redo, redo > 0 ? `Does again: ${redoLabel}` : 'Does again what you took back');
  }

  private showLegend({ classes }: Omit<UnitInfo, 'id'>): void {
    const key = JSON.stringify(classes);
    if (key === this.legendKey_) return;
    this.legendKey_ = key;
    this.legend_.hidden = classes.length === 0;
    this.legend_.replaceChildren(
      ...classes.map(({ unitClass, count }) => {
        const swatch = element('span', { class: 'class-swatch' });
        swatch.style.background = classColour(unitClass);
        const name = element('span', { class: 'class-name' }, `Class ${unitClass}`);
        return element('li', {}, swatch, name, element('span', { class: 'secondary' }, String(count)));
      }),
    );
  }
}
