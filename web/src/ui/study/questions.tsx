// Questions of a form, as fields; what is answered is read off the form.

import type { ComponentChildren, VNode } from 'preact';
import { QuestionKind, type AnswerFrame, type QuestionFrame } from '../../protocol/messages';
import { PixelField, pixelSize } from './pixel_field';

/** Scales with more marks write numbers on every second one only. */
const kManyMarks = 11;
/** The question that is answered by an outline on the screen. */
const kPixels = 'mm-per-pixel';

export interface QuestionProps {
  readonly question: QuestionFrame;
  /** What is missing; empty for nothing. */
  readonly missing: string;
}

/** The marks of a scale, from its low end. */
export function marksOf({ low, high, step }: Pick<QuestionFrame, 'low' | 'high' | 'step'>): number[] {
  const count = Math.round((high - low) / step) + 1;
  return Array.from({ length: count }, (_, i) => low + i * step);
}

/** Null where nothing is answered yet, or nothing sound. */
export function answerOf({ name, kind, low, high }: QuestionFrame, form: FormData): AnswerFrame | null {
  const given = form.get(name);
  const text = typeof given === 'string' ? given.trim() : '';
  const number = (value: number): AnswerFrame => ({ name, text: String(value), number: value });
  if (text === '') return null;
  if (name === kPixels) return number(pixelSize(Number(text)));
  if (kind === QuestionKind.Text || kind === QuestionKind.Choice) return { name, text, number: NaN };
  const value = Number(text.replace(',', '.'));
  return value >= low && value <= high ? number(value) : null;
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

function Missing({ text }: { readonly text: string }): VNode {
  return (
    <p class="study-error" role="alert" hidden={text === ''}>
      {text}
    </p>
  );
}

interface GroupProps {
  readonly legend: string;
  readonly unseen: boolean;
  readonly missing: string;
  readonly children: ComponentChildren;
}

/** A question that several buttons answer. */
function Group({ legend, unseen, missing, children }: GroupProps): VNode {
  return (
    <fieldset class="study-field" data-missing={missing ? '' : undefined}>
      <legend class={unseen ? 'unseen' : undefined}>{legend}</legend>
      {children}
      <Missing text={missing} />
    </fieldset>
  );
}

function Scale({ question, missing }: QuestionProps): VNode {
  const { name, lowLabel, highLabel, text } = question;
  const marks = marksOf(question);
  const many = marks.length > kManyMarks;
  const ends = (i: number): string => (i === 0 ? `, ${lowLabel}` : i === marks.length - 1 ? `, ${highLabel}` : '');
  return (
    <Group legend={text || `${lowLabel} or ${highLabel}`} unseen={text === ''} missing={missing}>
      <div>
        <div class={many ? 'study-marks many' : 'study-marks'} style={{ '--marks': String(marks.length) }}>
          {marks.map((mark, i) => (
            <label key={mark} class="study-mark">
              <input type="radio" name={name} value={mark} aria-label={`${mark}${ends(i)}`} />
              <span class="study-number" aria-hidden="true">
                {!many || i % 2 === 0 ? mark : ''}
              </span>
            </label>
          ))}
        </div>
        <div class="study-poles" aria-hidden="true">
          <span>{lowLabel}</span>
          <span>{highLabel}</span>
        </div>
      </div>
    </Group>
  );
}

/** A single choice is a box to tick, and its words are the question's. */
function Choice({ question: { name, text, choices }, missing }: QuestionProps): VNode {
  const single = choices.length === 1;
  return (
    <Group legend={text} unseen={single || text === ''} missing={missing}>
      <div class="study-choices">
        {choices.map((choice) => (
          <label key={choice.text} class="study-choice">
            <input type={single ? 'checkbox' : 'radio'} name={name} value={choice.text} />
            {single ? text : choice.text}
          </label>
        ))}
      </div>
    </Group>
  );
}

/** One box to write in. */
function Written({ question: { name, text, kind, needed }, missing }: QuestionProps): VNode {
  const both = { id: `study-${name}`, name };
  return (
    <div class="study-field" data-missing={missing ? '' : undefined}>
      <label for={both.id}>{text + (needed ? '' : ' (you may leave this out)')}</label>
      {kind === QuestionKind.Text ? (
        <textarea {...both} rows={4} maxLength={600} />
      ) : (
        <input {...both} type="text" inputMode="decimal" autocomplete="off" />
      )}
      <Missing text={missing} />
    </div>
  );
}

export function Question(props: QuestionProps): VNode {
  const { kind, name } = props.question;
  if (kind === QuestionKind.Scale) return <Scale {...props} />;
  if (kind === QuestionKind.Choice) return <Choice {...props} />;
  return name === kPixels ? <PixelField name={name} /> : <Written {...props} />;
}
