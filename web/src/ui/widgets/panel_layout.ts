// Puts each panel into its area, and into another one where the layout changes.

import type { Layout } from '../../model/layout';
import { kPlaces, type Area, type PanelName } from '../../model/panel_places';
import { element } from './dom';

const kLayouts = new WeakMap<HTMLElement, PanelLayout>();

function area(name: Area, ...inner: HTMLElement[]): HTMLElement {
  return element('div', { class: `area area-${name}` }, ...inner);
}

export class PanelLayout {
  private readonly areas_: Readonly<Record<Area, HTMLElement>>;
  private readonly panels_ = new Map<PanelName, HTMLElement>();
  private layout_: Layout = 'desktop';
  private still_: ReadonlySet<PanelName> = new Set();

  constructor(page: HTMLElement) {
    kLayouts.set(page, this);
    const [low, transport, stat, top] = [area('low'), area('transport'), area('stat'), area('top')];
    const sheet = element('div', { class: 'area area-sheet sheet' }, top);
    const foot = area('foot', low, transport, stat);
    const [head, bar] = [element('header', { class: 'area area-head' }), area('bar')];
    const [left, note, right, wide] = [area('left'), area('note'), area('right'), area('wide')];
    this.areas_ = { head, bar, left, note, right, wide, foot, low, transport, stat, sheet, top };
    const main = element('div', { class: 'contents', role: 'region', 'aria-label': 'Tools' });
    main.append(bar, left, note, right, wide, foot, sheet);
    page.append(head, main);
  }

  static of(page: HTMLElement): PanelLayout {
    return kLayouts.get(page) ?? new PanelLayout(page);
  }

  add(name: PanelName, panel: HTMLElement): void {
    this.panels_.set(name, panel);
    panel.dataset['panel'] = name;
    if (this.still_.has(name)) panel.inert = true;
    this.place();
  }

  /** A panel that stands in the layout at present. */
  panel(name: PanelName): HTMLElement | undefined {
    return this.panels_.get(name);
  }

  /** These panels stand back, also those that come later; all others do not. */
  setInert(names: readonly PanelName[]): void {
    this.still_ = new Set(names);
    for (const [name, panel] of this.panels_) panel.inert = this.still_.has(name);
  }

  area(name: Area): HTMLElement {
    return this.areas_[name];
  }

  show(layout: Layout): void {
    if (layout === this.layout_) return;
    this.layout_ = layout;
    this.place();
  }

  private place(): void {
    const focused = document.activeElement;
    this.move();
    // Who is moved about loses the focus, also where only a neighbour comes.
    if (focused instanceof HTMLElement && focused !== document.activeElement) focused.focus({ preventScroll: true });
  }

  private move(): void {
    const places = kPlaces[this.layout_];
    const shown = new Set<HTMLElement>();
    for (const [name, panels] of Object.entries(places) as [Area, readonly PanelName[]][]) {
      const here = panels.map((one) => this.panels_.get(one)).filter((one) => one !== undefined);
      for (const one of here) shown.add(one);
      const target = this.areas_[name];
      const fixed = [...target.children].filter((child) => child.classList.contains('area'));
      const wanted = [...fixed, ...here];
      const now = [...target.children];
      if (now.length !== wanted.length || now.some((child, i) => child !== wanted[i]))
        target.replaceChildren(...wanted);
    }
    for (const panel of this.panels_.values()) if (!shown.has(panel)) panel.remove();
  }
}
