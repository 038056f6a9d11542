// Fields in which numbers and words are typed.

import { Component, type VNode } from 'preact';

export interface NumberRange {
  readonly min: number;
  readonly max: number;
  readonly unit?: string;
  readonly whole?: boolean;
}

interface TypedProps {
  readonly label: string;
  /** For readers of the screen, where several have the same label. */
  readonly name?: string | undefined;
  readonly text: string;
  readonly placeholder?: string | undefined;
  readonly number?: boolean;
  /** False where what was typed is refused: what was there comes back. */
  readonly act: (typed: string) => boolean;
}

/** Enter and Escape end typing; Escape gives up what was typed. Keys are those of the page then. */
function typed(event: KeyboardEvent, before: string): void {
  if (event.key !== 'Enter' && event.key !== 'Escape') return;
  event.stopPropagation();
  const input = event.currentTarget as HTMLInputElement;
  if (event.key === 'Escape') input.value = before;
  input.blur();
}

class Typed extends Component<TypedProps> {
  private input_: HTMLInputElement | null = null;

  /** What is being typed stays. */
  override shouldComponentUpdate({ text, label }: TypedProps): boolean {
    return text !== this.props.text || label !== this.props.label || document.activeElement !== this.input_;
  }

  override render({ label, name, text, placeholder, number }: TypedProps): VNode {
    const kind = number
      ? ({ type: 'number', step: 'any', inputMode: 'decimal' } as const)
      : ({ type: 'text', maxLength: 80 } as const);
    return (
      <label class="build-field">
        {label && <span>{label}</span>}
        <input
          ref={(made) => void (this.input_ = made)}
          {...kind}
          autoComplete="off"
          aria-label={name}
          placeholder={placeholder}
          value={text}
          onKeyDown={(event) => typed(event, this.props.text)}
          onChange={({ currentTarget }) => {
            if (!this.props.act(currentTarget.value)) currentTarget.value = this.props.text;
          }}
        />
      </label>
    );
  }
}

export interface NumberFieldProps {
  readonly label: string;
  readonly name?: string | undefined;
  /** NaN where there is none. */
  readonly value: number;
  readonly range: NumberRange;
  readonly placeholder?: string | undefined;
  /** Gets numbers of the range; false refuses one. */
  readonly act: (value: number) => boolean | void;
}

const textOf = (value: number): string => (Number.isFinite(value) ? String(Math.round(value * 1000) / 1000) : '');

export function NumberField({ label, value, range, act, ...more }: NumberFieldProps): VNode {
  const { min, max, unit, whole } = range;
  const change = (text: string): boolean => {
    const number = whole ? Math.round(Number(text)) : Number(text);
    if (text.trim() === '' || !(number >= min && number <= max)) return false;
    return text === textOf(value) || act(number) !== false;
  };
  return <Typed label={unit ? `${label} [${unit}]` : label} text={textOf(value)} number act={change} {...more} />;
}

/** A row of a form: a number of a range. `name`: for readers of the screen, where several have the same label. */
export function numberField(
  label: string,
  value: number,
  range: NumberRange,
  act: NumberFieldProps['act'],
  name?: string,
): VNode {
  return <NumberField label={label} name={name} value={value} range={range} act={act} />;
}

export interface TextFieldProps {
  readonly label: string;
  readonly name?: string;
  readonly value: string;
  readonly act: (value: string) => void;
}

export function TextField({ label, name, value, act }: TextFieldProps): VNode {
  return <Typed label={label} name={name} text={value} act={(text) => (act(text.trim()), true)} />;
}

/** A row of a form: one of a few words. */
export function selectField(
  label: string,
  words: readonly string[],
  value: string,
  act: (word: string) => void,
  name = label,
): VNode {
  const known = words.includes(value) || value === '' ? words : [value, ...words];
  return (
    <label class="build-field">
      <span>{label}</span>
      <select aria-label={name} value={value} onChange={({ currentTarget }) => act(currentTarget.value)}>
        {known.map((word) => (
          <option key={word} value={word}>
            {word}
          </option>
        ))}
      </select>
    </label>
  );
}

export interface SliderRange extends NumberRange {
  /** The part that the slider covers; more can be typed. */
  readonly from: number;
  readonly to: number;
  readonly step: number;
}

export interface SliderFieldProps {
  readonly label: string;
  /** Null where several have different ones. */
  readonly value: number | null;
  readonly range: SliderRange;
  readonly typed: (value: number) => void;
  /** It is being dragged, and let go. */
  readonly begins: () => void;
  readonly drags: (value: number) => void;
  readonly ends: (value: number) => void;
}

/** A slider beside a field; while it is dragged it shows what is under the finger. */
export class SliderField extends Component<SliderFieldProps> {
  private held_: number | null = null;

  private readonly drag = ({
    currentTarget: { valueAsNumber },
  }: {
    readonly currentTarget: HTMLInputElement;
  }): void => {
    if (this.held_ === null) this.props.begins();
    this.held_ = valueAsNumber;
    this.forceUpdate();
    this.props.drags(valueAsNumber);
  };

  private readonly end = ({ currentTarget }: { readonly currentTarget: HTMLInputElement }): void => {
    if (this.held_ === null) return;
    this.held_ = null;
    this.props.ends(currentTarget.valueAsNumber);
  };

  override render({ label, value, range, typed: act }: SliderFieldProps): VNode {
    const { from, to, step, unit = '' } = range;
    const shown = this.held_ ?? value;
    return (
      <div class="build-slider">
        <NumberField
          label={label}
          value={shown ?? NaN}
          range={range}
          placeholder={shown === null ? 'Mixed' : undefined}
          act={act}
        />
        <input
          type="range"
          min={from}
          max={to}
          step={step}
          value={shown ?? from}
          aria-label={`${label}, slider`}
          aria-valuetext={shown === null ? 'Mixed' : `${textOf(shown)} ${unit}`}
          onInput={this.drag}
          onChange={this.end}
          onBlur={this.end}
        />
      </div>
    );
  }
}
