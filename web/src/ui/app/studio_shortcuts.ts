// The studio's keys.

import { OverlayKind } from '../../protocol/messages';
import type { ArrowKey } from '../../tools/keyboard_steering';
import type { Shortcut } from '../../tools/shortcuts';
import { kFormations } from '../formations/formation_panel';
import type { OrderActions } from '../../model/order_actions';
import type { StudioActions } from '../../model/studio_actions';

/** What keys ask of camera and tools. */
export interface KeyTools {
  arrow(key: ArrowKey, long: boolean): void;
  zoom(factor: number): void;
  turn(radians: number): void;
  enter(shift: boolean): void;
  letGo(): void;
  togglePin(): void;
  removeControl(): void;
  nextGroup(): void;
}

const kQuarterStep = Math.PI / 36;

function crowdKeys(tools: KeyTools): Shortcut[] {
  return [
    {
      keys: 'Enter',
      does: 'takes the formation in hand, and drops it',
      group: 'Crowd',
      match: ['Enter'],
      sceneOnly: true,
      run: ({ shiftKey }) => tools.enter(shiftKey),
    },
    { keys: '← ↑ → ↓', does: 'carry it (Shift: farther)', group: 'Crowd', match: [] },
    {
      keys: 'O Enter ← ↑ → ↓ Enter',
      does: 'with an order tool or X: a cursor begins, draws and ends; Esc gives up',
      group: 'Orders',
      match: [],
    },
    {
      keys: 'P',
      does: 'pins the control under the pointer, or the newest',
      group: 'Crowd',
      match: ['p'],
      run: () => tools.togglePin(),
    },
    {
      keys: 'Delete',
      does: 'removes it',
      group: 'Crowd',
      match: ['Delete', 'Backspace'],
      run: () => tools.removeControl(),
    },
    { keys: 'Esc', does: 'lets go of all controls', group: 'Crowd', match: ['Escape'], run: () => tools.letGo() },
    { keys: 'G', does: 'next group', group: 'Crowd', match: ['g'], run: () => tools.nextGroup() },
  ];
}

function orderKeys(orders: OrderActions): Shortcut[] {
  const key = (keys: string, does: string, run: (event: KeyboardEvent) => void): Shortcut => ({
    keys,
    does,
    group: 'Orders',
    match: [keys.toLowerCase()],
    run,
  });
  return [
    key('O', 'order tool: press or drag on the ground', () => orders.toggleTool('order')),
    key('X', 'cutting tool: divides and joins', ({ shiftKey }) => orders.toggleTool(shiftKey ? 'leave' : 'cut')),
    key('J', 'follow a group: then press on it', () => orders.toggleTool('follow')),
    key('U', 'guard: then drag a rectangle', ({ shiftKey }) => orders.toggleTool(shiftKey ? 'wait' : 'guard')),
    { keys: 'Shift+X', does: 'leave: then press on an exit', group: 'Orders', match: [] },
    { keys: 'Shift+U', does: 'wait: then press on a waiting area', group: 'Orders', match: [] },
    key('/', 'directing by words', () => orders.toggleWords()),
    key('S', 'stop', () => orders.stop()),
    key('K', 'hold (stand still, keep the orders), or go on', () => orders.toggleHold()),
    key('B', 'patrol, or end it', () => orders.togglePatrol()),
    key('Y', 'skip to the next order', () => orders.skipOrder()),
    key('A', 'all groups', () => orders.chooseAll()),
    {
      keys: 'Z Ctrl+Z',
      does: 'takes back what you did last',
      group: 'Orders',
      match: ['z'],
      ctrl: true,
      run: ({ shiftKey }) => orders.undo(shiftKey),
    },
    {
      keys: 'Shift+Z Ctrl+Y',
      does: 'does it again',
      group: 'Orders',
      match: ['y'],
      ctrl: 'only',
      run: () => orders.undo(true),
    },
  ];
}

function formationKeys(actions: StudioActions): Shortcut[] {
  const choices = kFormations.slice(0, 8);
  const all: Shortcut = {
    keys: '1 – 8',
    does: choices.map(({ label }) => label.toLowerCase()).join(', '),
    group: 'Formations',
    match: [],
  };
  const keys = choices.map(({ name, label }, i): Shortcut => {
    const key = String(i + 1);
    return {
      keys: key,
      does: label,
      group: 'Formations',
      match: [key],
      unlisted: true,
      run: () => actions.setFormation(name),
    };
  });
  const draw: Shortcut = {
    keys: '9',
    does: 'held: a stroke is the outline of the formation; pressed: the next stroke is',
    group: 'Formations',
    match: ['9'],
    run: () => actions.holdDraw(true),
    release: () => actions.holdDraw(false),
  };
  return [all, ...keys, draw];
}

