// @vitest-environment jsdom
import { afterEach, expect, it, vi } from 'vitest';
import { StudioStore } from '../../model/studio_store';
import { LazyCursor, type CursorParts } from './lazy_cursor';

const soon = (): Promise<void> => new Promise((done) => setTimeout(done, 20));
const pressed = vi.fn();
let reaches = false;

vi.mock('../../model/spot_words', () => ({ spotWords: () => '' }));
vi.mock('../../tools/ground_cursor', () => ({
  // One that cannot be made stands for a file that did not come.
  GroundCursor: function () {
    if (!reaches) throw new Error('no server');
    return { press: pressed };
  },
}));
afterEach(() => vi.clearAllMocks());

it('loads the cursor once more after a load that failed, and says so meanwhile', async () => {
  const store = new StudioStore();
  const canvas = document.createElement('canvas');
  const cursor = new LazyCursor();
  cursor.serve({ client: { on: () => () => undefined }, store, canvas, view: {} } as unknown as CursorParts);
  store.set({ tool: 'order' });
  cursor.press(false);
  await soon();
  expect(pressed).not.toHaveBeenCalled();
  expect(store.state.notice?.text).toBe('The server does not answer: try again.');
  reaches = true;
  cursor.press(true);
  await soon();
  expect(pressed).toHaveBeenCalledWith(true);
});
