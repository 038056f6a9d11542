// A click closes a dialog by its backdrop only where its press began there, too. The press that opened the dialog began
// on a button, and may end when the backdrop lies over that.

export function guardBackdrops(root: Document): void {
  let pressed: EventTarget | null = null;
  root.addEventListener('pointerdown', ({ target }) => void (pressed = target), true);
  root.addEventListener(
    'click',
    (event) => {
      if (event.target instanceof HTMLDialogElement && event.target !== pressed) event.stopImmediatePropagation();
    },
    true,
  );
}
