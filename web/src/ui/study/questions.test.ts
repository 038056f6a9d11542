// @vitest-environment jsdom
import { h, render } from 'preact';
import { beforeEach, describe, expect, it } from 'vitest';
import { QuestionKind, type AnswerFrame, type QuestionFrame, type StudyForm } from '../../protocol/messages';
import { FormCard } from './cards';
import { pixelSize } from './pixel_field';
import { marksOf, missingText } from './questions';

const kQuestion: QuestionFrame = {
  name: 'q',
  text: 'How?',
  kind: QuestionKind.Scale,
  low: 1,
  high: 5,
  step: 1,
  lowLabel: 'Low',
  highLabel: 'High',
  choices: [],
  needed: true,
};

function formOf(...questions: QuestionFrame[]): StudyForm {
  return {
    type: 'StudyForm',
    instrument: 'sus',
    title: 'Usability',
    text: '',
    source: '',
    schemeTitle: 'Touch',
    questions,
  };
}

const root = document.createElement('div');
let sent: AnswerFrame[][] = [];

/** Preact draws a little later. */
const drawn = (): Promise<void> => new Promise((done) => setTimeout(done));

async function submit(): Promise<void> {
  root.firstElementChild!.dispatchEvent(new Event('submit', { cancelable: true }));
  await drawn();
}

function show(form: StudyForm, busy = false): void {
  render(h(FormCard, { form, busy, send: (answers) => sent.push(answers) }), root);
}

beforeEach(() => {
  sent = [];
  render(null, root);
  document.body.replaceChildren(root);
});

describe('a form', () => {
  it('is sent once all that is needed is answered, as a whole', async () => {
    const choice: QuestionFrame = {
      ...kQuestion,
      name: 'hand',
      kind: QuestionKind.Choice,
      choices: [{ text: 'left' }, { text: 'right' }],
    };
    const age: QuestionFrame = { ...kQuestion, name: 'age', kind: QuestionKind.Number, low: 18, high: 120 };
    const why: QuestionFrame = { ...kQuestion, name: 'why', kind: QuestionKind.Text, needed: false };
    const form = formOf(kQuestion, choice, age, why);
    show(form);
    await submit();
    expect(sent).toHaveLength(0);
    expect(root.querySelectorAll('[data-missing]')).toHaveLength(3);
    expect(document.activeElement).toBe(root.querySelector('input[name="q"]'));
    root.querySelector<HTMLInputElement>('input[name="q"][value="4"]')!.checked = true;
    root.querySelector<HTMLInputElement>('input[value="right"]')!.checked = true;
    const written = root.querySelector<HTMLInputElement>('#study-age')!;
    written.value = '17';
    await submit();
    expect(sent).toHaveLength(0);
    expect(root.querySelector('[data-missing]')!.textContent).toContain('18 to 120');
    written.value = '18,5';
    await submit();
    expect(sent).toEqual([
      [
        { name: 'q', text: '4', number: 4 },
        { name: 'hand', text: 'right', number: NaN },
        { name: 'age', text: '18.5', number: 18.5 },
      ],
    ]);
    show(form, true);
    expect(root.querySelector('button')!.disabled).toBe(true);
  });

  it('names its control, and offers nothing in advance', () => {
    show(formOf(kQuestion));
    expect(root.querySelector('h1')!.textContent).toBe('Usability – Touch');
    expect(root.querySelector('input:checked')).toBeNull();
    expect([...root.querySelectorAll('input')].map((one) => one.getAttribute('aria-label'))).toEqual([
      '1, Low',
      '2',
      '3',
      '4',
      '5, High',
    ]);
  });

  it('makes a box to tick of a single choice', async () => {
    const agree: QuestionFrame = { ...kQuestion, kind: QuestionKind.Choice, choices: [{ text: 'yes' }] };
    show(formOf(agree));
    const box = root.querySelector<HTMLInputElement>('input[type="checkbox"]')!;
    expect(box.closest('label')!.textContent).toBe('How?');
    box.checked = true;
    await submit();
    expect(sent[0]).toEqual([{ name: 'q', text: 'yes', number: NaN }]);
  });

  it('reckons the size of a pixel from a bank card', async () => {
    expect(pixelSize(204)).toBeCloseTo(0.2646, 4);
    show(formOf({ ...kQuestion, name: 'mm-per-pixel', kind: QuestionKind.Number }));
    root.querySelector<HTMLInputElement>('input[type="range"]')!.value = '270';
    await submit();
    expect(sent[0]![0]!.number).toBeCloseTo(0.1999, 4);
  });
});

it('counts the marks of scales', () => {
  expect(marksOf({ low: 0, high: 100, step: 5 })).toHaveLength(21);
  expect(marksOf({ low: 0, high: 10, step: 0.5 }).slice(-2)).toEqual([9.5, 10]);
  expect(missingText({ kind: QuestionKind.Scale, low: 1, high: 5, choices: [] })).toBe(
    'Please choose one of the answers.',
  );
});
