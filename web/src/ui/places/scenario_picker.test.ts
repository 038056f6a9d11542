// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { ScenarioInfo } from '../../protocol/messages';
import { ScenarioPicker } from './scenario_picker';
import type { StudioActions } from '../../model/studio_actions';
import { StudioStore } from '../../model/studio_store';

const info = (name: string, title: string): ScenarioInfo => ({ name, title, description: '', characters: 9 });
const loadScenario = vi.fn();
const showPlaces = vi.fn();
let store: StudioStore;
let root: HTMLElement;

beforeEach(() => {
  store = new StudioStore();
  root = new ScenarioPicker(store, { loadScenario, showPlaces } as unknown as StudioActions).root;
  document.body.replaceChildren(root);
  store.set({
    scenarios: [info('open', 'Open square'), info('paper/x04', 'X4'), info('paper/x06', 'X6')],
    scenario: 'paper/x04',
  });
});

const press = (key: string) =>
  document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));

it('names the group of a folder by its heading', () => {
  const group = root.querySelector('.scenario-group')!;
  expect(root.querySelector(`#${group.getAttribute('aria-labelledby')}`)!.textContent).toBe('The paper’s experiments');
  expect([...group.querySelectorAll('.scenario-name')].map((node) => node.textContent)).toEqual(['X4', 'X6']);
  expect(root.querySelectorAll('.scenario-item')).toHaveLength(3);
});

it('opens on the current scenario; arrows go on across groups, and a choice loads by the whole name', () => {
  root.querySelector<HTMLElement>('.scenario-button')!.click();
  expect(document.activeElement!.getAttribute('aria-current')).toBe('true');
  press('ArrowUp');
  expect(document.activeElement!.textContent).toContain('Open square');
  press('End');
  for (let i = 0; i < 4; ++i) press('ArrowUp');
  (document.activeElement as HTMLElement).click();
  expect(loadScenario).toHaveBeenCalledWith('paper/x06');
});

it('has the ways to places of one’s own below the scenarios', () => {
  root.querySelector<HTMLElement>('.scenario-button')!.click();
  press('End');
  expect(document.activeElement!.textContent).toBe('Save this place…');
  (document.activeElement as HTMLElement).click();
  expect(showPlaces).toHaveBeenCalledWith('save');
});
