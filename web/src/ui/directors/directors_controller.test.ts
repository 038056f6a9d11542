import { afterEach, describe, expect, it, vi } from 'vitest';
import { StudioStore } from '../../model/studio_store';
import type { ClientMessage, DirectorFrame } from '../../protocol/messages';
import { DirectorsController, kNameKey } from './directors_controller';

const frame = (client: number, name: string): DirectorFrame => ({
  client,
  name,
  colour: client,
  groups: Uint32Array.of(),
});

function made(kept: Record<string, string> = {}) {
  const sent: ClientMessage[] = [];
  const said: string[] = [];
  const shown = vi.fn();
  const storage = {
    getItem: (key: string) => kept[key] ?? null,
    setItem: (key: string, value: string) => void (kept[key] = value),
  } as unknown as Storage;
  const store = new StudioStore();
  const controller = new DirectorsController(
    { send: (message) => sent.push(message) },
    store,
    { setDirectors: shown },
    () => 1,
    (text) => said.push(text),
    () => storage,
  );
  return { controller, store, sent, said, shown, kept };
}

afterEach(() => vi.unstubAllGlobals());

describe('DirectorsController', () => {
  it('tells the server the name that the browser kept, and keeps a new one', () => {
    vi.stubGlobal('fetch', () => Promise.reject(new Error('no server')));
    const { controller, sent, kept } = made({ [kNameKey]: 'Anna' });
    controller.greeted(1);
    expect(sent).toEqual([{ type: 'SetName', name: 'Anna' }]);
    controller.rename(' Ben ');
    expect(sent[1]).toEqual({ type: 'SetName', name: ' Ben ' });
    expect(kept[kNameKey]).toBe('Ben');
  });

  it('says who came and who left, but not who was there before', () => {
    const { controller, said, store } = made();
    controller.took([frame(1, 'Anna')]);
    expect(said).toEqual([]);
    controller.took([frame(1, 'Anna'), frame(2, 'Ben')]);
    controller.took([frame(2, 'Ben')]);
    expect(said).toEqual(['Ben came', 'Anna left']);
    expect(store.state.directors.map(({ name }) => name)).toEqual(['Ben']);
  });

  it('shows who holds what, and only when it changes', () => {
    const { controller, store, shown } = made();
    controller.took([frame(1, 'Anna'), frame(2, 'Ben')]);
    const groups = [{ id: 5, controls: [{ client: 2 }] }] as never;
    controller.observe(groups);
    controller.observe(groups);
    expect(shown).toHaveBeenCalledTimes(2);
    expect(store.state.directors[1]?.holds).toEqual([5]);
    expect(store.state.directors[0]?.own).toBe(true);
  });

  it('reads how others come in', async () => {
    const invitation = { links: ['http://192.168.0.2:8080/?token=a'], code: ['101'] };
    vi.stubGlobal('fetch', () => Promise.resolve({ ok: true, json: () => Promise.resolve(invitation) }));
    const { controller, store } = made();
    controller.greeted(1);
    await vi.waitFor(() => expect(store.state.invitation).toEqual(invitation));
  });
});
