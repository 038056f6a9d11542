// Words as a formation, with what can be read of them before anybody moves.

import { Component, type VNode } from 'preact';
import { strokeLetters } from '../../model/letters/stroke_font';
import { peopleFor, strokeWords, type WordPlaces } from '../../model/letters/words';
import type { GroundPoint } from '../../model/plane';
import { Dialog, Field } from '../widgets/dialog';
import { PlaceDots } from '../widgets/place_dots';
import { activeGroup, Ends, inMetres, kWordGap, leave, MorePeople, type ShapeDialogProps } from './dialog_ends';
import { bestWords, missingLetter, outlinePeopleFor } from './outline_letters';

const kMostLetters = 24;

interface Written {
  readonly words: string;
  readonly count: number;
  readonly places: readonly GroundPoint[];
  readonly set: WordPlaces | null;
  /** A letter that there is no drawing of. */
  readonly missing: string | null;
  /** To be read; 0 where that is not known. */
  readonly needs: number;
}

function write(words: string, count: number): Written {
  const missing = strokeLetters(words) ? null : missingLetter(words);
  if (missing) return { words, count, missing, set: null, needs: 0, places: [] };
  const set = bestWords(words, count, strokeWords(words, count));
  const unread = words !== '' && !set?.legibility.reads;
  const needs = unread ? peopleFor(words) || outlinePeopleFor(words, count) : 0;
  return { words, count, missing, set, needs, places: set ? inMetres(set.places, set.gap, kWordGap) : [] };
}

function said({ words, count, missing, set, needs }: Written, name: string): { text: string; warns: boolean } {
  if (missing) return { text: `No font here has the letter “${missing}”.`, warns: true };
  if (words === '') return { text: `${name}: ${count} people.`, warns: false };
  if (set?.legibility.reads) return { text: `Can be read, with ${count} people.`, warns: false };
  const needed = needs > count ? `; ${needs} needed` : '';
  const text = `${set ? 'Hard to read' : 'Too few people'}: ${count} people${needed}.`;
  return { text, warns: true };
}

/** What was written last, also when the dialog opens again. */
let lastWords = '';

export class TextDialog extends Component<ShapeDialogProps> {
  private input_: HTMLInputElement | null = null;
  private written_: Written = { words: '', count: 0, places: [], set: null, missing: null, needs: 0 };

  override componentDidMount(): void {
    this.input_?.select();
    this.show();
  }

  override componentDidUpdate(): void {
    this.show();
  }

  /** Where everybody would stand lies on the ground meanwhile. */
  private shown_: readonly GroundPoint[] | null = null;
  private show(): void {
    const { places } = this.written_;
    if (this.shown_ === places) return;
    this.shown_ = places;
    this.props.shapes.lookAt(this.shape());
  }

  private shape() {
    const { places } = this.written_;
    return places.length > 0 ? this.props.shapes.asSeen(places, kWordGap) : null;
  }

  override render(props: ShapeDialogProps): VNode {
    const { state, shapes } = props;
    const group = activeGroup(state);
    const [words, count] = [lastWords.trim(), group?.count ?? 0];
    if (this.written_.words !== words || this.written_.count !== count) this.written_ = write(words, count);
    const { places, needs } = this.written_;
    const note = said(this.written_, group?.name ?? 'The group');
    const submit = (): boolean => {
      const shape = this.shape();
      if (shape) shapes.takeShape(shape, words);
      return shape !== null;
    };
    return (
      <Dialog title="Write words" close={() => leave(this.props)} submit={submit}>
        <Field label="Words">
          <input
            type="text"
            maxLength={kMostLetters}
            autocomplete="off"
            spellcheck={false}
            required
            value={lastWords}
            ref={(made) => void (this.input_ = made)}
            onInput={({ currentTarget }) => {
              lastWords = currentTarget.value;
              this.forceUpdate();
            }}
          />
        </Field>
        <PlaceDots class="shape-preview" places={places} radius={state.bodyRadius} width={340} height={110} />
        <p class={`secondary shape-note${note.warns ? ' warns' : ''}`} role="status">
          {note.text}
        </p>
        <MorePeople title={words} needs={needs} group={group} shapes={shapes} />
        <Ends {...props} title={words} dialog="text" shape={places.length > 0 ? this.shape() : null} />
      </Dialog>
    );
  }
}
