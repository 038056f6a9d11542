// The colour of a chosen group: its place's own, a swatch, or any other.

import type { VNode } from 'preact';
import { accentOf, chosenOf, numberOfColour } from '../../model/accent';
import type { Thing } from '../../model/place/things';
import { kSwatches, swatchOf } from '../../model/swatches';
import { contrast } from '../../scene/drawing/colour';
import { paletteOf } from '../../scene/drawing/palette';
import { groupMark } from '../widgets/group_marks';
import { Held } from '../widgets/held';
import '../styles/group_colour.css';
import type { BuildActions } from './build_actions';

/** Contrast with the ground below which lines are hard to see. */
const kSeen = 2;

interface Choice {
  readonly name: string;
  /** `#RRGGBB`; null for the colour that the group has by its number. */
  readonly colour: string | null;
  readonly variable: string;
}

/** Says so where a colour is hard to see; empty where it is not. */
export function doubtAbout(chosen: string | null): string {
  if (!chosen || swatchOf(chosen)) return '';
  const hard = (['light', 'dark'] as const).filter((theme) => contrast(chosen, paletteOf(theme).ground) < kSeen);
  return hard.length > 0 ? `This colour is hard to see on ${hard.join(' and ')} ground.` : '';
}

function choices(one: Thing): Choice[] {
  const accent = accentOf(one.colour);
  const given = kSwatches.find(({ variable }) => variable === `--group-${accent}`)!;
  return [
    { name: `Automatic, ${given.name.toLowerCase()}`, colour: null, variable: given.variable },
    ...kSwatches.map(({ name, light, variable }) => ({ name, colour: light, variable })),
  ];
}

const kSteps: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };

/** Arrow keys go to the others; Space and Enter choose, so that going is no edit. */
function goAlong(event: KeyboardEvent): void {
  const buttons = [...(event.currentTarget as HTMLElement).querySelectorAll('button')];
  const at = buttons.findIndex((button) => button === event.target);
  const ends: Readonly<Record<string, number>> = { Home: 0, End: buttons.length - 1 };
  const step = kSteps[event.key];
  const next = step === undefined ? ends[event.key] : (at + step + buttons.length) % buttons.length;
  if (at < 0 || next === undefined) return;
  event.preventDefault();
  buttons.forEach((button, k) => (button.tabIndex = k === next ? 0 : -1));
  buttons[next]?.focus();
}

export function GroupColourField({ one, actions }: { readonly one: Thing; readonly actions: BuildActions }): VNode {
  const chosen = chosenOf(one.colour);
  const own = chosen !== null && !swatchOf(chosen);
  const choose = (colour: string | null): void => {
    if ((colour?.toUpperCase() ?? null) === chosen) return;
    actions.editGroup('Colour', ({ id }) => ({
      kind: 'changeGroup',
      group: id,
      colour: { colour: colour ? numberOfColour(colour) : null },
    }));
  };
  const all = choices(one);
  const marked = Math.max(
    0,
    all.findIndex(({ colour }) => colour === chosen),
  );
  const doubt = doubtAbout(chosen);
  return (
    <div class="build-colour">
      <span class="colour-title" id="group-colour-title">
        Colour
        <Held key={one.colour} make={() => groupMark(one.colour)} />
      </span>
      <div class="colour-swatches" role="radiogroup" aria-labelledby="group-colour-title" onKeyDown={goAlong}>
        {all.map(({ name, colour, variable }, k) => (
          <button
            key={name}
            type="button"
            class="colour-swatch"
            role="radio"
            aria-checked={colour === chosen}
            aria-label={name}
            data-tip={name}
            tabIndex={k === marked ? 0 : -1}
            onClick={() => choose(colour)}
          >
            <span class="colour-fill" style={`background: var(${variable})`}>
              {colour === null && 'A'}
            </span>
          </button>
        ))}
      </div>
      <label class={own ? 'colour-own is-chosen' : 'colour-own'}>
        {/* A colour that is being looked for is not an edit yet: the dialog's end is. */}
        <input
          type="color"
          value={(chosen ?? '#808080').toLowerCase()}
          aria-label="Own colour"
          onChange={({ currentTarget }) => choose(currentTarget.value)}
        />
        <span>{own ? `Own colour ${chosen}` : 'Own colour'}</span>
      </label>
      {doubt && <p class="colour-doubt">{doubt}</p>}
    </div>
  );
}
