import { beforeEach, describe, expect, it } from 'vitest';
import { OverlayKind, PlaybackAction, type ClientMessage } from '../../protocol/messages';
import { StudioController, nextSpeed } from './studio_controller';
import { StudioStore } from '../../model/studio_store';

const nothing = (): void => undefined;
const recordingCamera = {
  toggleFollow: nothing,
  frameGroup: nothing,
  toggleTop: nothing,
  toggleFlat: nothing,
  saveView: nothing,
  showView: nothing,
};
let sent: ClientMessage[];
let said: string[];
let seen: { x: number; y: number }[];
let barred: unknown[];
let store: StudioStore;
let controller: StudioController;

beforeEach(() => {
  sent = [];
  said = [];
  seen = [];
  barred = [];
  store = new StudioStore();
  const client = { send: (message: ClientMessage) => sent.push(message), retry: () => undefined };
  const camera = {
    fitInTurn: () => undefined,
    lookAt: (point: { x: number; y: number }) => seen.push(point),
    ...recordingCamera,
  };
  controller = new StudioController(
    client,
    store,
    camera,
    (text) => said.push(text),
    {
      open: () => Promise.resolve(),
      reset: () => undefined,
    },
    { toggleDraw: nothing, holdDraw: nothing, lookAt: nothing, shape: () => ({ spacing: 1.5, places: [] }) },
    { show: (otherwise) => barred.push(otherwise) },
  );
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
    expect(sent.map((one) => one.type === 'Playback' && one.action)).toEqual([
      PlaybackAction.Play,
      PlaybackAction.Pause,
    ]);
  });
  it('gives formations to the active group, and nothing where there is none', () => {
    controller.setFormation('ring');
    expect(sent).toEqual([]);
    store.set({ groups: [{ ...group, id: 1 }, group], active: 1 });
    controller.setFormation('ring');
    const formation = { kind: 'ring', spacing: 1.5 };
    expect(sent).toEqual([{ type: 'Commands', commands: [{ kind: 'changeGroup', group: 7, formation }] }]);
    expect(said).toEqual(['North: ring with the next step']);
    store.set({ playing: true });
    controller.setFormation('line');
    expect(said).toHaveLength(1);
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
      [OverlayKind.None, 0],
      [OverlayKind.Cost, 30],
      [OverlayKind.None, 0],
    ]);
    expect(store.state.overlay).toBe(OverlayKind.None);
  });
  it('asks again for the overlay that is shown, of a server that was found again', () => {
    controller.askOverlayAgain();
    expect(sent).toEqual([]);
    controller.toggleOverlay(OverlayKind.Density);
    controller.askOverlayAgain();
    controller.chooseCharacter(30);
    controller.askOverlayAgain();
    expect(sent.map((one) => one.type === 'SetOverlay' && [one.kind, one.character])).toEqual([
      [OverlayKind.Density, 0],
      [OverlayKind.Density, 0],
      [OverlayKind.Cost, 30],
      [OverlayKind.Cost, 30],
    ]);
  });
  it('leaves a replay by loading what was steered before it, or what is called like it', () => {
    const info = (name: string, title: string) => ({
      type: 'ScenarioInfo',
      name,
      title,
      description: '',
      characters: 9,
    });
    store.set({
      scenarios: [info('block', 'Block'), info('open', 'Open square')] as never,
      replaying: true,
      title: 'Open square',
    });
    controller.leaveReplay();
    store.set({ lastSteered: 'block' });
    controller.leaveReplay();
    store.set({ lastSteered: 'gone', title: 'Gone' });
    controller.leaveReplay();
    const loads = sent.flatMap((one) => (one.type === 'LoadScenario' ? [one.name] : []));
    expect(loads).toEqual(['open', 'block', 'block']);
  });
  it('records nothing while a take is replayed', () => {
    store.set({ replaying: true });
    controller.toggleRecord();
    expect(sent).toEqual([]);
    expect(said).toHaveLength(1);
    store.set({ replaying: false });
    controller.toggleRecord();
    expect(sent).toEqual([{ type: 'Record', on: true }]);
  });
  it('watches what the scenario carries, and goes back to the plain start', () => {
    controller.toggleDemonstration();
    expect(sent).toEqual([]);
    expect(said).toEqual(['There is nothing to watch here']);
    store.set({ playing: true, demonstration: true });
    controller.toggleDemonstration();
    store.set({ demonstrating: true });
    controller.toggleDemonstration();
    expect(sent.map((one) => one.type === 'Playback' && one.action)).toEqual([
      PlaybackAction.Demonstrate,
      PlaybackAction.Restart,
    ]);
  });
  it('shows the spot of a message, where it has one', () => {
    controller.showNoticePlace();
    store.set({ notice: { type: 'Notice', level: 1, code: 'rejected', text: '', hasPlace: true, x: 3, y: -2 } });
    controller.showNoticePlace();
    expect(seen).toEqual([{ x: 3, y: -2 }]);
    store.set({ notice: { type: 'Notice', level: 1, code: 'standing', text: '', hasPlace: true, x: 1, y: 2 } });
    controller.showNoticePlace();
    expect(barred).toEqual([{ x: 1, y: 2 }]);
  });
  it('toggles layers one by one', () => {
    controller.toggleLayer('paths');
    expect(store.state.layers).toEqual({ mesh: true, places: true, paths: false });
  });
});
