// @vitest-environment jsdom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import type { DirectorInfo } from '../../model/directors';
import { StudioStore } from '../../model/studio_store';
import { DirectorsPanel } from './directors_panel';

const director = (client: number, name: string, more: Partial<DirectorInfo> = {}): DirectorInfo => ({
  client,
  name,
  colour: '#7a3fc4',
  own: client === 1,
  groups: [],
  holds: [],
  ...more,
});

const kGroups = [
  { id: 5, name: 'Blue', colour: 0, count: 9, formation: 'square' },
  { id: 6, name: 'Red', colour: 1, count: 9, formation: 'square' },
];

function made() {
  const actions = { rename: vi.fn(), giveGroup: vi.fn(), copyLink: vi.fn(), goBack: vi.fn() };
  const store = new StudioStore();
  const panel = new DirectorsPanel(store, actions);
  document.body.append(panel.root);
  return { actions, store, root: panel.root };
}

beforeEach(() => document.body.replaceChildren());

describe('DirectorsPanel', () => {
  it('is hidden for who is alone and cannot invite', () => {
    const { store, root } = made();
    store.set({ directors: [director(1, 'Anna')] });
    expect(root.hidden).toBe(true);
    store.set({ directors: [director(1, 'Anna'), director(2, 'Ben')] });
    expect(root.hidden).toBe(false);
    store.set({ directors: [director(1, 'Anna')], invitation: { links: ['http://a/'], code: ['1'], site: '' } });
    expect(root.hidden).toBe(false);
  });

  it('lists who is there, what they hold, and lets groups be given', () => {
    const { store, root, actions } = made();
    store.set({ groups: kGroups, directors: [director(1, 'Anna'), director(2, 'Ben', { holds: [6], groups: [5] })] });
    const rows = [...root.querySelectorAll('.director')];
    expect(rows.map((row) => row.querySelector('.holds')?.textContent)).toEqual(['you', 'holds Red']);
    const select = rows[1]!.querySelector('select')!;
    expect(select.value).toBe('5');
    expect(select.getAttribute('aria-label')).toBe('What Ben may direct');
    select.value = '6';
    select.dispatchEvent(new Event('change'));
    expect(actions.giveGroup).toHaveBeenCalledWith(2, 6);
  });

  it('lets the reader change the own name, which is not lost while others move', () => {
    const { store, root, actions } = made();
    store.set({ groups: kGroups, directors: [director(1, 'Anna'), director(2, 'Ben')] });
    root.querySelector('button')!.click();
    const field = root.querySelector<HTMLInputElement>('input')!;
    field.focus();
    field.value = 'Annab';
    store.set({ directors: [director(1, 'Anna'), director(2, 'Ben', { holds: [5] })] });
    expect(root.querySelector<HTMLInputElement>('input')!.value).toBe('Annab');
    field.dispatchEvent(new Event('change'));
    expect(actions.rename).toHaveBeenCalledWith('Annab');
  });

  it('shows the link with its code', () => {
    const { store, root, actions } = made();
    store.set({ invitation: { links: ['http://192.168.0.2:8080/?token=a'], code: ['1101', '0010'], site: '' } });
    expect(root.querySelector('code')!.textContent).toContain('192.168.0.2');
    expect(root.querySelector('.qr path')!.getAttribute('d')).toBe('M4 4h2v1h-2zM7 4h1v1h-1zM6 5h1v1h-1z');
    [...root.querySelectorAll('button')].find((one) => one.textContent?.includes('Copy'))!.click();
    expect(actions.copyLink).toHaveBeenCalledWith('http://192.168.0.2:8080/?token=a');
  });
});
