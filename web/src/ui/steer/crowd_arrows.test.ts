// @vitest-environment jsdom
import { expect, it } from 'vitest';
import { colourNumber } from '../../model/accent';
import type { StudioActions } from '../../model/studio_actions';
import { StudioStore } from '../../model/studio_store';
import { CrowdArrows } from './crowd_arrows';

it('takes another colour of its group and stays the same button', () => {
  const store = new StudioStore();
  const arrows = new CrowdArrows(store, {} as StudioActions);
  const group = { id: 4, name: 'Guests', colour: 1, count: 9, formation: 'square' };
  store.set({ groups: [group] });
  store.set({ arrows: [{ index: 0, id: 4, x: 100, y: 50, angle: 0 }] });
  const button = arrows.root.querySelector('button')!;
  const shape = button.querySelector('.mark')!.innerHTML;
  expect(button.style.getPropertyValue('--accent')).toBe('var(--group-ember)');
  store.set({ groups: [{ ...group, colour: colourNumber(1, '#05536d') }] });
  expect(arrows.root.querySelector('button')).toBe(button);
  expect(button.style.getPropertyValue('--accent')).toBe('var(--swatch-teal)');
  expect(button.querySelectorAll('.mark').length).toBe(1);
  expect(button.querySelector('.mark')!.innerHTML).toBe(shape);
});
