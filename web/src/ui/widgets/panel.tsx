// Panels whose content follows from the state of the page.

import { render, type ComponentChildren } from 'preact';
import type { StudioState } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';

/** Draws the content of a panel, at once and whenever one of the fields changes. */
export function drawPanel(
  root: HTMLElement,
  store: StudioStore,
  fields: readonly (keyof StudioState)[],
  content: (state: StudioState) => ComponentChildren,
): void {
  store.watch(fields, (state) => render(content(state), root));
}
