// @vitest-environment jsdom
import { beforeEach, expect, it } from 'vitest';
import { followSystemTheme, preferredTheme, rememberTheme } from './theme';

let dark: boolean;
let changed: (() => void)[];

beforeEach(() => {
  dark = false;
  changed = [];
  window.localStorage.clear();
  window.matchMedia = (() => ({
    get matches() {
      return dark;
    },
    addEventListener: (_: string, tell: () => void) => changed.push(tell),
  })) as unknown as typeof window.matchMedia;
});

it('follows the system until the visitor chooses', () => {
  const seen: string[] = [];
  followSystemTheme(window, (theme) => seen.push(theme));
  const system = (isDark: boolean): void => {
    dark = isDark;
    changed.forEach((tell) => tell());
  };
  expect(preferredTheme(window)).toBe('light');
  system(true);
  system(false);
  expect(seen).toEqual(['dark', 'light']);
  rememberTheme(window, 'light');
  system(true);
  expect(seen).toHaveLength(2);
  expect(preferredTheme(window)).toBe('light');
});
