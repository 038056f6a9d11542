// A press by mouse or finger gives the focus back to the scene, or Space would press the same button again. Keys keep
// it.

/** Watches the buttons inside `root`. */
export function returnFocus(root: HTMLElement, scene: HTMLElement): void {
  root.addEventListener('click', (event) => {
    // A click by keyboard counts no presses.
    if (event.detail === 0 || !(event.target instanceof Element)) return;
    const { activeElement } = document;
    if (!(activeElement instanceof HTMLElement) || !root.contains(activeElement) || isOpen(activeElement)) return;
    const quietly: FocusOptions & { focusVisible: boolean } = { preventScroll: true, focusVisible: false };
    scene.focus(quietly);
  });
}

/** A dialog or an open list has keys of its own. */
function isOpen(focused: HTMLElement): boolean {
  if (focused.closest('dialog[open], [role="dialog"]') !== null) return true;
  return focused.closest('[role="group"]') !== null || focused.getAttribute('aria-expanded') === 'true';
}
