import { expect, it } from 'vitest';

const kSources = import.meta.glob<string>('/src/ui/**/*.{ts,tsx}', { query: '?raw', import: 'default', eager: true });
/** Nobody else directs a world that runs in this browser, and its links hold everything themselves. */
const kOfOthers = ['shared_controller', 'share_dialog', 'shared_link', 'shelf_link'];

/** The names of what a file loads when it is first used. */
function lazyIn(text: string): string[] {
  return [...text.matchAll(/import\('[^']*\/([^'/]+)'\)/g)].map(([, name]) => name!);
}

it('loads all that is first loaded when it is used, so that a page without its server has it', () => {
  const files = Object.entries(kSources).filter(([path]) => !/\.test\.|standby_controller/.test(path));
  const used = new Set(files.flatMap(([, text]) => lazyIn(text)));
  const loaded = lazyIn(kSources['/src/ui/app/standby_controller.ts']!);
  expect(used.size).toBeGreaterThan(10);
  expect([...used].filter((name) => !loaded.includes(name) && !kOfOthers.includes(name))).toEqual([]);
});
