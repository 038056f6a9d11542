import { File as NodeFile } from 'node:buffer';
import { beforeEach, expect, it, vi } from 'vitest';
import { StudioStore } from '../../model/studio_store';
import { FileController } from './file_controller';

// Blobs of jsdom cannot be read.
const fileOf = (parts: readonly (string | Uint8Array)[], name: string): File =>
  new NodeFile(parts as never, name) as unknown as File;
const openCharacter = vi.fn();
const openTake = vi.fn();
const openPicture = vi.fn();
const showPlaces = vi.fn();
let store: StudioStore;
let controller: FileController;

beforeEach(() => {
  vi.clearAllMocks();
  store = new StudioStore();
  controller = new FileController(store, { openCharacter, openTake, showPlaces }, { openPicture });
});

it('opens takes, characters with their parts, and pictures, whatever they are called', async () => {
  const take = fileOf(['MUSTAKE\n...'], 'photo.png');
  await controller.open([take]);
  expect(openTake).toHaveBeenCalledWith(take);
  const parts = [
    fileOf([new Uint8Array(8)], 'body.bin'),
    fileOf(['{"asset": {}, "buffers": [], "skins": [{}]}'], 'body.gltf'),
  ];
  await controller.open(parts);
  expect(openCharacter).toHaveBeenCalledWith(parts);
  const picture = fileOf([Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a])], 'x.take');
  await controller.open([picture]);
  expect(openPicture).toHaveBeenCalledWith(picture);
  expect(store.state.notice).toBeNull();
});

it('says in one sentence what it does not open', async () => {
  await controller.open([fileOf(['HIERARCHY\n'], 'walk.bvh')]);
  expect(store.state.notice?.text).toBe(
    '“walk.bvh” is recorded motion: a scenario names such files for its characters.',
  );
  await controller.open([fileOf([], 'nothing.take')]);
  expect(store.state.notice?.text).toBe('“nothing.take” is empty.');
  const gone = fileOf(['x'], 'gone.glb');
  gone.slice = () => {
    throw new Error('gone');
  };
  await controller.open([gone]);
  expect(store.state.notice?.text).toBe('“gone.glb” cannot be read.');
  await controller.open([]);
  expect(openTake).not.toHaveBeenCalled();
});

it('hands on what becomes a place', async () => {
  const files = {
    import: [
      fileOf(['type octile\nheight 2\n'], 'Berlin.txt'),
      fileOf(['{"type": "FeatureCollection", "features": []}'], 'town.json'),
      fileOf(['# made by hand\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n'], 'shed'),
      fileOf(['{"asset": {"version": "2.0"}, "meshes": []}'], 'bench.gltf'),
    ],
    shelf: [fileOf(['{"format": "muster-scenario", "map": {"rows": ["."]}}'], 'place.json')],
  };
  for (const [view, list] of Object.entries(files))
    for (const file of list) {
      await controller.open([file]);
      expect(showPlaces).toHaveBeenLastCalledWith(view, [file]);
    }
  expect(store.state.notice).toBeNull();
});

it('tells a body from a model by skins far behind the head', async () => {
  const json = `{"asset": {}, "meshes": [], "extras": "${'x'.repeat(100000)}", "skins": [{}]}`;
  const head = new Uint8Array(20);
  head.set([0x67, 0x6c, 0x54, 0x46, 2, 0, 0, 0]);
  new DataView(head.buffer).setUint32(12, json.length, true);
  await controller.open([fileOf([head, json], 'body.glb')]);
  await controller.open([fileOf([json], 'body.gltf')]);
  expect(openCharacter).toHaveBeenCalledTimes(2);
  expect(showPlaces).not.toHaveBeenCalled();
});

it('takes files that are dropped on the page', async () => {
  const page = new EventTarget();
  controller.acceptDrops(page as Window);
  const drop = Object.assign(new Event('drop', { cancelable: true }), {
    dataTransfer: { files: [fileOf(['{"asset": {}, "nodes": [], "skins": [{}]}'], 'a.glb')], types: ['Files'] },
  });
  page.dispatchEvent(drop);
  expect(drop.defaultPrevented).toBe(true);
  await vi.waitFor(() => expect(openCharacter).toHaveBeenCalledTimes(1));
});
