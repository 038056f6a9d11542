// Keeps something of the browser's top layer beside what it belongs to, inside the window.

import { autoUpdate, computePosition, flip, offset, shift, size, type Placement } from '@floating-ui/dom';

/** Between the two, and from there to the window's edge [CSS px]. */
const kGap = 8;
/** What has less room than this in height takes more than there is [CSS px]. */
const kLeastHeight = 120;

export interface Beside {
  readonly placement: Placement;
  /** It is made as small as the room is; else it keeps its size. */
  readonly shrinks: boolean;
}

function place(owner: Element, panel: HTMLElement, { placement, shrinks }: Beside): void {
  const room = size({
    padding: kGap,
    apply: ({ availableHeight, availableWidth }) => {
      panel.style.maxHeight = `${Math.max(kLeastHeight, Math.floor(availableHeight))}px`;
      panel.style.maxWidth = `${Math.floor(availableWidth)}px`;
    },
  });
  // A side that has no room leaves it to the others; along its side it is moved.
  const turned = flip({ padding: kGap, crossAxis: false, fallbackAxisSideDirection: 'start' });
  const middleware = [offset(kGap), turned, shift({ padding: kGap }), ...(shrinks ? [room] : [])];
  void computePosition(owner, panel, { strategy: 'fixed', placement, middleware }).then(({ x, y }) => {
    panel.style.left = `${Math.round(x)}px`;
    panel.style.top = `${Math.round(y)}px`;
  });
}

/** Until what it returns is called. `gone`: the owner is no longer shown. */
export function keepBeside(owner: Element, panel: HTMLElement, how: Beside, gone: () => void): () => void {
  return autoUpdate(owner, panel, () => {
    // Browsers of before 2024 do not tell.
    if (owner.checkVisibility?.() === false) gone();
    else place(owner, panel, how);
  });
}