function timeKeys(actions: StudioActions): Shortcut[] {
  return [
    // Space acts on its release, as it also pans while a mouse drags: see SpaceKey.
    { keys: 'Space', does: 'plays or pauses', group: 'Time', match: [] },
    { keys: '.', does: 'single step', group: 'Time', match: ['.'], repeats: true, run: () => actions.singleStep() },
    {
      keys: '< >',
      does: 'slower, faster',
      group: 'Time',
      match: ['<', '>'],
      run: (event) => actions.nextSpeed(event.key === '<'),
    },
    { keys: 'R', does: 'records a take, and stops', group: 'Time', match: ['r'], run: () => actions.toggleRecord() },
    {
      keys: 'W',
      does: 'watches what the place shows, and stops',
      group: 'Time',
      match: ['w'],
      run: () => actions.toggleDemonstration(),
    },
    { keys: 'Home', does: 'restart', group: 'Time', match: ['Home'], sceneOnly: true, run: () => actions.restart() },
  ];
}

function cameraKeys(actions: StudioActions, tools: KeyTools): Shortcut[] {
  const arrows = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight'];
  return [
    {
      keys: '← ↑ → ↓',
      does: 'pan',
      group: 'Camera',
      match: arrows,
      sceneOnly: true,
      repeats: true,
      run: (event) => tools.arrow(event.key as ArrowKey, event.shiftKey),
    },
    {
      keys: '+ -',
      does: 'zoom',
      group: 'Camera',
      match: ['+', '=', '-'],
      repeats: true,
      run: (event) => tools.zoom(event.key === '-' ? 1 / 1.2 : 1.2),
    },
    {
      keys: 'Q E',
      does: 'turn',
      group: 'Camera',
      match: ['q', 'e'],
      repeats: true,
      run: (event) => tools.turn(event.key.toLowerCase() === 'q' ? kQuarterStep : -kQuarterStep),
    },
    {
      keys: 'F',
      does: 'fits crowd and paths; pressed again, the whole place',
      group: 'Camera',
      match: ['f'],
      run: () => actions.fit(),
    },
    {
      keys: 'I',
      does: 'tracks the crowd, or stays',
      group: 'Camera',
      match: ['i'],
      run: () => actions.toggleFollow(),
    },
    ...viewKeys(actions),
  ];
}

function viewKeys(actions: StudioActions): Shortcut[] {
  const digits = Array.from({ length: 9 }, (_, i) => `Digit${i + 1}`);
  return [
    { keys: 'Alt+T', does: 'from above', group: 'Camera', match: [], alt: ['KeyT'], run: () => actions.toggleTop() },
    {
      keys: 'Alt+O',
      does: 'without perspective',
      group: 'Camera',
      match: [],
      alt: ['KeyO'],
      run: () => actions.toggleFlat(),
    },
    {
      keys: 'Alt+1 – 9',
      does: 'shows a saved view (with Shift: saves it)',
      group: 'Camera',
      match: [],
      alt: digits,
      run: (event) => {
        const number = Number(event.code.slice(-1));
        if (event.shiftKey) actions.saveView(number);
        else actions.showView(number);
      },
    },
  ];
}

function showKeys(actions: StudioActions): Shortcut[] {
  const key = (keys: string, does: string, run: () => void): Shortcut => ({
    keys,
    does,
    group: 'Show',
    match: [keys.toLowerCase()],
    run,
  });
  return [
    key('M', 'mesh of the formation', () => actions.toggleLayer('mesh')),
    key('L', 'spots where people shall stand', () => actions.toggleLayer('places')),
    key('T', 'paths', () => actions.toggleLayer('paths')),
    key('V', 'push of obstacles', () => actions.toggleOverlay(OverlayKind.Field)),
    key('C', 'effort of a person’s ways', () => actions.toggleOverlay(OverlayKind.Cost)),
    key('D', 'density', () => actions.toggleOverlay(OverlayKind.Density)),
    key('0', 'a clean picture, without marks and panels', () => actions.toggleClean()),
    key('N', 'light or dark', () => actions.toggleTheme()),
    { keys: 'H ?', does: 'this help', group: 'Show', match: ['h', '?'], run: () => actions.showHelp(true) },
  ];
}

export function studioShortcuts(actions: StudioActions, orders: OrderActions, tools: KeyTools): Shortcut[] {
  return [
    ...crowdKeys(tools),
    ...orderKeys(orders),
    ...formationKeys(actions),
    ...timeKeys(actions),
    ...cameraKeys(actions, tools),
    ...showKeys(actions),
  ];
}
