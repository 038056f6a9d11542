// Fields in which numbers and words are typed.

import { element } from '../widgets/dom';

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
  const text = (number: number): string => String(Math.round(number * 1000) / 1000);
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
