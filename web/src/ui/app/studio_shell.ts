// Puts the panels on the page.

import type { Shortcut } from '../../tools/shortcuts';
import { LostBanner } from './lost_banner';
import { NoticeBanner } from './notice_banner';
import { element } from '../widgets/dom';
import { CleanPicture } from './clean_picture';
import { CrowdArrows } from '../steer/crowd_arrows';
import { DirectorsPanel } from '../directors/directors_panel';
import type { DirectorActions } from '../../model/directors';
import { EmptyPanel } from '../places/empty_panel';
import { pressWithExtraFingers } from '../widgets/extra_finger_press';
import { FormationPanel } from '../formations/formation_panel';
import { GroupChips } from '../steer/group_chips';
import { HintBar } from './hint_bar';
import { LayerBar } from '../steer/layer_bar';
import { guardBackdrops } from '../widgets/backdrop_press';
import { LegendPanel } from '../steer/legend_panel';
import { LiveRegion } from '../widgets/live_region';
import { pageDialogs } from './page_dialogs';
import { PhoneBar } from './phone_bar';
import { Readout } from '../steer/readout';
import { ScaleBar } from '../steer/scale_bar';
import { SchemeBanner } from '../steer/scheme_banner';
import { SheetTabs } from './sheet_tabs';
import { ScenarioPicker } from '../places/scenario_picker';
import type { PanelName } from '../../model/panel_places';
import type { OrderActions } from '../../model/order_actions';
import { OrdersPanel } from '../orders/orders_panel';
import { QueueBar } from '../orders/queue_bar';
import type { StudioActions } from '../../model/studio_actions';
import { isLost } from '../../model/studio_state';
import { ViewBar } from '../steer/view_bar';
import { WatchBanner } from '../steer/watch_banner';
import { PanelLayout } from '../widgets/panel_layout';
import { Tooltip } from '../widgets/tooltip';
import { PlaybackBar } from '../takes/playback_bar';
import type { Padding } from '../../scene/camera/camera_controls';
import { kHeadroom } from '../../scene/camera/view_fitter';
import type { StudioStore } from '../../model/studio_store';

/** The queue and the hint stand at the lower edge of wide windows: fits leave room for them [px]. */
const kFoot = 176;
/** Between a panel and the crowd, and at sides without panels [px]. */
const kGap = 12;
const kSide = 14;

/** At the upper and the lower edge. */
const kEdges: readonly PanelName[] = ['scenario', 'groups', 'layers', 'phone-bar', 'readout'];
/** What can do nothing without the server. */
const kNeedServer: readonly PanelName[] = [
  'scenario',
  'groups',
  'directors',
  'formations',
  'playback',
  'empty',
  'orders',
  'queue',
  'sequence',
  'try',
  'build',
  'paths',
  'time-line',
  'take-card',
];

/** What tells of losses, messages and a control that is in use, below each other. */
function bannersOf(store: StudioStore, actions: StudioActions): HTMLElement {
  return element(
    'div',
    { class: 'banners' },
    new LostBanner(store, actions).root,
    new NoticeBanner(store, actions).root,
    new SchemeBanner(store, actions).root,
    new WatchBanner(store, actions).root,
  );
}

export class StudioShell {
  readonly scale = new ScaleBar();
  readonly live = new LiveRegion();
  private readonly layout_: PanelLayout;

  constructor(
    private readonly page_: HTMLElement,
    private readonly store_: StudioStore,
    actions: StudioActions,
    orders: OrderActions,
    directors: DirectorActions,
    shortcuts: readonly Shortcut[],
  ) {
    this.layout_ = PanelLayout.of(page_);
    const playback = new PlaybackBar(store_, actions);
    const phone = new PhoneBar(
      store_,
      actions,
      orders,
      () => playback.chooseFile(),
      () => playback.chooseCharacter(),
    );
    const panels: Partial<Record<PanelName, HTMLElement>> = {
      scenario: new ScenarioPicker(store_, actions).root,
      groups: new GroupChips(store_, actions, orders).root,
      layers: new LayerBar(store_, actions).root,
      directors: new DirectorsPanel(store_, directors).root,
      'phone-bar': phone.root,
      formations: new FormationPanel(store_, actions).root,
      playback: playback.root,
      orders: new OrdersPanel(store_, orders).root,
      queue: new QueueBar(store_, orders).root,
      hint: new HintBar(store_, actions).root,
      legend: new LegendPanel(store_).root,
      readout: new Readout(store_, actions).root,
      scale: this.scale.root,
      'view-bar': new ViewBar(store_, actions).root,
      tabs: new SheetTabs(store_, this.layout_.area('sheet')).root,
      banners: bannersOf(store_, actions),
      empty: new EmptyPanel(store_, actions).root,
    };
    for (const [name, panel] of Object.entries(panels) as [PanelName, HTMLElement][]) this.layout_.add(name, panel);
    this.page_.append(
      new CrowdArrows(store_, actions).root,
      ...playback.inputs,
      this.live.root,
      pageDialogs(store_, actions, shortcuts),
      new CleanPicture(store_, actions).root,
      new Tooltip(document).root,
    );
    pressWithExtraFingers(this.page_);
    guardBackdrops(document);
    store_.watch(['layout'], ({ layout }) => this.layout_.show(layout));
    store_.watch(['link', 'loaded'], (state) => {
      this.layout_.setInert(isLost(state) ? kNeedServer : []);
    });
  }

  /** What the panels cover; fits keep clear of it. */
  padding(): Padding {
    const { layout } = this.store_.state;
    const height = window.innerHeight;
    const wide = layout === 'desktop' || layout === 'landscape';
    const boxOf = (panel: HTMLElement | undefined): DOMRect | null => {
      const box = panel?.getBoundingClientRect();
      return box && box.height > 0 ? box : null;
    };
    const edge = (name: PanelName): DOMRect | null => boxOf(this.layout_.panel(name));
    const boxes = kEdges.map(edge).filter((box) => box !== null);
    const above = boxes.filter((box) => box.top < height / 2);
    const below = boxes.filter((box) => box.top >= height / 2);
    const sheet = boxOf(this.layout_.area('sheet'));
    const hint = edge('hint');
    const top = Math.max(0, ...above.map((box) => box.bottom)) + kHeadroom;
    const foot = height - Math.min(height, sheet?.top ?? height, hint?.top ?? height, ...below.map((box) => box.top));
    const [left, right] = [edge('formations')?.right ?? 0, edge(layout === 'landscape' ? 'playback' : 'orders')?.left];
    return {
      top,
      right: layout === 'phone' ? kSide : right === undefined ? 2 * kGap : window.innerWidth - right + kGap,
      bottom: wide ? Math.max(kFoot, foot + kGap) : foot + 2 * kGap,
      left: wide ? left + kGap : kSide,
    };
  }
}
