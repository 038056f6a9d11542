// Rows of settings: one of a few words, a switch, a dial from 0 to 1.

import { Component, type VNode } from 'preact';

function capital(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

export interface ChoiceRowProps<Word extends string> {
  readonly title: string;
  readonly words: readonly Word[];
  /** A sentence for each word. */
  readonly tips: readonly string[];
  readonly value: Word;
  readonly act: (word: Word) => void;
}

/** One of a few words, side by side. */
export function ChoiceRow<Word extends string>({ title, words, tips, value, act }: ChoiceRowProps<Word>): VNode {
  return (
    <div class="setting">
      <span class="setting-title">{title}</span>
      <div class="segments" role="group" aria-label={title}>
        {words.map((word, i) => (
          <button
            key={word}
            type="button"
            aria-pressed={word === value}
            data-tip={tips[i]}
            aria-description={tips[i]}
            onClick={() => act(word)}
          >
            {capital(word)}
          </button>
        ))}
      </div>
    </div>
  );
}

export interface SwitchRowProps {
  readonly title: string;
  readonly tip: string;
  readonly on: boolean;
  readonly act: (on: boolean) => void;
}

export function SwitchRow({ title, tip, on, act }: SwitchRowProps): VNode {
  return (
    <button
      type="button"
      class="switch"
      role="switch"
      aria-checked={on}
      data-tip={tip}
      aria-description={tip}
      onClick={() => act(!on)}
    >
      {title}
      <span class="switch-knob" aria-hidden="true" />
    </button>
  );
}

export interface DialProps {
  readonly title: string;
  readonly tip: string;
  /** What its ends mean. */
  readonly ends: readonly [string, string];
  readonly value: number;
  readonly act: (value: number) => void;
}

/** A slider from 0 to 1 in twentieths. It acts when it is let go, and keeps its place until then. */
export class Dial extends Component<DialProps> {
  private input_: HTMLInputElement | null = null;
  private figure_: HTMLElement | null = null;

  override componentDidMount(): void {
    this.show();
  }

  override componentDidUpdate(): void {
    this.show();
  }

  private show(): void {
    const input = this.input_!;
    if (document.activeElement === input && input.matches(':active')) return;
    input.value = String(Math.round(this.props.value * 100));
    this.say();
  }

  private readonly say = (): void => {
    this.figure_!.textContent = `${this.input_!.value} %`;
  };

  override render({ title, tip, ends, act }: DialProps): VNode {
    return (
      <div class="setting dial" data-tip={tip}>
        <span class="setting-title">{title}</span>
        <span class="dial-figure" ref={(made) => void (this.figure_ = made)} />
        <input
          type="range"
          min={0}
          max={100}
          step={5}
          aria-label={title}
          aria-description={tip}
          ref={(made) => void (this.input_ = made)}
          onInput={this.say}
          onChange={({ currentTarget }) => act(Number(currentTarget.value) / 100)}
        />
        <span class="dial-ends secondary">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </span>
      </div>
    );
  }
}
