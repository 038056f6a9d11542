// One question of a form as fields.

import { QuestionKind, type AnswerFrame, type QuestionFrame } from '../../protocol/messages';
import { element, setText } from '../widgets/dom';
import { pixelField } from './pixel_field';

/** A question on the page. */
export interface Field {
  readonly root: HTMLElement;
  /** Null where nothing is answered yet, or nothing sound. */
  answer(): AnswerFrame | null;
  /** Says what is missing; an empty text takes that away. */
  complain(text: string): void;
  /** Brings it into view. */
  focus(): void;
}

/** Scales with more marks write numbers on every second one only. */
const kManyMarks = 11;

/** The marks of a scale, from its low end. */
export function marksOf({ low, high, step }: Pick<QuestionFrame, 'low' | 'high' | 'step'>): number[] {
  const count = Math.round((high - low) / step) + 1;
  return Array.from({ length: count }, (_, i) => low + i * step);
}

function numberAnswer(name: string, value: number): AnswerFrame {
  return { name, text: String(value), number: value };
}

/** A question that several buttons answer. */
abstract class GroupField implements Field {
  readonly root: HTMLFieldSetElement;
  private readonly error_ = element('p', { class: 'study-error', role: 'alert', hidden: true });

  constructor(
    protected readonly question: QuestionFrame,
    legend: string,
    body: HTMLElement,
  ) {
    this.root = element(
      'fieldset',
      { class: 'study-field' },
      element('legend', { class: question.text === '' ? 'unseen' : undefined }, legend),
      body,
      this.error_,
    );
  }

  complain(text: string): void {
    this.error_.hidden = text === '';
    setText(this.error_, text);
    this.root.toggleAttribute('data-missing', text !== '');
  }

  focus(): void {
    this.root.querySelector<HTMLInputElement>('input')?.focus();
  }

  abstract answer(): AnswerFrame | null;

  protected get checked(): HTMLInputElement | null {
    return this.root.querySelector<HTMLInputElement>('input:checked');
  }
}

class ScaleField extends GroupField {
  constructor(question: QuestionFrame) {
    const { name, lowLabel, highLabel, text } = question;
    const marks = marksOf(question);
    const many = marks.length > kManyMarks;
    const radios = marks.map((mark, i) => {
      const ends = i === 0 ? `, ${lowLabel}` : i === marks.length - 1 ? `, ${highLabel}` : '';
      const input = element('input', { type: 'radio', name, value: mark, 'aria-label': `${mark}${ends}` });
      const shown = !many || i % 2 === 0;
      return element(
        'label',
        { class: 'study-mark' },
        input,
        element('span', { class: 'study-number', 'aria-hidden': 'true' }, shown ? String(mark) : ''),
      );
    });
    const row = element('div', { class: many ? 'study-marks many' : 'study-marks' }, ...radios);
    row.style.setProperty('--marks', String(marks.length));
    const poles = element(
      'div',
      { class: 'study-poles', 'aria-hidden': 'true' },
      element('span', {}, lowLabel),
      element('span', {}, highLabel),
    );
    super(question, text === '' ? `${lowLabel} or ${highLabel}` : text, element('div', {}, row, poles));
  }

  answer(): AnswerFrame | null {
    return this.checked && numberAnswer(this.question.name, Number(this.checked.value));
  }
}

class ChoiceField extends GroupField {
  constructor(question: QuestionFrame) {
    const { name, text, choices } = question;
    // A single choice is a box to tick, and its words are the question's.
    const single = choices.length === 1;
    const rows = choices.map((choice) =>
      element(
        'label',
        { class: 'study-choice' },
        element('input', { type: single ? 'checkbox' : 'radio', name, value: choice.text }),
        single ? text : choice.text,
      ),
    );
    super({ ...question, text: single ? '' : text }, text, element('div', { class: 'study-choices' }, ...rows));
  }

  answer(): AnswerFrame | null {
    return this.checked && { name: this.question.name, text: this.checked.value, number: NaN };
  }
}

/** One box to write in. */
class WrittenField implements Field {
  readonly root: HTMLElement;
  private readonly error_ = element('p', { class: 'study-error', role: 'alert', hidden: true });

  constructor(
    private readonly question_: QuestionFrame,
    private readonly input_: HTMLInputElement | HTMLTextAreaElement,
  ) {
    const optional = question_.needed ? '' : ' (you may leave this out)';
    const label = element('label', { for: input_.id }, question_.text + optional);
    this.root = element('div', { class: 'study-field' }, label, input_, this.error_);
  }

  answer(): AnswerFrame | null {
    const { name, kind, low, high } = this.question_;
    const text = this.input_.value.trim();
    if (text === '') return null;
    if (kind === QuestionKind.Text) return { name, text, number: NaN };
    const value = Number(text.replace(',', '.'));
    return Number.isFinite(value) && value >= low && value <= high ? numberAnswer(name, value) : null;
  }

  complain(text: string): void {
    this.error_.hidden = text === '';
    setText(this.error_, text);
    this.root.toggleAttribute('data-missing', text !== '');
  }

  focus(): void {
    this.input_.focus();
  }
}

/** What is asked for where an answer is missing. */
export function missingText({
  kind,
  low,
  high,
  choices,
}: Pick<QuestionFrame, 'kind' | 'low' | 'high' | 'choices'>): string {
  if (choices.length === 1) return 'Please tick this box to go on. Who does not agree closes the page.';
  if (kind === QuestionKind.Number) return `Please write a number from ${low} to ${high}.`;
  return kind === QuestionKind.Text ? 'Please write something.' : 'Please choose one of the answers.';
}

export function fieldOf(question: QuestionFrame): Field {
  const id = `study-${question.name}`;
  if (question.kind === QuestionKind.Scale) return new ScaleField(question);
  if (question.kind === QuestionKind.Choice) return new ChoiceField(question);
  if (question.name === 'mm-per-pixel') return pixelField(question);
  if (question.kind === QuestionKind.Text)
    return new WrittenField(question, element('textarea', { id, rows: 4, maxlength: 600 }));
  return new WrittenField(question, element('input', { id, type: 'text', inputmode: 'decimal', autocomplete: 'off' }));
}
