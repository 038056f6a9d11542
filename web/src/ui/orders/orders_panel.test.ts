// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import type { UnitInfo } from '../../model/studio_state';
import { StudioStore } from '../../model/studio_store';
import { OrdersPanel } from './orders_panel';
import { recordingActions } from '../widgets/test_support';
import { areaOf } from '../../protocol/test_scene';

const calls: string[] = [];
const actions = recordingActions(calls);
let store: StudioStore;
let root: HTMLElement;
const find = (selector: string): HTMLElement => root.querySelector<HTMLElement>(selector)!;
const tile = (label: string): HTMLElement => find(`.order-tile[aria-label="${label}"]`);

const unit: UnitInfo = {
  id: 7,
  orders: [],
  held: false,
  patrols: false,
  conduct: { stance: 'normal', cohesion: 0, squeeze: 1, avoids: false },
  classes: [],
};

beforeEach(() => {
  calls.length = 0;
  store = new StudioStore();
  root = new OrdersPanel(store, actions).root;
  document.body.replaceChildren(root);
  const groups = [{ id: 7, name: 'North', colour: 0, count: 9, formation: 'square' }];
  store.set({ loaded: true, groups, units: [unit] });
});

it('shows the tool in hand and takes another', () => {
  tile('Cut').click();
  expect(calls).toEqual(['toggleTool "cut"']);
  store.set({ tool: 'cut' });
  expect([tile('Cut'), tile('Steer')].map((one) => one.getAttribute('aria-pressed'))).toEqual(['true', 'false']);
});

it('offers to leave and to wait where there is an exit, or an area to wait in', () => {
  expect([tile('Leave').hidden, tile('Wait').hidden]).toEqual([true, true]);
  const area = areaOf({ id: 1 });
  store.set({ areas: [{ ...area, kind: 'exit' }] });
  expect([tile('Leave').hidden, tile('Wait').hidden]).toEqual([false, true]);
  store.set({ areas: [{ ...area, kind: 'waiting' }] });
  expect([tile('Leave').hidden, tile('Wait').hidden]).toEqual([true, false]);
  tile('Wait').click();
  expect(calls).toEqual(['toggleTool "wait"']);
});

it('says what the button of a group that waits does', () => {
  tile('Hold').click();
  store.set({ units: [{ ...unit, held: true, patrols: true }] });
  expect(tile('Go on').textContent).toBe('Go on');
  expect(tile('Patrol').getAttribute('aria-pressed')).toBe('true');
  tile('Stop').click();
  expect(calls).toEqual(['toggleHold', 'stop']);
});

it('undoes only where there is something to undo', () => {
  expect(tile('Undo').getAttribute('aria-disabled')).toBe('true');
  store.set({ history: { undo: 2, undoLabel: 'Change shape', redo: 0, redoLabel: '' } });
  expect(tile('Undo').getAttribute('aria-disabled')).toBe('false');
  expect(tile('Undo').dataset['tip']).toBe('Takes back: Change shape');
  expect(tile('Redo').getAttribute('aria-disabled')).toBe('true');
  store.set({ history: { undo: 0, undoLabel: '', redo: 1, redoLabel: 'Move' } });
  expect(tile('Redo').dataset['tip']).toBe('Does again: Move');
  tile('Undo').click();
  tile('Redo').click();
  expect(calls).toEqual(['undo', 'undo true']);
});

it('has the dials of the active group, and sets them', () => {
  store.set({ units: [{ ...unit, conduct: { stance: 'yield', cohesion: 0.25, squeeze: 0.5, avoids: true } }] });
  const cohesion = find('input[aria-label="Stay together"]') as HTMLInputElement;
  expect(cohesion.value).toBe('25');
  cohesion.value = '60';
  cohesion.dispatchEvent(new Event('change'));
  const pressed = [...root.querySelectorAll('[aria-label="Meets others"] button')].map((one) =>
    one.getAttribute('aria-pressed'),
  );
  expect(pressed).toEqual(['false', 'false', 'true']);
  const switches = [...root.querySelectorAll<HTMLElement>('.switch')];
  expect(switches.map((one) => one.getAttribute('aria-checked'))).toEqual(['false', 'true']);
  switches[0]!.click();
  switches[1]!.click();
  expect(calls).toEqual(['setConduct {"cohesion":0.6}', 'setStyle {"mode":"append"}', 'setConduct {"avoids":false}']);
});

it('tells the classes of the active group', () => {
  expect(find('.class-legend').hidden).toBe(true);
  store.set({ units: [{ ...unit, classes: [{ unitClass: 2, count: 12 }] }] });
  expect(find('.class-legend').textContent).toBe('Class 212');
});
