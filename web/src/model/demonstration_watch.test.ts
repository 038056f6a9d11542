import { expect, it } from 'vitest';
import { DemonstrationWatch } from './demonstration_watch';

it('speaks when a demonstration begins and when it ends, once', () => {
  const watch = new DemonstrationWatch();
  const said = [false, true, true, false, false, true].map((running) => watch.observe(running));
  expect(said).toEqual([
    null,
    'A demonstration is running',
    null,
    'The demonstration has ended',
    null,
    'A demonstration is running',
  ]);
});
