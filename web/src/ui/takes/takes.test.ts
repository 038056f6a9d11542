import { afterEach, describe, expect, it, vi } from 'vitest';
import { openTake, takeName } from './takes';

afterEach(() => vi.unstubAllGlobals());

it('names takes after scenario and time', () => {
  expect(takeName('Three paths!', new Date(Date.UTC(2026, 10, 21, 5, 30, 7)))).toBe(
    'three-paths-2026-11-21-05-30-07.take',
  );
  expect(takeName('', new Date(0))).toMatch(/^take-1970/);
});

describe('openTake', () => {
  const file = new File(['x'], 'mine.take');
  it('tells why a file was refused', async () => {
    vi.stubGlobal('fetch', async () => new Response('the checksum of record 3 is wrong', { status: 400 }));
    expect(await openTake(file)).toBe('“mine.take” could not be opened: the checksum of record 3 is wrong.');
  });
  it('says nothing where it worked, and that the server is away where it is', async () => {
    const asked: string[] = [];
    vi.stubGlobal('fetch', async (path: string) => {
      asked.push(path);
      return new Response('{"name":"mine-2.take"}', { status: 200 });
    });
    expect(await openTake(file)).toBeNull();
    expect(asked).toEqual(['takes', 'takes/mine-2.take/open']);
    vi.stubGlobal('fetch', async () => Promise.reject(new TypeError('failed')));
    expect(await openTake(file)).toContain('does not answer');
  });
});
