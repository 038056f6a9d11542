// What the page shows follows the visitor's settings and the size of the window.

import { OverlayKind } from '../../protocol/messages';
import type { Padding } from '../../scene/camera/camera_controls';
import type { StudioScene } from '../../scene/studio_scene';
import { formatClock } from '../../model/formatters';
import type { StudioStore } from '../../model/studio_store';
import type { Layers } from '../../model/view_settings';
import { LayoutWatcher } from './layout_watcher';
import { kFiguresKey, kHintKey } from './studio_controller';
import { applyTheme, followSystemTheme, preferredTheme, readSetting } from '../widgets/theme';

const kNoLayers: Layers = { mesh: false, places: false, paths: false };

/** `padding`: what the panels cover. */
export function followSettings(store: StudioStore, view: StudioScene, padding: () => Padding): void {
  const touchFirst = window.matchMedia('(pointer: coarse)').matches;
  const kept = (key: string): string | null => readSetting(() => window.localStorage, key);
  store.set({ theme: preferredTheme(window), input: touchFirst ? 'touch' : 'mouse', hint: kept(kHintKey) === null });
  store.set({ figures: kept(kFiguresKey) === 'shown' });
  new LayoutWatcher(window, (layout) => {
    store.set({ layout });
    requestAnimationFrame(() => void (view.fitter.padding = padding()));
  });
  followSystemTheme(window, (theme) => store.set({ theme }));
  store.watch(['theme'], ({ theme }) => {
    applyTheme(window, theme);
    view.setTheme(theme);
  });
  store.watch(['layers', 'clean'], ({ layers, clean }) => view.setLayers(clean ? kNoLayers : layers));
  store.watch(['clean'], ({ clean }) => document.documentElement.toggleAttribute('data-clean', clean));
  store.watch(['active'], ({ active }) => view.setActiveGroup(active));
  store.watch(['selected'], ({ selected }) => view.orders.setSelected(selected));
  store.watch(['overlay', 'chosen'], ({ overlay }) => {
    document.documentElement.toggleAttribute('data-overlay', overlay !== OverlayKind.None);
    view.setOverlay(null);
  });
  store.watch(['title', 'recorded'], ({ title, recorded }) => {
    const name = title ? `${title} – Muster` : 'Muster';
    document.title = recorded >= 0 ? `● ${formatClock(recorded).slice(0, -2)} ${name}` : name;
  });
  const motion = window.matchMedia('(prefers-reduced-motion: reduce)');
  view.setReducedMotion(motion.matches);
  motion.addEventListener('change', () => view.setReducedMotion(motion.matches));
}
