// Shows what a button would do before it does it: while a mouse rests on it, while it has the focus of a keyboard, and
// while a finger holds it. A finger that slides away takes nothing.

export interface Look {
  /** Shows it. */
  look(): void;
  /** Takes it away. */
  leave(): void;
  /** Does it, for a finger that has looked: browsers make no click of a long press. */
  take(): void;
}

/** A mouse that only passes shows nothing; a finger that taps does not, either [ms]. */
const kRest = { mouse: 120, touch: 220 };
/** A click that comes so soon after a finger has taken is the same press [ms]. */
const kSamePress = 600;

export function lookFirst(button: HTMLElement, act: Look): void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  let looked = false;
  let taken = -Infinity;
  const soon = (ms: number): void => {
    stop();
    timer = setTimeout(() => {
      timer = null;
      looked = true;
      act.look();
    }, ms);
  };
  const stop = (): void => {
    if (timer !== null) clearTimeout(timer);
    timer = null;
    if (looked) act.leave();
    looked = false;
  };
  const isTouch = (event: PointerEvent): boolean => event.pointerType !== 'mouse';
  button.addEventListener('pointerenter', (event) => !isTouch(event) && event.buttons === 0 && soon(kRest.mouse));
  button.addEventListener('pointerleave', (event) => !isTouch(event) && stop());
  button.addEventListener('pointerdown', (event) => isTouch(event) && soon(kRest.touch));
  button.addEventListener('pointercancel', stop);
  button.addEventListener('pointerup', (event) => {
    if (!isTouch(event)) return;
    const [shown, over] = [looked, document.elementFromPoint(event.clientX, event.clientY)];
    stop();
    if (!shown) return;
    taken = event.timeStamp;
    if (over && button.contains(over)) act.take();
  });
  button.addEventListener('contextmenu', (event) => looked && event.preventDefault());
  button.addEventListener('focus', () => button.matches(':focus-visible') && soon(0));
  button.addEventListener('blur', stop);
  button.addEventListener(
    'click',
    (event) => {
      if (event.timeStamp - taken < kSamePress) event.stopImmediatePropagation();
      stop();
    },
    true,
  );
}
