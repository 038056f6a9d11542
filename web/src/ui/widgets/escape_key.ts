// Escape leaves what is open, before the keys of the studio, unless a dialog or a menu is open above it.

const kAbove = 'dialog[open], .popover:not([hidden])';

/** `open`: whether there is anything to leave at present. */
export function onEscape(open: () => boolean, leave: () => void): void {
  const pressed = (event: KeyboardEvent): void => {
    if (!open() || event.key !== 'Escape' || document.querySelector(kAbove)) return;
    event.stopImmediatePropagation();
    leave();
  };
  window.addEventListener('keydown', pressed, { capture: true });
}
