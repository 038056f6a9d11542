// Places as a picture of dots, each as large as a body.

import { Component, type VNode } from 'preact';
import type { GroundPoint } from '../../model/plane';

export interface PlaceDotsProps {
  /** x to the right, y up [m]. */
  readonly places: readonly GroundPoint[];
  /** Of a body [m]. */
  readonly radius: number;
  /** [CSS px] */
  readonly width: number;
  readonly height: number;
  readonly class?: string;
}

/** Free round the dots [CSS px], and the least radius of one. */
const kMargin = 8;
const kLeast = 0.8;

function draw(canvas: HTMLCanvasElement, { places, radius, width, height }: PlaceDotsProps): void {
  const ratio = Math.min(2, window.devicePixelRatio || 1);
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  const pen = canvas.getContext('2d');
  if (!pen || places.length === 0) return;
  const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
  const [left, right] = [Math.min(...xs) - radius, Math.max(...xs) + radius];
  const [low, high] = [Math.min(...ys) - radius, Math.max(...ys) + radius];
  const room = Math.min((width - 2 * kMargin) / (right - left), (height - 2 * kMargin) / (high - low));
  // A few people are not drawn as giants.
  const scale = Math.min(room, kMargin / radius);
  pen.setTransform(ratio, 0, 0, ratio, (width / 2) * ratio, (height / 2) * ratio);
  pen.fillStyle = getComputedStyle(canvas).color;
  for (const { x, y } of places) {
    pen.beginPath();
    const at = [scale * (x - (left + right) / 2), -scale * (y - (low + high) / 2)] as const;
    pen.arc(...at, Math.max(kLeast, scale * radius), 0, 2 * Math.PI);
    pen.fill();
  }
}

export class PlaceDots extends Component<PlaceDotsProps> {
  private canvas_: HTMLCanvasElement | null = null;

  override componentDidMount(): void {
    if (this.canvas_) draw(this.canvas_, this.props);
  }

  override componentDidUpdate(): void {
    this.componentDidMount();
  }

  override render({ class: name }: PlaceDotsProps): VNode {
    return <canvas class={name} aria-hidden="true" ref={(made) => void (this.canvas_ = made)} />;
  }
}
