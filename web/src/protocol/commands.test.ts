import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { ByteReader, ByteWriter } from './bytes';
import { kCommandLayouts } from './generated/command_layouts';
import type { Command } from './generated/commands';
import { codecs, encodeClient, filled, sizeOf } from './encoding';

/** Random commands of every kind, which the tests in C++ keep fresh (tests/studio/session/commands_test.cpp). */
function golden(): Uint8Array {
  return readFileSync(fileURLToPath(new URL('../../../tests/golden/commands.bin', import.meta.url)));
}

it('commands of every kind have the bytes that the engine gives them', () => {
  const bytes = golden();
  const reader = new ByteReader(
    bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer,
  );
  const codec = codecs.of('Command');
  const seen = new Map<string, number>();
  const w = new ByteWriter();
  while (reader.left > 0) {
    const command = codec.read(reader) as Command;
    seen.set(command.kind, (seen.get(command.kind) ?? 0) + 1);
    codec.write(w, command);
  }
  expect([...seen]).toEqual(kCommandLayouts.map(([kind]) => [kind, 4]));
  expect(Buffer.from(w.bytes()).equals(Buffer.from(bytes))).toBe(true);
});

it('what a command leaves out is as the declarations say', () => {
  const codec = codecs.of('Command');
  const w = new ByteWriter();
  codec.write(w, { kind: 'putThing', obstacle: { centre: [1, 2], radius: 3 } });
  expect(codec.read(new ByteReader(w.bytes()))).toEqual({
    kind: 'putThing',
    id: 0,
    obstacle: {
      name: '',
      polygon: [],
      centre: [1, 2],
      radius: 3,
      path: { waypoints: [], loop: false },
      range: -1,
      strength: -1,
      height: 3,
    },
    patch: null,
    item: null,
    checkpoint: null,
    area: null,
    group: 0,
  });
  expect(filled('Conduct', { squeeze: 0.5 })).toEqual({ stance: 'normal', cohesion: 0, squeeze: 0.5, avoids: false });
  expect(filled('GroupDef', {})).toMatchObject({
    name: 'Group',
    count: 36,
    colour: null,
    formation: { kind: 'square' },
  });
});

it('a message has the commands one after the other, and their length', () => {
  const commands: Command[] = [
    { kind: 'removeThing', thing: 'item', id: 7 },
    { kind: 'changeGroup', group: 1, name: 'Zoë' },
  ];
  const size = commands.reduce((sum, command) => sum + sizeOf('Command', command), 0);
  expect(encodeClient({ type: 'Commands', commands }).byteLength).toBe(1 + 4 + size);
});
