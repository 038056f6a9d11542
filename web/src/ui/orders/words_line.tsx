// The line for words: a text field with what may come next, and below it what each group would do.

import { render } from 'preact';
import type { Said } from '../../protocol/messages';
import { toolButton } from '../widgets/buttons';
import { element } from '../widgets/dom';

export interface WordsActions {
  typed(text: string): void;
  say(text: string): void;
  leave(): void;
}

type Answer = Pick<Said, 'sentences' | 'problem' | 'completions'>;

const kNothing: Answer = { sentences: '', problem: '', completions: [] };
const kExample = 'Half of North to the fountain in a ring, the rest hold';
const kList = 'words-list';

export class WordsLine {
  readonly root = element('section', { class: 'words panel', 'aria-label': 'Directing by words' });
  private field_: HTMLInputElement | null = null;
  private text_ = '';
  private answer_: Answer = kNothing;
  /** What was done last, until somebody types again. */
  private done_ = '';
  /** The completion that arrow keys have chosen; -1 for none. */
  private active_ = -1;

  constructor(private readonly actions_: WordsActions) {
    this.root.hidden = true;
  }

  setOpen(open: boolean): void {
    this.root.hidden = !open;
    this.active_ = -1;
    this.draw();
    if (!open) return;
    this.field_?.focus({ preventScroll: true });
    this.field_?.select();
  }

  /** What the sentence would do. */
  show(answer: Answer): void {
    this.answer_ = answer;
    this.active_ = Math.min(this.active_, answer.completions.length - 1);
    this.draw();
  }

  /** It was done, or could not be. */
  done({ sentences, problem }: Answer): void {
    this.answer_ = { ...kNothing, problem };
    this.active_ = -1;
    if (!problem) [this.text_, this.done_] = ['', sentences];
    this.draw();
  }

  private type(text: string): void {
    [this.text_, this.done_, this.active_] = [text, '', -1];
    this.draw();
    this.actions_.typed(text);
  }

  private complete(index: number): void {
    const completion = this.answer_.completions[index];
    if (!completion) return;
    this.type(completion.whole);
    this.field_?.focus({ preventScroll: true });
  }

  private say(): void {
    if (this.text_.trim()) this.actions_.say(this.text_);
  }

  private readonly pressed = (event: KeyboardEvent): void => {
    event.stopPropagation();
    const { completions } = this.answer_;
    const step = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
    if (event.key === 'Escape') this.actions_.leave();
    else if (event.key === 'Enter' && this.active_ >= 0) this.complete(this.active_);
    else if (event.key === 'Enter') this.say();
    else if (step !== 0 && completions.length > 0) {
      // Above the first and below the last is the text itself.
      const places = completions.length + 1;
      this.active_ = ((this.active_ + 1 + step + places) % places) - 1;
      this.draw();
    } else return;
    event.preventDefault();
  };

  private draw(): void {
    const { completions, sentences, problem } = this.answer_;
    const text = problem || sentences || this.done_;
    const shown = this.text_ || !this.done_ ? completions : [];
    render(
      <>
        <div class="words-row">
          <input
            ref={(made) => void (this.field_ = made)}
            type="text"
            role="combobox"
            aria-label="What are they to do?"
            aria-autocomplete="list"
            aria-controls={kList}
            aria-expanded={shown.length > 0}
            aria-activedescendant={this.active_ >= 0 ? `${kList}-${this.active_}` : undefined}
            aria-describedby="words-said"
            autocomplete="off"
            autocapitalize="off"
            spellcheck={false}
            enterkeyhint="go"
            maxLength={500}
            placeholder={kExample}
            value={this.text_}
            onInput={(event) => this.type(event.currentTarget.value)}
            onKeyDown={this.pressed}
          />
          {toolButton('resume', 'Do it', () => this.say(), {
            iconOnly: true,
            shortcut: 'Enter',
            disabled: !this.text_.trim(),
          })}
          {toolButton('close', 'Leave words', () => this.actions_.leave(), { iconOnly: true, shortcut: 'Esc' })}
        </div>
        <ul id={kList} role="listbox" aria-label="What may come next" hidden={shown.length === 0}>
          {shown.map(({ words }, k) => (
            <li
              key={words}
              id={`${kList}-${k}`}
              role="option"
              aria-selected={k === this.active_}
              onMouseDown={(event) => event.preventDefault()}
              onClick={() => this.complete(k)}
            >
              {words}
            </li>
          ))}
        </ul>
        <p id="words-said" role="status" class={problem ? 'words-problem' : ''} hidden={!text}>
          {text}
        </p>
      </>,
      this.root,
    );
  }
}
