// A letter that is pressed together with Shift alone, anywhere but where somebody types.

/** `allowed`: whether the key means anything at present. */
export function onShiftKey(letter: string, act: () => void, allowed: () => boolean = () => true): void {
  const pressed = (event: KeyboardEvent): void => {
    if (event.key !== letter || !event.shiftKey || event.ctrlKey || event.metaKey || event.altKey || !allowed()) return;
    if (event.target instanceof HTMLElement && event.target.closest('input, textarea, select, dialog')) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    act();
  };
  // Before the keys of the studio, where the letter alone means something else.
  window.addEventListener('keydown', pressed, { capture: true });
}
