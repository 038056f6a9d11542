// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { ChipDrag } from './chip_drag';

let chips: HTMLElement[];
let dropped: [number, number][];
let drag: ChipDrag;

beforeEach(() => {
  dropped = [];
  chips = [4, 9].map((id) => Object.assign(document.createElement('button'), { className: 'chip', id: String(id) }));
  document.body.replaceChildren(...chips);
  drag = new ChipDrag(
    (chip) => Number(chip.id),
    (into, from) => dropped.push([into, from]),
  );
  chips.forEach((chip) => drag.watch(chip, Number(chip.id)));
  for (const chip of chips) chip.setPointerCapture = () => undefined;
  // The first chip takes 100 px, the second the next.
  document.elementsFromPoint = (x: number) => (x < 100 ? [chips[0]!] : x < 200 ? [chips[1]!] : []);
});

function point(type: string, x: number): void {
  const event = Object.assign(new Event(type, { bubbles: true }), { pointerId: 1, button: 0, clientX: x, clientY: 5 });
  chips[1]!.dispatchEvent(event);
}

it('joins the group of the chip that it is dropped on', () => {
  point('pointerdown', 150);
  point('pointermove', 50);
  expect(chips[0]!.classList.contains('drop-target')).toBe(true);
  point('pointerup', 50);
  expect(dropped).toEqual([[4, 9]]);
  expect(chips[0]!.classList.contains('drop-target')).toBe(false);
  expect(drag.consumeClick()).toBe(true);
  expect(drag.consumeClick()).toBe(false);
});

it('does nothing where it is dropped beside, taken away or only pressed', () => {
  point('pointerdown', 150);
  point('pointermove', 300);
  point('pointerup', 300);
  point('pointerdown', 150);
  point('pointermove', 50);
  point('pointercancel', 50);
  point('pointerdown', 150);
  point('pointermove', 153);
  point('pointerup', 153);
  expect(dropped).toEqual([]);
  expect(drag.consumeClick()).toBe(false);
});
