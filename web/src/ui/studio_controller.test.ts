import { beforeEach, describe, expect, it } from 'vitest';
import { OverlayKind, TransportAction, type ClientMessage } from '../protocol/messages';
import { StudioController, nextSpeed } from './studio_controller';
import { StudioStore } from './studio_state';

let sent: ClientMessage[];
let said: string[];
let store: StudioStore;
let controller: StudioController;

beforeEach(() => {
  sent = [];
  said = [];
  store = new StudioStore();
  const client = { send: (message: ClientMessage) => sent.push(message), retry: () => undefined };
  controller = new StudioController(client, store, () => undefined, (text) => said.push(text));
});

const group = { id: 7, name: 'North', colour: 0, count: 9, formation: 'square' };

describe('nextSpeed', () => {
  it('walks the list round, in both directions, also from between', () => {
    expect(nextSpeed(1, false)).toBe(2);
    expect(nextSpeed(4, false)).toBe(0.25);
    expect(nextSpeed(0.25, true)).toBe(4);
    expect(nextSpeed(3, true)).toBe(2);
  });
});

describe('StudioController', () => {
  it('plays or pauses by what the last frame said', () => {
    controller.togglePlay();
    store.set({ playing: true });
    controller.togglePlay();
    expect(sent.map((one) => one.type === 'Transport' && one.action)).toEqual([TransportAction.Play, TransportAction.Pause]);
  });
  it('gives formations to the active group, and nothing where there is none', () => {
    controller.setFormation('ring');
    expect(sent).toEqual([]);
    store.set({ groups: [{ ...group, id: 1 }, group], active: 1 });
    controller.setFormation('ring');
    expect(sent).toEqual([{ type: 'SetFormation', group: 7, formation: 'ring' }]);
    expect(said).toEqual(['North: ring']);
  });
  it('goes round the groups', () => {
    store.set({ groups: [group, { ...group, id: 8 }], active: 1 });
    controller.nextGroup();
    expect(store.state.active).toBe(0);
  });
  it('asks for a cost field only once a character is chosen', () => {
    controller.toggleOverlay(OverlayKind.Cost);
    controller.chooseCharacter(30);
    controller.toggleOverlay(OverlayKind.Cost);
    expect(sent.map((one) => one.type === 'SetOverlay' && [one.kind, one.character])).toEqual([
      [OverlayKind.None, 0], [OverlayKind.Cost, 30], [OverlayKind.None, 0],
    ]);
    expect(store.state.overlay).toBe(OverlayKind.None);
  });
  it('toggles layers one by one', () => {
    controller.toggleLayer('paths');
    expect(store.state.layers).toEqual({ mesh: true, places: true, paths: false });
  });
});
