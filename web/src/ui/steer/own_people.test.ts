// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { OwnCharacter } from '../../scene/crowd/own_character/own_character';
import { makePlainBody } from '../../scene/crowd/bodies/plain_body';
import { OwnPeople, welcomeText } from './own_people';
import { StudioStore } from '../../model/studio_store';

const kCharacter: OwnCharacter = { body: { ...makePlainBody(), name: 'robot.glb' }, clips: [], triangles: 900 };

let store: StudioStore;
const setOwnBody = vi.fn();

beforeEach(() => {
  store = new StudioStore();
  setOwnBody.mockClear();
});

it('dresses everybody in a file and takes it off again', async () => {
  const people = new OwnPeople({ setOwnBody }, store, () => Promise.resolve(kCharacter));
  await people.open([new File(['x'], 'robot.glb')]);
  expect(setOwnBody).toHaveBeenLastCalledWith(kCharacter.body, []);
  expect(store.state.ownCharacter).toBe('robot.glb');
  expect(store.state.notice?.text).toContain('Everybody is robot.glb');
  people.reset();
  expect(setOwnBody).toHaveBeenLastCalledWith(null);
  expect(store.state.ownCharacter).toBe('');
});

it('leaves all as it was where a file will not do, and says why', async () => {
  const people = new OwnPeople({ setOwnBody }, store, () =>
    Promise.reject(new Error('cat.glb cannot be used: there is no joint for the left knee')),
  );
  await people.open([new File(['x'], 'cat.glb')]);
  await people.open([]);
  expect(setOwnBody).not.toHaveBeenCalled();
  expect(store.state.notice?.text).toBe('cat.glb cannot be used: there is no joint for the left knee.');
});

it('keeps what was asked for last, however long an earlier file takes to read', async () => {
  const done: ((character: OwnCharacter) => void)[] = [];
  const people = new OwnPeople({ setOwnBody }, store, () => new Promise((resolve) => done.push(resolve)));
  const late = people.open([new File(['x'], 'late.glb')]);
  const quick = people.open([new File(['x'], 'robot.glb')]);
  done[1]!(kCharacter);
  await quick;
  done[0]!({ ...kCharacter, body: { ...makePlainBody(), name: 'late.glb' } });
  await late;
  expect(store.state.ownCharacter).toBe('robot.glb');
  const gone = people.open([new File(['x'], 'late.glb')]);
  people.reset();
  done[2]!(kCharacter);
  await gone;
  expect(setOwnBody).toHaveBeenLastCalledWith(null);
  expect(store.state.ownCharacter).toBe('');
});

it('is there again after a reload, without a word, until it is taken off', async () => {
  let kept: readonly File[] = [];
  const copy = {
    keep: (files: readonly File[]) => Promise.resolve(void (kept = files)),
    read: () => Promise.resolve(kept),
    forget: () => Promise.resolve(void (kept = [])),
  };
  const read = vi.fn(() => Promise.resolve(kCharacter));
  await new OwnPeople({ setOwnBody }, store, read, copy).open([new File(['x'], 'robot.glb')]);
  store = new StudioStore();
  const again = new OwnPeople({ setOwnBody }, store, read, copy);
  await again.restore();
  expect(store.state.ownCharacter).toBe('robot.glb');
  expect(store.state.notice).toBeNull();
  expect(setOwnBody).toHaveBeenCalledTimes(2);
  again.reset();
  const bare = new OwnPeople({ setOwnBody }, new StudioStore(), read, copy);
  await bare.restore();
  expect(read).toHaveBeenCalledTimes(2);
});

it('keeps nothing of a file that will not do', async () => {
  const keep = vi.fn(() => Promise.resolve());
  const copy = { keep, read: () => Promise.resolve([]), forget: () => Promise.resolve() };
  await new OwnPeople({ setOwnBody }, store, () => Promise.reject(new Error('no')), copy).open([
    new File(['x'], 'x.glb'),
  ]);
  expect(keep).not.toHaveBeenCalled();
});

it('says what came with it and what it costs', () => {
  expect(welcomeText({ ...kCharacter, clips: [{ name: 'run' }, { name: 'walk' }] as never, triangles: 40000 })).toBe(
    'Everybody is robot.glb now, with run, walk of its own; with 40,000 triangles a large crowd of it will be slow.',
  );
});
