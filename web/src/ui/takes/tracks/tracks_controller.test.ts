// @vitest-environment jsdom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { StudioClient } from '../../../link/studio_client';
import { StudioStore } from '../../../model/studio_store';
import { kOpenTake } from '../../../model/test_frames';
import { TakeBlockKind, TrackEdit, type ClientMessage, type TakeTracks } from '../../../protocol/messages';
import { recordingActions } from '../../widgets/test_support';
import { TracksController, type TracksHost } from './tracks_controller';

type Listener = (message: never) => void;

let sent: ClientMessage[];
let calls: string[];
let listeners: Map<string, Listener>;
let tracks: TracksController;

function told(revision: number, begin: number): TakeTracks {
  const block = { group: 1, begun: begin, moves: true, stretches: true };
  return {
    type: 'TakeTracks',
    revision,
    tracks: [
      { group: 1, name: 'North', from: 0, to: 600 },
      { group: 2, name: '', from: 120, to: 600 },
    ],
    blocks: [{ ...block, id: 0, kind: TakeBlockKind.Order, begin, end: begin + 120, label: 'Move to Fountain' }],
    undo: '',
    redo: '',
  };
}

const tell = (name: string, message: unknown): void => listeners.get(name)!(message as never);
const at = (name: string): HTMLElement => tracks.root.querySelector<HTMLElement>(name)!;
const press = (key: string, more: KeyboardEventInit = {}): boolean =>
  document.activeElement!.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, ...more }));

function pointer(type: string, target: Element, x: number, more: MouseEventInit = {}): void {
  const event = new MouseEvent(type, { clientX: x, bubbles: true, button: 0, ...more });
  Object.defineProperty(event, 'pointerId', { value: 1 });
  target.dispatchEvent(event);
}

beforeEach(() => {
  vi.useFakeTimers();
  HTMLElement.prototype.setPointerCapture = () => undefined;
  Object.defineProperty(HTMLElement.prototype, 'clientWidth', { configurable: true, get: () => 600 });
  [sent, calls] = [[], []];
  listeners = new Map<string, Listener>();
  const client = {
    send: (message: ClientMessage) => sent.push(message),
    on: (name: string, listener: Listener) => listeners.set(name, listener),
  };
  const host = recordingActions(calls) as unknown as TracksHost;
  tracks = new TracksController(client as unknown as StudioClient, new StudioStore(), host);
  document.body.replaceChildren(tracks.root);
  tracks.show({ take: kOpenTake, step: 0, keys: [], films: false });
  tracks.setOpen(true);
  tell('takeTracks', told(7, 60));
});

afterEach(() => tracks.setOpen(false));

it('asks for tracks, and names blocks with their times', () => {
  expect(sent).toEqual([{ type: 'WatchTracks', on: true }]);
  expect(at('.track-block').ariaLabel ?? at('.track-block').getAttribute('aria-label')).toBe(
    'Move to Fountain, 0:00.0 to 0:02.0',
  );
  expect([...tracks.root.querySelectorAll('.track-name')].map((name) => name.textContent)).toContain('Group 2');
  expect(at('.track-block').style.left).toBe('60px');
});

it('moves a block by a drag, which snaps to seconds, and finds it again', () => {
  pointer('pointerdown', at('.track-block'), 70);
  pointer('pointermove', at('.track-block'), 187);
  expect(at('.track-block').style.left).toBe('180px');
  pointer('pointerup', at('.track-block'), 187);
  expect(sent[1]).toEqual({ type: 'EditTrack', revision: 7, edit: TrackEdit.Move, block: 0, step: 180, group: 0 });
  expect(at('.tracks-words').textContent).toContain('simulated again');
  tell('takeTracks', told(8, 180));
  expect(at('.track-block').getAttribute('aria-pressed')).toBe('true');
  expect(at('.track-chosen').textContent).toContain('Move to Fountain');
});

it('stretches by the right end, copies with Alt, and leaves a still press alone', () => {
  pointer('pointerdown', at('.track-grip'), 175);
  pointer('pointermove', at('.track-grip'), 235);
  pointer('pointerup', at('.track-grip'), 235);
  expect(sent[1]).toMatchObject({ edit: TrackEdit.Stretch, step: 240 });
  tell('takeTracks', told(8, 60));
  pointer('pointerdown', at('.track-block'), 70);
  pointer('pointerup', at('.track-block'), 72);
  expect(sent.length).toBe(2);
  pointer('pointerdown', at('.track-block'), 70);
  pointer('pointermove', at('.track-block'), 370, { altKey: true });
  expect(tracks.root.querySelectorAll('.track-ghost').length).toBe(1);
  pointer('pointerup', at('.track-block'), 370, { altKey: true });
  expect(sent[2]).toMatchObject({ edit: TrackEdit.Copy, step: 360, revision: 8 });
});

it('is moved, copied and removed by keys', () => {
  at('.track-block').focus();
  tracks.choose({ block: 0 });
  press('ArrowRight');
  press('ArrowRight');
  press('ArrowLeft', { shiftKey: true });
  expect(sent.length).toBe(1);
  vi.advanceTimersByTime(1000);
  expect(sent[1]).toMatchObject({ edit: TrackEdit.Move, step: 12 });
  tell('takeTracks', told(8, 12));
  tracks.show({ take: kOpenTake, step: 300, keys: [], films: false });
  press('c', { ctrlKey: true });
  press('v', { ctrlKey: true });
  expect(sent[2]).toMatchObject({ edit: TrackEdit.Copy, block: 0, step: 300 });
  tell('takeTracks', { ...told(9, 12), undo: 'Copy' });
  at('.track-block').focus();
  tracks.choose({ block: 0 });
  press('Enter');
  expect(document.activeElement?.getAttribute('aria-label')).toBe('When Move to Fountain begins');
  at('.track-block').focus();
  press('Delete');
  expect(sent[3]).toMatchObject({ edit: TrackEdit.Remove, block: 0 });
  tell('notice', { code: 'EditTrack', text: 'It cannot be.' });
  press('z', { ctrlKey: true });
  expect(sent[4]).toMatchObject({ edit: TrackEdit.Undo });
});

it('moves and cuts views of the camera', () => {
  const pose = { targetX: 0, targetY: 0, distance: 10, turn: 0, pitch: 1 };
  tracks.show({
    take: kOpenTake,
    step: 0,
    keys: [
      { step: 60, pose },
      { step: 300, pose },
    ],
    films: true,
  });
  pointer('pointerdown', tracks.root.querySelectorAll('.track-key')[1]!, 300);
  pointer('pointermove', tracks.root.querySelectorAll('.track-key')[1]!, 421);
  pointer('pointerup', tracks.root.querySelectorAll('.track-key')[1]!, 421);
  expect(calls).toEqual(['moveView 300 420']);
  tracks.choose({ key: 60 });
  at('.tracks-chosen [aria-label="Cut"]').click();
  expect(calls[1]).toBe('cutView 60 true');
});
