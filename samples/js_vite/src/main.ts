// A hundred people as discs: click to send them, drag to draw the front that they take up.

import type { Vec2 } from 'muster-engine';
import { Crowd, kBox, kPillars } from './crowd';

const canvas = document.querySelector<HTMLCanvasElement>('#ground')!;
const line = document.querySelector<HTMLOutputElement>('#line')!;
const picture = canvas.getContext('2d')!;
const crowd = await Crowd.make();

/** Pixels per metre; the middle of the ground is in the middle of the canvas, y points up. */
let scale = 1;
let drawn: { from: Vec2; to: Vec2 } | null = null;

function fit(): void {
  const sharp = window.devicePixelRatio;
  canvas.width = canvas.clientWidth * sharp;
  canvas.height = canvas.clientHeight * sharp;
  scale = Math.min(canvas.width / (kBox.max.x - kBox.min.x), canvas.height / (kBox.max.y - kBox.min.y));
}

function groundAt(event: PointerEvent): Vec2 {
  const sharp = window.devicePixelRatio;
  return {
    x: (event.clientX * sharp - canvas.width / 2) / scale,
    y: (canvas.height / 2 - event.clientY * sharp) / scale,
  };
}

function disc(x: number, y: number, radius: number): void {
  picture.beginPath();
  picture.arc(x, y, radius, 0, 2 * Math.PI);
  picture.fill();
}

function draw(): void {
  picture.setTransform(1, 0, 0, 1, 0, 0);
  picture.clearRect(0, 0, canvas.width, canvas.height);
  picture.setTransform(scale, 0, 0, -scale, canvas.width / 2, canvas.height / 2);
  picture.fillStyle = '#ffffff';
  picture.fillRect(kBox.min.x, kBox.min.y, kBox.max.x - kBox.min.x, kBox.max.y - kBox.min.y);
  picture.fillStyle = '#90a4ae';
  for (const { centre, radius } of kPillars) disc(centre.x, centre.y, radius);
  // Views of the engine's own arrays, valid until the next step.
  const { position, heading, count } = crowd.world.characters();
  for (let k = 0; k < count; k += 1) {
    const [x, y] = [position[2 * k]!, position[2 * k + 1]!];
    picture.fillStyle = '#1565c0';
    disc(x, y, 0.3);
    picture.fillStyle = '#ffffff';
    disc(x + 0.16 * heading[2 * k]!, y + 0.16 * heading[2 * k + 1]!, 0.08);
  }
  if (!drawn) return;
  picture.strokeStyle = '#ef6c00';
  picture.lineWidth = 0.15;
  picture.beginPath();
  picture.moveTo(drawn.from.x, drawn.from.y);
  picture.lineTo(drawn.to.x, drawn.to.y);
  picture.stroke();
}

function tell(): void {
  const { x, y } = crowd.centre();
  line.textContent = `100 people at ${x.toFixed(1)}, ${y.toFixed(1)}. Click to send them, drag to draw a front.`;
}

canvas.addEventListener('pointerdown', (event) => {
  canvas.setPointerCapture(event.pointerId);
  drawn = { from: groundAt(event), to: groundAt(event) };
});
canvas.addEventListener('pointermove', (event) => {
  if (drawn) drawn.to = groundAt(event);
});
canvas.addEventListener('pointerup', () => {
  if (drawn) crowd.send(drawn.from, drawn.to);
  drawn = null;
});
window.addEventListener('resize', fit);

let last = performance.now();
function frame(now: number): void {
  crowd.advance((now - last) / 1000);
  last = now;
  draw();
  tell();
  requestAnimationFrame(frame);
}

fit();
requestAnimationFrame(frame);
