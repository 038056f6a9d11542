// While one finger holds the formation, another one must be able to press buttons. Browsers make clicks only of the
// first finger of a gesture, so clicks of further fingers are made here.

/** Where a further finger came down. */
type Presses = Map<number, HTMLButtonElement>;

function buttonOf(target: EventTarget | null): HTMLButtonElement | null {
  return target instanceof Element ? target.closest('button') : null;
}

/** Watches all buttons inside `root`. */
export function pressWithExtraFingers(root: HTMLElement): void {
  const presses: Presses = new Map();
  root.addEventListener('pointerdown', (event) => {
    const button = buttonOf(event.target);
    if (button && event.pointerType === 'touch' && !event.isPrimary) presses.set(event.pointerId, button);
  });
  root.addEventListener('pointerup', (event) => {
    const button = presses.get(event.pointerId);
    presses.delete(event.pointerId);
    if (button && buttonOf(event.target) === button && !button.disabled) button.click();
  });
  root.addEventListener('pointercancel', (event) => presses.delete(event.pointerId));
}
