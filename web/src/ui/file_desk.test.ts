import { beforeEach, expect, it, vi } from 'vitest';
import { StudioStore } from '../model/studio_store';
import { FileDesk } from './file_desk';

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
  const take = new File(['MUSTAKE\n...'], 'photo.png');
  await desk.open([take]);
  expect(openTake).toHaveBeenCalledWith(take);
  const parts = [new File([new Uint8Array(8)], 'body.bin'), new File(['{"asset": {}, "buffers": []}'], 'body.gltf')];
  await desk.open(parts);
  expect(openCharacter).toHaveBeenCalledWith(parts);
  const picture = new File([Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a])], 'x.take');
  await desk.open([picture]);
  expect(openPicture).toHaveBeenCalledWith(picture);
  expect(store.state.notice).toBeNull();
});

it('says in one sentence what it does not open', async () => {
  await desk.open([new File(['type octile\n'], 'Berlin.map')]);
  expect(store.state.notice?.text).toBe(
    '“Berlin.map” is a grid map: “muster import Berlin.map -o place.json” makes a scenario of it.',
  );
  await desk.open([new File([], 'nothing.take')]);
  expect(store.state.notice?.text).toBe('“nothing.take” is empty.');
  const gone = new File(['x'], 'gone.glb');
  gone.slice = () => {
    throw new Error('gone');
  };
  await desk.open([gone]);
  expect(store.state.notice?.text).toBe('“gone.glb” cannot be read.');
  await desk.open([]);
  expect(openTake).not.toHaveBeenCalled();
});

it('takes files that are dropped on the page', async () => {
  desk.acceptDrops(window);
  const drop = Object.assign(new Event('drop', { cancelable: true }), {
    dataTransfer: { files: [new File(['glTF....'], 'a.glb')], types: ['Files'] },
  });
  window.dispatchEvent(drop);
  expect(drop.defaultPrevented).toBe(true);
  await vi.waitFor(() => expect(openCharacter).toHaveBeenCalledTimes(1));
});
