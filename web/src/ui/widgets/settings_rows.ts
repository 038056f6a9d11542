// Rows of settings: one of a few words, a switch, a dial from 0 to 1.

import { element, setPressed, setText } from './dom';

export interface Row<Value> {
  readonly root: HTMLElement;
  show(value: Value): void;
}

function capital(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

/** One of a few words, side by side. */
export function choiceRow<Word extends string>(
  title: string,
  words: readonly Word[],
  tips: readonly string[],
  act: (word: Word) => void,
): Row<Word> {
  const buttons = words.map((word, i) => {
    const button = element('button', { type: 'button', 'aria-pressed': 'false', 'data-tip': tips[i] }, capital(word));
    button.addEventListener('click', () => act(word));
    return button;
  });
  const list = element('div', { class: 'segments', role: 'group', 'aria-label': title }, ...buttons);
  const root = element('div', { class: 'setting' }, element('span', { class: 'setting-title' }, title), list);
  return {
    root,
    show: (value) => words.forEach((word, i) => setPressed(buttons[i]!, word === value)),
  };
}

/** On or off. */
export function switchRow(title: string, tip: string, act: (on: boolean) => void): Row<boolean> {
  const button = element(
    'button',
    { type: 'button', class: 'switch', role: 'switch', 'aria-checked': 'false', 'data-tip': tip },
    title,
    element('span', { class: 'switch-knob', 'aria-hidden': 'true' }),
  );
  button.addEventListener('click', () => act(button.getAttribute('aria-checked') !== 'true'));
  return { root: button, show: (on) => button.setAttribute('aria-checked', String(on)) };
}

/** A slider from 0 to 1 in twentieths; `ends`: what its ends mean. It acts when it is let go. */
export function dial(title: string, ends: readonly [string, string], act: (value: number) => void): Row<number> {
  const input = element('input', { type: 'range', min: 0, max: 100, step: 5, 'aria-label': title });
  const figure = element('span', { class: 'dial-figure' });
  const say = (): void => setText(figure, `${input.value} %`);
  input.addEventListener('input', say);
  input.addEventListener('change', () => act(Number(input.value) / 100));
  const root = element(
    'div',
    { class: 'setting dial' },
    element('span', { class: 'setting-title' }, title),
    figure,
    input,
    element('span', { class: 'dial-ends secondary' }, element('span', {}, ends[0]), element('span', {}, ends[1])),
  );
  return {
    root,
    show: (value) => {
      if (document.activeElement === input && input.matches(':active')) return;
      input.value = String(Math.round(value * 100));
      say();
    },
  };
}
