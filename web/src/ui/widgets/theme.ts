// Light or dark: the visitor's choice, else the system's.

import type { Theme } from '../../model/view_settings';

const kKey = 'muster.theme';

/** Storage may be forbidden; then choices last as long as the page. */
export function readSetting(storage: () => Storage, key: string): string | null {
  try {
    return storage().getItem(key);
  } catch {
    return null;
  }
}

export function writeSetting(storage: () => Storage, key: string, value: string): void {
  try {
    storage().setItem(key, value);
  } catch {
    // Storage is forbidden: the choice lasts as long as the page.
  }
}

export function preferredTheme(page: Window): Theme {
  const chosen = readSetting(() => page.localStorage, kKey);
  if (chosen === 'light' || chosen === 'dark') return chosen;
  return page.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}

/** Tells when the system changes between light and dark and the visitor has chosen none of them. */
export function followSystemTheme(page: Window, changed: (theme: Theme) => void): void {
  page.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    if (readSetting(() => page.localStorage, kKey) === null) changed(preferredTheme(page));
  });
}

export function applyTheme(page: Window, theme: Theme): void {
  page.document.documentElement.dataset['theme'] = theme;
  page.document
    .querySelector('meta[name="theme-color"]')
    ?.setAttribute('content', theme === 'dark' ? '#21262C' : '#E6E1D9');
}

export function rememberTheme(page: Window, theme: Theme): void {
  writeSetting(() => page.localStorage, kKey, theme);
}
