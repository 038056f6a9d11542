import { expect, it } from 'vitest';
import { decodeClient, encodeClient } from './encoding';
import type { ClientMessage } from './messages';

it('writes messages that outgrow the first buffer at any field', () => {
  for (let count = 0; count < 40; ++count) {
    const events = Array.from({ length: count }, (_, i) => ({
      phase: 1 as const,
      touch: i,
      x: i / 2,
      y: -i,
      time: 1e9 + i,
      group: 3,
    }));
    const message: ClientMessage = { type: 'Touches', events };
    expect(decodeClient(encodeClient(message))).toEqual(message);
  }
});
