// The colour of a chosen group: its place's own, a swatch, or any other.

import { accentOf, chosenOf, numberOfColour } from '../../model/accent';
import type { Thing } from '../../model/place/things';
import { kSwatches, swatchOf } from '../../model/swatches';
import { contrast } from '../../scene/drawing/colour';
import { paletteOf } from '../../scene/drawing/palette';
import { element } from '../widgets/dom';
import { groupMark } from '../widgets/group_marks';
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

function swatchButton(choice: Choice, checked: boolean, choose: (colour: string | null) => void): HTMLButtonElement {
  const button = element('button', {
    type: 'button',
    class: 'colour-swatch',
    role: 'radio',
    'aria-checked': String(checked),
    'aria-label': choice.name,
    'data-tip': choice.name,
    tabindex: -1,
  });
  const fill = element('span', { class: 'colour-fill', style: `background: var(${choice.variable})` });
  if (choice.colour === null) fill.append('A');
  button.append(fill);
  button.addEventListener('click', () => choose(choice.colour));
  return button;
}

const kSteps: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 };

/** One of them is reached by Tab. Arrow keys go to the others; Space and Enter choose, so that going is no edit. */
function swatchRow(buttons: readonly HTMLButtonElement[]): HTMLElement {
  const chosen = buttons.find((button) => button.getAttribute('aria-checked') === 'true') ?? buttons[0];
  if (chosen) chosen.tabIndex = 0;
  const row = element(
    'div',
    { class: 'colour-swatches', role: 'radiogroup', 'aria-labelledby': 'group-colour-title' },
    ...buttons,
  );
  row.addEventListener('keydown', (event) => {
    const at = buttons.findIndex((button) => button === event.target);
    const ends: Readonly<Record<string, number>> = { Home: 0, End: buttons.length - 1 };
    const step = kSteps[event.key];
    const next = step === undefined ? ends[event.key] : (at + step + buttons.length) % buttons.length;
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    buttons.forEach((button, k) => (button.tabIndex = k === next ? 0 : -1));
    buttons[next]?.focus();
  });
  return row;
}

function ownField(chosen: string | null, choose: (colour: string) => void): HTMLElement {
  const own = chosen !== null && !swatchOf(chosen);
  const input = element('input', {
    type: 'color',
    value: (chosen ?? '#808080').toLowerCase(),
    'aria-label': 'Own colour',
  });
  // A colour that is being looked for is not an edit yet: the dialog's end is.
  input.addEventListener('change', () => choose(input.value));
  return element(
    'label',
    { class: own ? 'colour-own is-chosen' : 'colour-own' },
    input,
    element('span', {}, own ? `Own colour ${chosen}` : 'Own colour'),
  );
}

export function groupColourField(one: Thing, actions: BuildActions): HTMLElement {
  const chosen = chosenOf(one.colour);
  const choose = (colour: string | null): void => {
    if ((colour?.toUpperCase() ?? null) === chosen) return;
    actions.editGroup('Colour', ({ id }) => ({
      kind: 'changeGroup',
      group: id,
      colour: { colour: colour ? numberOfColour(colour) : null },
    }));
  };
  const title = element('span', { class: 'colour-title', id: 'group-colour-title' }, 'Colour', groupMark(one.colour));
  const row = swatchRow(choices(one).map((choice) => swatchButton(choice, choice.colour === chosen, choose)));
  const doubt = doubtAbout(chosen);
  return element(
    'div',
    { class: 'build-colour' },
    title,
    row,
    ownField(chosen, choose),
    ...(doubt ? [element('p', { class: 'colour-doubt' }, doubt)] : []),
  );
}
