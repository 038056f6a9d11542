import { expect, it } from 'vitest';
import { PlaybackAction, type ClientMessage } from '../../protocol/messages';
import { Scrubber } from './scrubber';

function made(): { scrubber: Scrubber; sent: ClientMessage[]; pass: (ms: number) => void } {
  const sent: ClientMessage[] = [];
  let now = 0;
  const scrubber = new Scrubber(
    (message) => sent.push(message),
    () => now,
  );
  return { scrubber, sent, pass: (ms) => void (now += ms) };
}

it('has one request out and keeps the newest wish only', () => {
  const { scrubber, sent } = made();
  scrubber.to(10);
  scrubber.to(20);
  scrubber.to(30.4);
  expect(sent).toEqual([{ type: 'Seek', step: 10 }]);
  expect(scrubber.wished).toBe(30);
  scrubber.observe(7);
  expect(sent).toHaveLength(1);
  scrubber.observe(10);
  expect(sent).toEqual([
    { type: 'Seek', step: 10 },
    { type: 'Seek', step: 30 },
  ]);
  scrubber.observe(30);
  expect(scrubber.wished).toBeNull();
});

it('asks again where no answer comes', () => {
  const { scrubber, sent, pass } = made();
  scrubber.to(10);
  scrubber.to(20);
  pass(500);
  scrubber.observe(3);
  expect(sent.at(-1)).toEqual({ type: 'Seek', step: 20 });
});

it('pauses while a finger holds the playhead, and goes on where it played', () => {
  const { scrubber, sent } = made();
  scrubber.begin(true);
  scrubber.to(5);
  scrubber.end();
  expect(sent).toEqual([
    { type: 'Playback', action: PlaybackAction.Pause },
    { type: 'Seek', step: 5 },
    { type: 'Playback', action: PlaybackAction.Play },
  ]);
  scrubber.begin(false);
  scrubber.end();
  expect(sent).toHaveLength(3);
});
