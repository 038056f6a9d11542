// @vitest-environment jsdom
import { describe, expect, it } from 'vitest';
import { QuestionKind, type AnswerFrame, type QuestionFrame, type StudyForm } from '../../protocol/messages';
import { marksOf, missingText } from './fields';
import { formPage } from './form_page';
import { pixelSize } from './pixel_field';

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

function shown(form: StudyForm) {
  const sent: AnswerFrame[][] = [];
  const page = formPage(form, (answers) => sent.push(answers));
  document.body.replaceChildren(page);
  const submit = (): void => void page.dispatchEvent(new Event('submit', { cancelable: true }));
  return { page, sent, submit };
}

describe('a form', () => {
  it('is sent once all that is needed is answered, as a whole', () => {
    const choice: QuestionFrame = {
      ...kQuestion,
      name: 'hand',
      kind: QuestionKind.Choice,
      choices: [{ text: 'left' }, { text: 'right' }],
    };
    const age: QuestionFrame = { ...kQuestion, name: 'age', kind: QuestionKind.Number, low: 18, high: 120 };
    const why: QuestionFrame = { ...kQuestion, name: 'why', kind: QuestionKind.Text, needed: false };
    const { page, sent, submit } = shown(formOf(kQuestion, choice, age, why));
    submit();
    expect(sent).toHaveLength(0);
    expect(page.querySelectorAll('[data-missing]')).toHaveLength(3);
    expect(document.activeElement).toBe(page.querySelector('input[name="q"]'));
    page.querySelector<HTMLInputElement>('input[name="q"][value="4"]')!.checked = true;
    page.querySelector<HTMLInputElement>('input[value="right"]')!.checked = true;
    const written = page.querySelector<HTMLInputElement>('#study-age')!;
    written.value = '17';
    submit();
    expect(sent).toHaveLength(0);
    expect(page.querySelector('[data-missing]')!.textContent).toContain('18 to 120');
    written.value = '18,5';
    submit();
    expect(sent).toEqual([
      [
        { name: 'q', text: '4', number: 4 },
        { name: 'hand', text: 'right', number: NaN },
        { name: 'age', text: '18.5', number: 18.5 },
      ],
    ]);
    expect(page.querySelector('button')!.disabled).toBe(true);
  });

  it('names its control, and offers nothing in advance', () => {
    const { page } = shown(formOf(kQuestion));
    expect(page.querySelector('h1')!.textContent).toBe('Usability – Touch');
    expect(page.querySelector('input:checked')).toBeNull();
    expect([...page.querySelectorAll('input')].map((one) => one.getAttribute('aria-label'))).toEqual([
      '1, Low',
      '2',
      '3',
      '4',
      '5, High',
    ]);
  });

  it('makes a box to tick of a single choice', () => {
    const agree: QuestionFrame = { ...kQuestion, kind: QuestionKind.Choice, choices: [{ text: 'yes' }] };
    const { page, sent, submit } = shown(formOf(agree));
    const box = page.querySelector<HTMLInputElement>('input[type="checkbox"]')!;
    expect(box.closest('label')!.textContent).toBe('How?');
    box.checked = true;
    submit();
    expect(sent[0]).toEqual([{ name: 'q', text: 'yes', number: NaN }]);
  });

  it('reckons the size of a pixel from a bank card', () => {
    expect(pixelSize(204)).toBeCloseTo(0.2646, 4);
    const { page, sent, submit } = shown(formOf({ ...kQuestion, name: 'mm-per-pixel', kind: QuestionKind.Number }));
    page.querySelector<HTMLInputElement>('input[type="range"]')!.value = '270';
    submit();
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
