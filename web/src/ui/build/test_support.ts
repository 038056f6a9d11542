// Shows fields of what is chosen, and finds what somebody would fill in.

import { h, render } from 'preact';
import { kDrawingOptions } from '../../model/place/drawing';
import type { Thing } from '../../model/place/things';
import type { BuildActions } from './build_actions';
import { ChosenFields } from './chosen_fields';

/** A page on which what is chosen is shown. */
export function fieldsPage(given: object): { readonly root: HTMLElement; show(chosen: readonly Thing[]): void } {
  const root = document.createElement('div');
  document.body.replaceChildren(root);
  const actions = { options: kDrawingOptions, scene: null, time: 0, ...given } as unknown as BuildActions;
  return { root, show: (chosen) => render(h(ChosenFields, { chosen, actions }), root) };
}

/** The field with that label. */
export function fieldOf(root: HTMLElement, label: string): HTMLInputElement {
  const found = [...root.querySelectorAll<HTMLInputElement>('input, select')].find(
    (one) => (one.getAttribute('aria-label') ?? one.labels?.[0]?.firstElementChild?.textContent) === label,
  );
  if (!found) throw new Error(`no field ${label}`);
  return found;
}

/** Fills it in. */
export function fillIn(root: HTMLElement, label: string, value: string, ...events: string[]): void {
  const input = fieldOf(root, label);
  input.value = value;
  for (const event of events) input.dispatchEvent(new Event(event));
}
