// On the first visit a hand shows once how to drag: it takes the formation by its middle and draws a way ahead. It only
// shows; nothing moves by it. Any press or key ends it.

import type { GroundPoint, ScreenPoint } from '../../model/plane';
import type { StudioStore } from '../../model/studio_store';
import { element } from '../widgets/dom';
import { accentVariable } from '../widgets/group_marks';

/** Before it comes, and how long it drags and fades [ms]. */
const kTimes = { wait: 1500, press: 350, drag: 2000, fade: 450 };
/** How far it drags [m]. */
const kWay = 7;
const kSvg = 'http://www.w3.org/2000/svg';
const kHand =
  '<path d="M10 2.500c1.500 0 2.500 1.100 2.500 2.500v7l6.800 1.300c2 .4 3.100 1.900 2.800 3.800l-1 6.400c-.3 1.900-1.700 3-3.600 3h-5.600c-1.400 0-2.500-.5-3.400-1.600l-5.700-6.900c-.9-1.100-.8-2.400.1-3.200.9-.7 2.200-.6 3.100.4l1.500 1.700V5c0-1.400 1-2.500 2.500-2.500Z" stroke-linejoin="round"/>';

export interface GhostScene {
  worldToScreen(point: GroundPoint): ScreenPoint;
}

/** Where the active group is and how it faces; null while there is none. */
export type GhostSpot = () => { readonly x: number; readonly y: number; readonly facing: number } | null;

/** A way that swings a little to its left, from a spot ahead. */
export function ghostWay({ x, y, facing }: { x: number; y: number; facing: number }, share: number): GroundPoint {
  const along = kWay * share;
  const aside = 1.6 * Math.sin(Math.PI * share);
  const [c, s] = [Math.cos(facing), Math.sin(facing)];
  return { x: x + c * along - s * aside, y: y + s * along + c * aside };
}

export class GhostHand {
  private readonly line_ = document.createElementNS(kSvg, 'polyline');
  private readonly ring_ = element('span', { class: 'ghost-ring' });
  private readonly hand_ = document.createElementNS(kSvg, 'svg');
  private readonly root_ = element('div', { class: 'ghost', 'aria-hidden': 'true' });
  private started_ = 0;
  private from_: { x: number; y: number; facing: number } | null = null;

  constructor(
    page: HTMLElement,
    private readonly store_: StudioStore,
    private readonly scene_: GhostScene,
    private readonly spot_: GhostSpot,
  ) {
    if (!store_.state.hint || window.matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    const lines = document.createElementNS(kSvg, 'svg');
    lines.setAttribute('class', 'ghost-line');
    lines.append(this.line_);
    this.hand_.setAttribute('viewBox', '0 0 24 28');
    this.hand_.setAttribute('class', 'ghost-hand');
    this.hand_.innerHTML = kHand;
    this.root_.append(lines, this.ring_, this.hand_);
    page.append(this.root_);
    for (const type of ['pointerdown', 'keydown', 'wheel']) window.addEventListener(type, this.end, { passive: true });
    requestAnimationFrame(this.tick);
  }

  private readonly end = (): void => {
    this.root_.remove();
    for (const type of ['pointerdown', 'keydown', 'wheel']) window.removeEventListener(type, this.end);
  };

  private readonly tick = (now: number): void => {
    if (!this.root_.isConnected) return;
    requestAnimationFrame(this.tick);
    const spot = this.spot_();
    if (this.started_ === 0 && spot) this.started_ = now;
    const gone = this.started_ === 0 ? -1 : now - this.started_ - kTimes.wait;
    if (gone < 0) return;
    if (gone > kTimes.press + kTimes.drag + kTimes.fade) return this.end();
    this.from_ ??= spot;
    if (this.from_) this.show(this.from_, gone);
  };

  private show(from: { x: number; y: number; facing: number }, gone: number): void {
    const { groups, active } = this.store_.state;
    this.root_.style.setProperty('--accent', accentVariable(groups[active]?.colour ?? 0));
    const t = Math.min(1, Math.max(0, (gone - kTimes.press) / kTimes.drag));
    const share = t * t * (3 - 2 * t);
    const at = this.scene_.worldToScreen(ghostWay(from, share));
    const points = Array.from({ length: 25 }, (_, i) => this.scene_.worldToScreen(ghostWay(from, (share * i) / 24)));
    this.line_.setAttribute('points', points.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' '));
    const pressed = Math.min(1, gone / kTimes.press);
    const left = Math.min(1, (kTimes.press + kTimes.drag + kTimes.fade - gone) / kTimes.fade);
    this.ring_.style.transform = `translate(${at.x - 22}px, ${at.y - 22}px) scale(${0.5 + 0.5 * pressed})`;
    this.hand_.style.transform = `translate(${at.x - 14}px, ${at.y - 4 + 18 * (1 - pressed)}px)`;
    this.root_.style.opacity = String(Math.min(pressed, left));
  }
}
