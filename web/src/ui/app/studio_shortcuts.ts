// The studio's keys.

import { OverlayKind } from '../../protocol/messages';
import type { ArrowKey } from '../../tools/keyboard_steering';
import type { Shortcut, ShortcutGroup } from '../../tools/shortcuts';
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

type More = Partial<Omit<Shortcut, 'keys' | 'does' | 'group' | 'run'>>;
type Maker = (keys: string, does: string, run?: Shortcut['run'], more?: More) => Shortcut;

/** Makes shortcuts of a group: what acts has the letter that the help shows, unless more is said. */
function keysOf(group: ShortcutGroup): Maker {
  return (keys, does, run, more = {}) => ({
    keys,
    does,
    group,
    match: run && !more.alt ? [keys.toLowerCase()] : [],
    ...(run && { run }),
    ...more,
  });
}

function crowdKeys(tools: KeyTools): Shortcut[] {
  const key = keysOf('Crowd');
  return [
    key('Enter', 'takes the formation in hand, and drops it', ({ shiftKey }) => tools.enter(shiftKey), {
      match: ['Enter'],
      sceneOnly: true,
    }),
    key('← ↑ → ↓', 'carry it (Shift: farther)'),
    key('P', 'pins the control under the pointer, or the newest', () => tools.togglePin()),
    key('Delete', 'removes it', () => tools.removeControl(), { match: ['Delete', 'Backspace'] }),
    key('Esc', 'lets go of all controls', () => tools.letGo(), { match: ['Escape'] }),
    key('G', 'next group', () => tools.nextGroup()),
  ];
}

function orderKeys(orders: OrderActions): Shortcut[] {
  const key = keysOf('Orders');
  return [
    key('O Enter ← ↑ → ↓ Enter', 'with an order tool or X: a cursor begins, draws and ends; Esc gives up'),
    key('O', 'order tool: press or drag on the ground', () => orders.toggleTool('order')),
    key('X', 'cutting tool: divides and joins', ({ shiftKey }) => orders.toggleTool(shiftKey ? 'leave' : 'cut')),
    key('J', 'follow a group: then press on it', () => orders.toggleTool('follow')),
    key('U', 'guard: then drag a rectangle', ({ shiftKey }) => orders.toggleTool(shiftKey ? 'wait' : 'guard')),
    key('Shift+X', 'leave: then press on an exit'),
    key('Shift+U', 'wait: then press on a waiting area'),
    key('/', 'directing by words', () => orders.toggleWords()),
    key('S', 'stop', () => orders.stop()),
    key('K', 'hold (stand still, keep the orders), or go on', () => orders.toggleHold()),
    key('B', 'patrol, or end it', () => orders.togglePatrol()),
    key('Y', 'skip to the next order', () => orders.skipOrder()),
    key('A', 'all groups', () => orders.chooseAll()),
    key('Z Ctrl+Z', 'takes back what you did last', ({ shiftKey }) => orders.undo(shiftKey), {
      match: ['z'],
      ctrl: true,
    }),
    key('Shift+Z Ctrl+Y', 'does it again', () => orders.undo(true), { match: ['y'], ctrl: 'only' }),
  ];
}

function formationKeys(actions: StudioActions): Shortcut[] {
  const key = keysOf('Formations');
  const choices = kFormations.slice(0, 8);
  return [
    key('1 – 8', choices.map(({ label }) => label.toLowerCase()).join(', ')),
    ...choices.map(({ name, label }, i) =>
      key(String(i + 1), label, () => actions.setFormation(name), { unlisted: true }),
    ),
    key(
      '9',
      'held: a stroke is the outline of the formation; pressed: the next stroke is',
      () => actions.holdDraw(true),
      { release: () => actions.holdDraw(false) },
    ),
  ];
}

function timeKeys(actions: StudioActions): Shortcut[] {
  const key = keysOf('Time');
  return [
    // Space acts on its release, as it also pans while a mouse drags: see SpaceKey.
    key('Space', 'plays or pauses'),
    key('.', 'single step', () => actions.singleStep(), { repeats: true }),
    key('< >', 'slower, faster', (event) => actions.nextSpeed(event.key === '<'), { match: ['<', '>'] }),
    key('R', 'records a take, and stops', () => actions.toggleRecord()),
    key('W', 'watches what the place shows, and stops', () => actions.toggleDemonstration()),
    key('Home', 'restart', () => actions.restart(), { match: ['Home'], sceneOnly: true }),
  ];
}

function cameraKeys(actions: StudioActions, tools: KeyTools): Shortcut[] {
  const key = keysOf('Camera');
  const match = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight'];
  const turn = ({ key: pressed }: KeyboardEvent): void =>
    tools.turn(pressed.toLowerCase() === 'q' ? kQuarterStep : -kQuarterStep);
  const view = ({ code, shiftKey }: KeyboardEvent): void => {
    const number = Number(code.slice(-1));
    if (shiftKey) actions.saveView(number);
    else actions.showView(number);
  };
  return [
    key('← ↑ → ↓', 'pan', (event) => tools.arrow(event.key as ArrowKey, event.shiftKey), {
      match,
      sceneOnly: true,
      repeats: true,
    }),
    key('+ -', 'zoom', (event) => tools.zoom(event.key === '-' ? 1 / 1.2 : 1.2), {
      match: ['+', '=', '-'],
      repeats: true,
    }),
    key('Q E', 'turn', turn, { match: ['q', 'e'], repeats: true }),
    key('F', 'fits crowd and paths; pressed again, the whole place', () => actions.fit()),
    key('I', 'tracks the crowd, or stays', () => actions.toggleFollow()),
    key('Alt+T', 'from above', () => actions.toggleTop(), { alt: ['KeyT'] }),
    key('Alt+O', 'without perspective', () => actions.toggleFlat(), { alt: ['KeyO'] }),
    key('Alt+1 – 9', 'shows a saved view (with Shift: saves it)', view, {
      alt: Array.from({ length: 9 }, (_, i) => `Digit${i + 1}`),
    }),
  ];
}

function showKeys(actions: StudioActions): Shortcut[] {
  const key = keysOf('Show');
  return [
    key('M', 'mesh of the formation', () => actions.toggleLayer('mesh')),
    key('L', 'spots where people shall stand', () => actions.toggleLayer('places')),
    key('T', 'paths', () => actions.toggleLayer('paths')),
    key('V', 'push of obstacles', () => actions.toggleOverlay(OverlayKind.Field)),
    key('C', 'effort of a person’s ways', () => actions.toggleOverlay(OverlayKind.Cost)),
    key('D', 'density', () => actions.toggleOverlay(OverlayKind.Density)),
    key('0', 'a clean picture, without marks and panels', () => actions.toggleClean()),
    key('N', 'light or dark', () => actions.toggleTheme()),
    key('H ?', 'this help', () => actions.showHelp(true), { match: ['h', '?'] }),
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
