import { File as NodeFile } from 'node:buffer';
import { beforeEach, expect, it, vi } from 'vitest';
import { StudioStore } from '../model/studio_store';
import { FileDesk } from './file_desk';

// Blobs of jsdom cannot be read.
const fileOf = (parts: readonly (string | Uint8Array)[], name: string): File =>
  new NodeFile(parts as never, name) as unknown as File;
const openCharacter = vi.fn();
const openTake = vi.fn();
const openPicture = vi.fn();
let store: StudioStore;
let desk: FileDesk;

beforeEach(() => {
  vi.clearAllMocks();
  store = new StudioStore();
  desk = new FileDesk(store, { openCharacter, openTake }, { openPicture });
});

it('opens takes, characters with their parts, and pictures, whatever they are called', async () => {
  const take = fileOf(['MUSTAKE\n...'], 'photo.png');
  await desk.open([take]);
  expect(openTake).toHaveBeenCalledWith(take);
  const parts = [fileOf([new Uint8Array(8)], 'body.bin'), fileOf(['{"asset": {}, "buffers": []}'], 'body.gltf')];
  await desk.open(parts);
  expect(openCharacter).toHaveBeenCalledWith(parts);
  const picture = fileOf([Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a])], 'x.take');
  await desk.open([picture]);
  expect(openPicture).toHaveBeenCalledWith(picture);
  expect(store.state.notice).toBeNull();
});

it('says in one sentence what it does not open', async () => {
  await desk.open([fileOf(['type octile\n'], 'Berlin.map')]);
  expect(store.state.notice?.text).toBe(
    '“Berlin.map” is a grid map: “muster import Berlin.map -o place.json” makes a scenario of it.',
  );
  await desk.open([fileOf([], 'nothing.take')]);
  expect(store.state.notice?.text).toBe('“nothing.take” is empty.');
  const gone = fileOf(['x'], 'gone.glb');
  gone.slice = () => {
    throw new Error('gone');
  };
  await desk.open([gone]);
  expect(store.state.notice?.text).toBe('“gone.glb” cannot be read.');
  await desk.open([]);
  expect(openTake).not.toHaveBeenCalled();
});

it('takes files that are dropped on the page', async () => {
  const page = new EventTarget();
  desk.acceptDrops(page as Window);
  const drop = Object.assign(new Event('drop', { cancelable: true }), {
    dataTransfer: { files: [fileOf(['glTF....'], 'a.glb')], types: ['Files'] },
  });
  page.dispatchEvent(drop);
  expect(drop.defaultPrevented).toBe(true);
  await vi.waitFor(() => expect(openCharacter).toHaveBeenCalledTimes(1));
});
