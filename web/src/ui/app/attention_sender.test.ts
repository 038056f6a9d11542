import { expect, it } from 'vitest';
import type { ClientMessage } from '../../protocol/messages';
import { AttentionSender } from './attention_sender';

it('tells moves of half a metre, four times a second at most, and all again after a loss', () => {
  const sent: ClientMessage[] = [];
  const sender = new AttentionSender({ send: (message) => void sent.push(message) });
  const look = (x: number, now: number, count = 150): number => {
    sender.consider({ x, y: 0, count }, now);
    return sent.length;
  };
  expect(look(0, 1000)).toBe(1);
  expect(look(0.3, 2000)).toBe(1);
  expect(look(3, 2000)).toBe(2);
  expect(look(6, 2100)).toBe(2);
  expect(look(6, 2260)).toBe(3);
  expect(look(6, 3000, 0)).toBe(4);
  sender.forget();
  expect(look(6, 3010, 0)).toBe(5);
  expect(sent[4]).toEqual({ type: 'Attend', x: 6, y: 0, count: 0 });
});
