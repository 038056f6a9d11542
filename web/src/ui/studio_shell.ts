// Puts the panels on the page.

import type { Shortcut } from '../tools/shortcuts';
import { LostBanner } from './panels/lost_banner';
import { NoticeBanner } from './panels/notice_banner';
import { element } from './widgets/dom';
import { CleanPicture } from './panels/clean_picture';
import { CrowdArrows } from './panels/crowd_arrows';
import { DirectorsPanel } from './panels/directors_panel';
import type { DirectorActions } from '../model/directors';
import { EmptyPanel } from './panels/empty_panel';
import { pressWithExtraFingers } from './widgets/extra_finger_press';
import { FormationPanel } from './panels/formation_panel';
import { GroupChips } from './panels/group_chips';
import { HelpDialog } from './panels/help_dialog';
import { HintBar } from './panels/hint_bar';
import { LayerBar } from './panels/layer_bar';
import { LegendPanel } from './panels/legend_panel';
import { LiveRegion } from './widgets/live_region';
import { PhoneBar } from './panels/phone_bar';
import { Readout } from './panels/readout';
import { ScaleBar } from './panels/scale_bar';
import { SchemeBanner, SchemeDialog } from './panels/scheme_dialog';
import { ScenarioPicker } from './panels/scenario_picker';
import type { OrderActions } from '../model/order_actions';
import { OrdersPanel } from './panels/orders_panel';
import { QueueBar } from './panels/queue_bar';
import type { StudioActions } from '../model/studio_actions';
import { isLost } from '../model/studio_state';
import { ViewBar } from './panels/view_bar';
import { Tooltip } from './widgets/tooltip';
import { PlaybackBar } from './panels/playback_bar';
import type { Padding } from '../scene/camera/camera_controls';
import type { StudioStore } from '../model/studio_store';

/** Between top panels and the ground that must be seen: figures stand up into it [px]. */
const kHeadroom = 44;
/** The queue and the hint stand at the lower edge of wide windows: fits leave room for them [px]. */
const kFoot = 176;

/** What tells of losses, messages and a control that is in use, below each other. */
function bannersOf(store: StudioStore, actions: StudioActions): HTMLElement {
  return element(
    'div',
    { class: 'banners' },
    new LostBanner(store, actions).root,
    new NoticeBanner(store, actions).root,
    new SchemeBanner(store, actions).root,
  );
}

export class StudioShell {
  readonly scale = new ScaleBar();
  readonly live = new LiveRegion();
  /** At the upper and the lower edge. */
  private readonly panels_: HTMLElement[];
  private readonly orders_: HTMLElement;
  private readonly formations_: FormationPanel;
  private readonly playback_: PlaybackBar;
  private readonly readout_: Readout;

  constructor(
    private readonly page_: HTMLElement,
    private readonly store_: StudioStore,
    actions: StudioActions,
    orders: OrderActions,
    directors: DirectorActions,
    shortcuts: readonly Shortcut[],
  ) {
    const scenario = new ScenarioPicker(store_, actions).root;
    const groups = new GroupChips(store_, actions, orders).root;
    const layers = new LayerBar(store_, actions).root;
    const directing = new DirectorsPanel(store_, directors).root;
    this.formations_ = new FormationPanel(store_, actions);
    this.playback_ = new PlaybackBar(store_, actions);
    this.readout_ = new Readout(store_, actions);
    const phone = new PhoneBar(
      store_,
      actions,
      () => this.playback_.chooseFile(),
      () => this.playback_.chooseCharacter(),
    ).root;
    const sheet = element('div', { class: 'sheet' }, this.formations_.root, element('hr'), this.playback_.root);
    this.orders_ = new OrdersPanel(store_, orders).root;
    const queue = new QueueBar(store_, orders).root;
    const hint = new HintBar(store_, actions).root;
    const legend = new LegendPanel(store_).root;
    const header = element('header', { class: 'contents' }, scenario, groups, layers, directing, phone);
    const banners = bannersOf(store_, actions);
    const empty = new EmptyPanel(store_, actions).root;
    const main = element(
      'div',
      { class: 'contents', role: 'region', 'aria-label': 'Tools' },
      banners,
      empty,
      hint,
      sheet,
      this.orders_,
      queue,
      legend,
      this.readout_.root,
      this.scale.root,
      ...[new ViewBar(store_, actions), new CrowdArrows(store_, actions)].map(({ root }) => root),
    );
    this.page_.append(
      header,
      main,
      this.live.root,
      new HelpDialog(store_, actions, shortcuts).root,
      new SchemeDialog(store_, actions).root,
      new CleanPicture(store_, actions).root,
      new Tooltip(document).root,
    );
    pressWithExtraFingers(this.page_);
    store_.watch(['link', 'loaded'], (state) => {
      for (const panel of [scenario, sheet, empty, this.orders_, queue]) panel.inert = isLost(state);
    });
    this.panels_ = [scenario, groups, layers, phone, sheet, this.readout_.root];
  }

  /** What the panels cover; fits keep clear of it. */
  padding(): Padding {
    const { layout } = this.store_.state;
    const height = window.innerHeight;
    const boxes = this.panels_.map((panel) => panel.getBoundingClientRect()).filter((box) => box.height > 0);
    // On phones the groups and figures stand on the sheet.
    const [above, below] = [boxes.filter((box) => box.top < height / 2), boxes.filter((box) => box.top >= height / 2)];
    const top = Math.max(0, ...above.map((box) => box.bottom)) + kHeadroom;
    if (layout === 'desktop' || layout === 'landscape') {
      const left = this.formations_.root.getBoundingClientRect().right + 12;
      const right = layout === 'desktop' ? this.besideOrders() : this.beside(this.playback_.root);
      return {
        top,
        right,
        bottom: Math.max(kFoot, height - this.readout_.root.getBoundingClientRect().top + 12),
        left,
      };
    }
    const right = layout === 'short' ? 24 : this.besideOrders();
    return { top, right, bottom: height - Math.min(height, ...below.map((box) => box.top)) + 24, left: 14 };
  }

  private beside(panel: HTMLElement): number {
    return window.innerWidth - panel.getBoundingClientRect().left + 12;
  }

  /** Before the first scene, and on phones below a message, the orders are hidden. */
  private besideOrders(): number {
    return this.orders_.getClientRects().length === 0 ? 24 : this.beside(this.orders_);
  }
}
