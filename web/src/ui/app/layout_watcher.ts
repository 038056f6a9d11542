// Follows the size of the window.

import { chooseLayout, type Layout } from '../../model/layout';

/** Keeps `data-layout` on <html> true. */
export class LayoutWatcher {
  layout: Layout = 'desktop';

  constructor(
    private readonly page_: Window,
    private readonly changed_: (layout: Layout) => void,
  ) {
    page_.addEventListener('resize', () => this.update());
    this.update();
  }

  private update(): void {
    this.layout = chooseLayout(this.page_.innerWidth, this.page_.innerHeight);
    this.page_.document.documentElement.dataset['layout'] = this.layout;
    this.changed_(this.layout);
  }
}
