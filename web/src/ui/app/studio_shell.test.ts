// @vitest-environment jsdom
import type { DirectorActions } from '../../model/directors';
import { beforeEach, expect, it } from 'vitest';
import type { OrderActions } from '../../model/order_actions';
import type { StudioActions } from '../../model/studio_actions';
import { StudioShell } from './studio_shell';
import { StudioStore } from '../../model/studio_store';

let store: StudioStore;
let page: HTMLElement;
const find = (selector: string) => page.querySelector<HTMLElement>(selector)!;

beforeEach(() => {
  store = new StudioStore();
  page = document.createElement('div');
  document.body.replaceChildren(page);
  new StudioShell(page, store, {} as StudioActions, {} as OrderActions, {} as DirectorActions, []);
});

it('what needs the server is inert while it is lost, what does not stays', () => {
  const needs = ['.playback', '.scenario', '.orders', '.groups', '.queue', '.layers [data-key="V"]'];
  const state = () => needs.map((selector) => find(selector).inert || find(selector).hasAttribute('inert'));
  store.set({ link: { phase: 'open' }, loaded: true });
  expect(new Set(state())).toEqual(new Set([false]));
  store.set({ link: { phase: 'lost', retryAt: 0, attempt: 1 } as never });
  expect(new Set(state())).toEqual(new Set([true]));
  for (const selector of ['.layers [data-key="M"]', '.theme-button', '.help-button', '.banners']) {
    expect(find(selector).closest('[inert]'), selector).toBeNull();
    expect(find(selector).inert, selector).toBeFalsy();
  }
  store.set({ link: { phase: 'open' } });
  expect(new Set(state())).toEqual(new Set([false]));
});

it('a message stands below the banner of a lost connection, not over it', () => {
  store.set({ link: { phase: 'lost', retryAt: 0, attempt: 1 } as never, loaded: true });
  store.set({ notice: { type: 'Notice', level: 2, code: 'x', text: 'y', hasPlace: false, x: 0, y: 0 } });
  const [lost, notice] = [...find('.banners').children] as HTMLElement[];
  expect([lost!.hidden, notice!.hidden]).toEqual([false, false]);
  expect(notice!.classList.contains('notice')).toBe(true);
});
