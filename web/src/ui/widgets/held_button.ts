// A button that acts while a finger holds it, as a key does; a short press is one of both.

/** A click that comes so soon after a finger has lifted is the same press [ms]. */
const kSamePress = 600;

/** `holds` hears when a finger comes down on the button, and when it lifts or is lost: then it has pressed nothing. */
export function holdWithFinger(button: HTMLElement, holds: (held: boolean, lost: boolean) => void): void {
  let finger: number | null = null;
  let lifted = -Infinity;
  const end = (event: PointerEvent): void => {
    if (event.pointerId !== finger) return;
    finger = null;
    lifted = event.timeStamp;
    holds(false, event.type === 'pointercancel');
  };
  button.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'mouse' || finger !== null) return;
    finger = event.pointerId;
    holds(true, false);
  });
  button.addEventListener('pointerup', end);
  button.addEventListener('pointercancel', end);
  button.addEventListener('contextmenu', (event) => event.preventDefault());
  button.addEventListener(
    'click',
    (event) => {
      // The finger's press has been heard already.
      if (finger !== null || event.timeStamp - lifted < kSamePress) event.stopImmediatePropagation();
    },
    true,
  );
}
