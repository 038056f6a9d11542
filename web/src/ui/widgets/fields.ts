// Fields in which numbers and words are typed.

import { element } from './dom';

export interface NumberRange {
  readonly min: number;
  readonly max: number;
  readonly unit?: string;
  readonly whole?: boolean;
}

function labelled(label: string, input: HTMLElement, unit = ''): HTMLElement {
  const name = element('span', {}, unit ? `${label} [${unit}]` : label);
  return element('label', { class: 'build-field' }, name, input);
}

/** `changed` gets what was typed, where it is a number in the range; else the old one comes back. */
export function numberField(
  label: string,
  value: number,
  { min, max, unit, whole }: NumberRange,
  changed: (value: number) => void,
): HTMLElement {
  const text = (number: number): string => (Number.isFinite(number) ? String(Math.round(number * 1000) / 1000) : '');
  const input = element('input', {
    type: 'number',
    min,
    max,
    step: whole ? 1 : 'any',
    value: text(value),
    inputmode: 'decimal',
  });
  let last = value;
  input.addEventListener('change', () => {
    const typed = whole ? Math.round(input.valueAsNumber) : input.valueAsNumber;
    const good = Number.isFinite(typed) && typed >= min && typed <= max;
    if (good && typed !== last) changed((last = typed));
    input.value = text(last);
  });
  return labelled(label, input, unit);
}

export function textField(label: string, value: string, changed: (value: string) => void): HTMLElement {
  const input = element('input', { type: 'text', maxlength: 80, value, autocomplete: 'off' });
  input.addEventListener('change', () => changed(input.value.trim()));
  return labelled(label, input);
}

export function selectField(
  label: string,
  choices: readonly string[],
  value: string,
  changed: (value: string) => void,
): HTMLElement {
  const known = choices.includes(value) || value === '' ? choices : [value, ...choices];
  const input = element(
    'select',
    {},
    ...known.map((one) => element('option', { value: one, selected: one === value }, one)),
  );
  input.addEventListener('change', () => changed(input.value));
  return labelled(label, input);
}

/** What a slider does: it is being dragged, and let go. */
export interface Dragging {
  begins(): void;
  drags(value: number): void;
  ends(value: number): void;
}

export interface SliderRange extends NumberRange {
  /** The part that the slider covers; more can be typed. */
  readonly from: number;
  readonly to: number;
  readonly step: number;
}

function listen(slider: HTMLInputElement, dragging: Dragging, show: () => void): void {
  let held = false;
  slider.addEventListener('input', () => {
    if (!held) dragging.begins();
    held = true;
    show();
    dragging.drags(slider.valueAsNumber);
  });
  const end = (): void => {
    if (!held) return;
    held = false;
    dragging.ends(slider.valueAsNumber);
  };
  slider.addEventListener('change', end);
  slider.addEventListener('blur', end);
}

/** A slider beside a field. `value`: null where several have different ones. */
export function sliderField(
  label: string,
  value: number | null,
  range: SliderRange,
  dragging: Dragging,
  changed: (value: number) => void,
): HTMLElement {
  const { from, to, step, unit = '' } = range;
  const field = numberField(label, value ?? NaN, range, changed);
  const typed = field.querySelector('input')!;
  if (value === null) typed.placeholder = 'Mixed';
  const name = `${label}, slider`;
  const slider = element('input', {
    type: 'range',
    min: from,
    max: to,
    step,
    value: value ?? from,
    'aria-label': name,
  });
  slider.setAttribute('aria-valuetext', value === null ? 'Mixed' : `${typed.value} ${unit}`);
  listen(slider, dragging, () => {
    typed.value = slider.value;
    slider.setAttribute('aria-valuetext', `${slider.value} ${unit}`);
  });
  return element('div', { class: 'build-slider' }, field, slider);
}
