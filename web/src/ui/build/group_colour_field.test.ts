// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { colourNumber } from '../../model/accent';
import { addCommand, thing, type PlaceChange, type Thing } from '../../model/place/things';
import { fieldsPage } from './test_support';
import { accentVariable, groupMark } from '../widgets/group_marks';

const group: Thing = thing('group', { id: 4, name: 'Guests', count: 9, body: null, colour: 1 });
let sent: [string, PlaceChange][] = [];
let fields: ReturnType<typeof fieldsPage>;

const radios = (): HTMLElement[] => [...fields.root.querySelectorAll<HTMLElement>('[role="radio"]')];
const radio = (name: string): HTMLElement => radios().find((one) => one.getAttribute('aria-label') === name)!;
const marked = (): (string | null)[] =>
  radios()
    .filter((one) => one.getAttribute('aria-checked') === 'true')
    .map((one) => one.getAttribute('aria-label'));

beforeEach(() => {
  sent = [];
  const actions = {
    editGroup: (label: string, event: (one: Thing) => PlaceChange) => sent.push([label, event(group)]),
  };
  fields = fieldsPage(actions);
  fields.show([group]);
});

it('sends one edit for a swatch, none for the one that is chosen', () => {
  expect(marked()).toEqual(['Automatic, ember']);
  radio('Automatic, ember').click();
  radio('Magenta').click();
  expect(sent).toEqual([['Colour', { kind: 'changeGroup', group: 4, colour: { colour: 0xd60ea8 } }]]);
  fields.show([{ ...group, colour: colourNumber(1, '#d60ea8') }]);
  expect(marked()).toEqual(['Magenta']);
  radio('Magenta').click();
  radio('Automatic, ember').click();
  expect(sent.slice(1)).toEqual([['Colour', { kind: 'changeGroup', group: 4, colour: { colour: null } }]]);
});

it('goes along by arrow keys without an edit, and leaves the focus where it was', () => {
  const press = (key: string): boolean =>
    document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
  expect(radios().filter((one) => one.tabIndex === 0)).toEqual([radio('Automatic, ember')]);
  radio('Automatic, ember').focus();
  press('ArrowLeft');
  expect(document.activeElement).toBe(radio('Ink'));
  press('Home');
  press('ArrowRight');
  expect(document.activeElement).toBe(radio('Blue'));
  expect(radios().filter((one) => one.tabIndex === 0)).toEqual([radio('Blue')]);
  expect(sent).toEqual([]);
  fields.show([{ ...group, colour: colourNumber(1, '#1d5fd1') }]);
  expect(document.activeElement).toBe(radio('Blue'));
});

it('takes any own colour, marks it, and says where it is hard to see', () => {
  const own = fields.root.querySelector<HTMLInputElement>('input[type="color"]')!;
  own.value = '#f2e8d0';
  own.dispatchEvent(new Event('input'));
  expect(sent).toEqual([]);
  own.dispatchEvent(new Event('change'));
  expect(sent).toEqual([['Colour', { kind: 'changeGroup', group: 4, colour: { colour: 0xf2e8d0 } }]]);
  fields.show([{ ...group, colour: colourNumber(1, '#f2e8d0') }]);
  expect(marked()).toEqual([]);
  expect(fields.root.querySelector('.is-chosen')?.textContent).toBe('Own colour #F2E8D0');
  expect(fields.root.querySelector('.colour-doubt')?.textContent).toBe('This colour is hard to see on light ground.');
  fields.show([{ ...group, colour: colourNumber(1, '#d60ea8') }]);
  expect(fields.root.querySelector('.colour-doubt')).toBeNull();
});

it('keeps the shape of the mark, and lets panels see an own colour', () => {
  const yellow = colourNumber(1, '#fff000');
  const [plain, chosen] = [groupMark(1), groupMark(yellow)];
  expect(chosen.firstElementChild?.getAttribute('d')).toBe(plain.firstElementChild?.getAttribute('d'));
  expect(chosen.style.color).toBe('rgb(255, 240, 0)');
  expect(accentVariable(yellow)).not.toBe('#FFF000');
  expect(accentVariable(colourNumber(1, '#05536d'))).toBe('var(--swatch-teal)');
  expect(accentVariable(1)).toBe('var(--group-ember)');
});

it('is copied with the group', () => {
  const copy = addCommand({ ...group, rest: { colour: 0x05536d } });
  expect(copy).toMatchObject({ group: { colour: 0x05536d } });
});
