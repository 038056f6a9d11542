// Escape leaves what is open, before the keys of the studio, unless a dialog is open above it.

/** `open`: whether there is anything to leave at present. */
export function onEscape(open: () => boolean, leave: () => void): void {
  const pressed = (event: KeyboardEvent): void => {
    if (!open() || event.key !== 'Escape' || document.querySelector('dialog[open]')) return;
    event.stopImmediatePropagation();
    leave();
  };
  window.addEventListener('keydown', pressed, { capture: true });
}
