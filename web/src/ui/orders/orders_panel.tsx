// Tools for orders, buttons for the chosen groups, and what they do meanwhile: manner, turns, stance, cohesion and squeeze,
// and the classes.

import type { VNode } from 'preact';
import type { OrderActions } from '../../model/order_actions';
import { classColour, type ClassCount } from '../../model/roles';
import type { StudioState, ToolName, UnitInfo } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';
import type { AreaKindWord } from '../../protocol/generated/words';
import { ToolButton, toolButton, type ToolButtonProps } from '../widgets/buttons';
import { element } from '../widgets/dom';
import { accentVariable } from '../widgets/group_marks';
import type { IconName } from '../widgets/icons';
import { Menu } from '../widgets/menu';
import { drawPanel } from '../widgets/panel';
import { ToolbarFocus } from '../widgets/toolbar_focus';
import { ConductSettings } from './conduct_settings';

interface ToolDef {
  readonly tool: ToolName;
  readonly icon: IconName;
  readonly label: string;
  readonly key: string;
  readonly tip: string;
  /** It is shown where there is an area of that kind. */
  readonly needs?: AreaKindWord;
}

const kTools: readonly ToolDef[] = [
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
  { tool: 'follow', icon: 'follow', label: 'Follow', key: 'J', tip: 'Walks behind another group: press on it' },
  { tool: 'guard', icon: 'guard', label: 'Guard', key: 'U', tip: 'Then drag the rectangle to guard' },
  {
    tool: 'leave',
    icon: 'leave',
    label: 'Leave',
    key: 'Shift+X',
    tip: 'Then press on an exit; elsewhere: by all exits',
    needs: 'exit',
  },
  {
    tool: 'wait',
    icon: 'wait',
    label: 'Wait',
    key: 'Shift+U',
    tip: 'Then press on the area where they shall wait',
    needs: 'waiting',
  },
];

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

function tile(icon: IconName, label: string, act: () => void, more: Partial<ToolButtonProps> = {}): VNode {
  return toolButton(icon, label, act, { ...more, class: 'order-tile' });
}

interface Props {
  readonly state: StudioState;
  readonly actions: OrderActions;
}

function Tools({ state, actions }: Props): VNode {
  return (
    <div class="order-tools">
      {kTools.map(({ tool, key, needs, ...def }) => (
        <ToolButton
          key={tool}
          {...def}
          class="order-tile"
          shortcut={key}
          pressed={state.tool === tool}
          hidden={needs !== undefined && !state.areas.some(({ kind }) => kind === needs)}
          data={{ 'data-tool': tool }}
          act={() => actions.toggleTool(tool)}
        />
      ))}
    </div>
  );
}

function Buttons({ state, actions }: Props): VNode {
  const unit = unitOf(state);
  const { undo, undoLabel, redo, redoLabel } = state.history;
  const conduct = {
    icon: 'dials',
    label: 'Conduct',
    class: 'order-tile',
    tip: 'How the group walks, turns and meets others',
  } as const;
  return (
    <div class="order-buttons">
      {tile('words', 'Words', () => actions.toggleWords(), {
        shortcut: '/',
        pressed: state.words,
        tip: 'Say in words what they are to do',
        data: { 'data-tool': 'words' },
      })}
      {tile('stop', 'Stop', () => actions.stop(), { shortcut: 'S', tip: 'Drops all orders and stands' })}
      {tile('hold', unit.held ? 'Go on' : 'Hold', () => actions.toggleHold(), {
        shortcut: 'K',
        pressed: unit.held,
        tip: 'Stands still and keeps its orders',
      })}
      {tile('patrol', 'Patrol', () => actions.togglePatrol(), {
        shortcut: 'B',
        pressed: unit.patrols,
        tip: 'Goes through its orders again and again',
      })}
      <Menu opener={conduct} class="order-details" label="Conduct" placement="left-start" besidePanel>
        {() => <ConductSettings style={state.style} conduct={unit.conduct} actions={actions} />}
      </Menu>
      {tile('undo', 'Undo', () => actions.undo(), {
        shortcut: 'Z',
        idle: undo === 0,
        tip: undo > 0 ? `Takes back: ${undoLabel}` : 'Takes back what you did last',
      })}
      {tile('redo', 'Redo', () => actions.undo(true), {
        shortcut: 'Shift+Z',
        idle: redo === 0,
        tip: redo > 0 ? `Does again: ${redoLabel}` : 'Does again what you took back',
      })}
    </div>
  );
}

function Classes({ classes }: { readonly classes: readonly ClassCount[] }): VNode {
  return (
    <ul class="class-legend" aria-label="Classes" hidden={classes.length === 0}>
      {classes.map(({ unitClass, count }) => (
        <li key={unitClass}>
          <span class="class-swatch" style={{ background: classColour(unitClass) }} />
          <span class="class-name">Class {unitClass}</span>
          <span class="secondary">{count}</span>
        </li>
      ))}
    </ul>
  );
}

export class OrdersPanel {
  readonly root = element('section', { class: 'orders panel', 'aria-label': 'Orders' });
  private readonly focus_: ToolbarFocus;

  constructor(store: StudioStore, actions: OrderActions) {
    const fields = ['groups', 'active', 'units', 'history', 'loaded', 'tool', 'areas', 'style', 'words'] as const;
    drawPanel(this.root, store, fields, (state) => (
      <>
        <div class="order-bar" role="toolbar" aria-label="Orders">
          <Tools state={state} actions={actions} />
          <Buttons state={state} actions={actions} />
        </div>
        <Classes classes={unitOf(state).classes} />
      </>
    ));
    this.focus_ = new ToolbarFocus(this.root.firstElementChild as HTMLElement, store);
    store.watch(['groups', 'active', 'loaded', 'areas'], (state) => {
      this.root.hidden = !state.loaded;
      this.root.style.setProperty('--accent', accentVariable(state.groups[state.active]?.colour ?? 0));
      this.focus_.refresh();
    });
  }
}
