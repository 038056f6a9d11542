import { describe, expect, it } from 'vitest';
import { InputKind, PointerButton, PointerDevice, TouchPhase, type ClientMessage } from '../protocol/messages';
import type { Contact } from './contact';
import { isKeyOf, keyNumber, RawInputs } from './raw_inputs';

const kContact: Contact = {
  pointer: 7,
  kind: 'mouse',
  screen: { x: 10, y: 20 },
  ground: { x: 0, y: 0 },
  time: 5,
  button: 2,
  shift: true,
  alt: true,
  control: true,
};

function setUp() {
  const sent: ClientMessage[] = [];
  let now = 0;
  const seen = { matrix: [1, 0, 0, 0, 1, 0, 0, 0, 1], width: 800, height: 600 };
  const inputs = new RawInputs(
    { send: (message) => sent.push(message) },
    () => seen,
    undefined,
    () => now,
  );
  return { inputs, sent, seen, pass: (ms: number) => (now += ms) };
}

describe('RawInputs', () => {
  it('tells the view once, and again when it changes', () => {
    const { inputs, sent, seen } = setUp();
    inputs.begin(kContact);
    inputs.end(kContact, false);
    expect(sent.map(({ type }) => type)).toEqual(['SetView', 'Inputs', 'Inputs']);
    seen.width = 900;
    inputs.begin(kContact);
    expect(sent.map(({ type }) => type).slice(3)).toEqual(['SetView', 'Inputs']);
    inputs.forget();
    inputs.look();
    inputs.look();
    expect(sent.slice(5).map(({ type }) => type)).toEqual(['SetView']);
  });

  it('keeps the button that went down, and parts Ctrl from Alt', () => {
    const { inputs, sent } = setUp();
    inputs.begin(kContact);
    inputs.move([{ ...kContact, button: -1, alt: true, control: false }]);
    inputs.flush();
    const events = sent.flatMap((message) => (message.type === 'Inputs' ? message.events : []));
    expect(events.map(({ phase, button }) => [phase, button])).toEqual([
      [TouchPhase.Down, PointerButton.Right],
      [TouchPhase.Move, PointerButton.Right],
    ]);
    expect(events[0]).toMatchObject({ kind: InputKind.Pointer, device: PointerDevice.Mouse, pointer: 7, x: 10, y: 20 });
    expect(events.map(({ shift, control, alt }) => [shift, control, alt])).toEqual([
      [true, true, false],
      [true, false, true],
    ]);
  });

  it('gathers moves, but never holds a press or a lift back', () => {
    const { inputs, sent, pass } = setUp();
    inputs.begin(kContact);
    inputs.move([kContact]);
    expect(sent).toHaveLength(2);
    pass(20);
    inputs.move([kContact]);
    expect(sent).toHaveLength(3);
    inputs.move([kContact]);
    inputs.end(kContact, true);
    const last = sent[3]!;
    expect(last.type === 'Inputs' && last.events.map(({ phase }) => phase)).toEqual([
      TouchPhase.Move,
      TouchPhase.Cancel,
    ]);
  });
});

it('leaves keys to the page that a scheme does not know', () => {
  const key = (name: string, code: string, ctrlKey = false) => ({ key: name, code, ctrlKey, metaKey: false });
  expect(isKeyOf('mouse-full-free', key('a', 'KeyA', true))).toBe(true);
  expect(isKeyOf('mouse-full-free', key('a', 'KeyA'))).toBe(false);
  expect(isKeyOf('mouse-full-free', key('2', 'Digit2'))).toBe(true);
  expect(isKeyOf('mouse-paper', key('2', 'Digit2'))).toBe(false);
  expect(isKeyOf('mouse-mesh', key('p', 'KeyP'))).toBe(true);
  expect(isKeyOf('touch', key('Escape', 'Escape'))).toBe(false);
});

it('numbers the keys that schemes know', () => {
  expect(keyNumber({ key: '!', code: 'Digit1' })).toBe('1'.charCodeAt(0));
  expect(keyNumber({ key: 'a', code: 'KeyA' })).toBe('A'.charCodeAt(0));
  expect(keyNumber({ key: 'Escape', code: 'Escape' })).toBe(27);
  expect(keyNumber({ key: 'Delete', code: 'Delete' })).toBe(127);
  expect(keyNumber({ key: 'Tab', code: 'Tab' })).toBe(0);
});
