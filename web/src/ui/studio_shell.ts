// Puts the panels on the page.

import type { Shortcut } from '../tools/shortcuts';
import { LostBanner, NoticeBanner } from './banner';
import { element } from './dom';
import { EmptyPanel } from './empty_panel';
import { pressWithExtraFingers } from './extra_finger_press';
import { FormationPanel } from './formation_panel';
import { GroupChips } from './group_chips';
import { HelpDialog } from './help_dialog';
import { HintBar } from './hint_bar';
import { LayerBar } from './layer_bar';
import { LegendPanel } from './legend_panel';
import { LiveRegion } from './live_region';
import { PhoneBar } from './phone_bar';
import { Readout } from './readout';
import { ScaleBar } from './scale_bar';
import { ScenarioPicker } from './scenario_picker';
import type { StudioActions } from './studio_actions';
import { isLost, type StudioStore } from './studio_state';
import { Tooltip } from './tooltip';
import { TransportBar } from './transport_bar';
import type { Padding } from '../view/camera_types';

/** Between top panels and the ground that must be seen: figures stand up into it [px]. */
const HEADROOM = 44;

export class StudioShell {
  readonly scale = new ScaleBar();
  readonly live = new LiveRegion();
  /** At the upper and the lower edge. */
  private readonly panels: HTMLElement[];
  private readonly formations: FormationPanel;
  private readonly transport: TransportBar;
  private readonly readout: Readout;

  constructor(
    private readonly page: HTMLElement,
    private readonly store: StudioStore,
    actions: StudioActions,
    shortcuts: readonly Shortcut[],
  ) {
    const scenario = new ScenarioPicker(store, actions).root;
    const groups = new GroupChips(store, actions).root;
    const layers = new LayerBar(store, actions).root;
    this.formations = new FormationPanel(store, actions);
    this.transport = new TransportBar(store, actions);
    this.readout = new Readout(store, actions);
    const phone = new PhoneBar(store, actions, () => this.transport.chooseFile(), () => this.transport.chooseCharacter()).root;
    const sheet = element('div', { class: 'sheet' }, this.formations.root, element('hr'), this.transport.root);
    const hint = new HintBar(store, actions).root;
    const legend = new LegendPanel(store).root;
    const header = element('header', { class: 'contents' }, scenario, groups, layers, phone);
    const banners = element('div', { class: 'banners' }, new LostBanner(store, actions).root, new NoticeBanner(store, actions).root);
    const empty = new EmptyPanel(store, actions).root;
    const main = element('div', { class: 'contents', role: 'region', 'aria-label': 'Tools' }, banners, empty,
      hint, sheet, legend, this.readout.root, this.scale.root);
    this.page.append(header, main, this.live.root, new HelpDialog(store, actions, shortcuts).root, new Tooltip(document).root);
    pressWithExtraFingers(this.page);
    store.watch(['link', 'loaded'], (state) => {
      for (const panel of [scenario, sheet, empty]) panel.inert = isLost(state);
    });
    this.panels = [scenario, groups, layers, phone, sheet, this.readout.root];
  }

  /** What the panels cover; fits keep clear of it. */
  padding(): Padding {
    const { layout } = this.store.state;
    const height = window.innerHeight;
    const boxes = this.panels.map((panel) => panel.getBoundingClientRect()).filter((box) => box.height > 0);
    // On phones the groups and figures stand on the sheet.
    const [above, below] = [boxes.filter((box) => box.top < height / 2), boxes.filter((box) => box.top >= height / 2)];
    const top = Math.max(0, ...above.map((box) => box.bottom)) + HEADROOM;
    if (layout === 'desktop' || layout === 'landscape') {
      const left = this.formations.root.getBoundingClientRect().right + 12;
      const right = layout === 'desktop' ? 24 : window.innerWidth - this.transport.root.getBoundingClientRect().left + 12;
      return { top, right, bottom: height - this.readout.root.getBoundingClientRect().top + 12, left };
    }
    return { top, right: 24, bottom: height - Math.min(height, ...below.map((box) => box.top)) + 24, left: 24 };
  }
}
