import { describe, expect, it } from 'vitest';
import { CameraController } from '../../scene/camera/camera_controller';
import { BoundsBuilder } from '../../scene/camera/bounds_builder';
import { FollowCamera, type Following, type WatchedFrame } from './follow_camera';

const kPadding = { top: 100, right: 150, bottom: 120, left: 170 };

function made() {
  const camera = new CameraController();
  camera.resize(1280, 800);
  camera.setWorld(-500, -500, 500, 500);
  camera.open();
  const fits: number[] = [];
  const told: Following[] = [];
  const follow = new FollowCamera(
    {
      camera,
      worldToScreen: (point) => camera.worldToScreen(point.x, point.y),
      outline: (positions) => {
        const bounds = new BoundsBuilder();
        bounds.addAll(positions);
        return bounds.outline();
      },
      size: () => ({ width: 1280, height: 800 }),
      padding: () => kPadding,
    },
    () => fits.push(1),
    (following) => told.push(following),
  );
  return { camera, follow, fits, told };
}

/** Thirty-six people in a square about (x, y), `spread` m apart. */
function frame(step: number, x: number, y: number, demonstrating: boolean, spread = 1): WatchedFrame {
  const xs = Array.from({ length: 36 }, (_, i) => x + spread * ((i % 6) - 2.5));
  const ys = Array.from({ length: 36 }, (_, i) => y + spread * (Math.floor(i / 6) - 2.5));
  return { step, time: step / 60, demonstrating, x: xs, y: ys, group: step === 1 ? xs.map((_, i) => i % 2) : [] };
}

function shareInView(camera: CameraController, { x, y }: WatchedFrame): number {
  let inside = 0;
  for (let i = 0; i < x.length; ++i) {
    const at = camera.worldToScreen(x[i]!, y[i]!);
    if (at.x > 0 && at.y > 0 && at.x < 1280 && at.y < 800) inside += 1;
  }
  return inside / x.length;
}

describe('FollowCamera', () => {
  it('keeps a watched crowd in view as it runs off and spreads, also after the last finger has lifted', () => {
    const { camera, follow } = made();
    let least = 1;
    for (let step = 1; step <= 1200; ++step) {
      const now = frame(step, step * 0.1, 0.4 * Math.sin(step), step < 300, 1 + step / 240);
      follow.observe(now, step * 16.7);
      if (step > 20) least = Math.min(least, shareInView(camera, now));
    }
    expect(least).toBeGreaterThanOrEqual(0.9);
    expect(follow.following).toBe('watching');
  });

  it('ends when everybody stands, not while somebody still walks', () => {
    const { follow, told } = made();
    for (let step = 1; step <= 100; ++step) follow.observe(frame(step, step * 0.1, 0, true), step * 16.7);
    for (let step = 101; step <= 400; ++step) follow.observe(frame(step, step * 0.1, 0, false), step * 16.7);
    expect(follow.following).toBe('watching');
    for (let step = 401; step <= 800; ++step) follow.observe(frame(step, 40, 0, false), step * 16.7);
    expect(follow.following).toBe('no');
    expect(told).toEqual(['watching', 'no']);
  });

  it('leaves the camera to the visitor who moves it', () => {
    const { camera, follow } = made();
    follow.observe(frame(1, 0, 0, true), 16);
    follow.release();
    const before = { ...camera.pose };
    for (let step = 2; step < 200; ++step) follow.observe(frame(step, step, 0, true), step * 16.7);
    expect(camera.pose).toEqual(before);
  });

  it('does not move the ground under a finger', () => {
    const { camera, follow } = made();
    follow.toggle();
    const before = { ...camera.pose };
    for (let step = 1; step < 100; ++step) {
      follow.rest(step * 16.7);
      follow.observe(frame(step, step, 0, false), step * 16.7);
    }
    expect(camera.pose).toEqual(before);
    for (let step = 100; step < 200; ++step) follow.observe(frame(step, 100, 0, false), step * 16.7);
    expect(camera.pose.targetX).toBeGreaterThan(60);
  });

  it('follows for as long as it is wanted, one group alone where that was framed', () => {
    const { camera, follow, fits } = made();
    follow.toggle();
    expect(fits.length).toBe(1);
    const split = (step: number): WatchedFrame => {
      const one = frame(step, 0, 0, false);
      return { ...one, x: Array.from(one.x, (x, i) => (i % 2 === 0 ? x - 60 : x + 60)) };
    };
    for (let step = 1; step < 300; ++step) follow.observe(split(step), step * 16.7);
    expect(Math.abs(camera.pose.targetX)).toBeLessThan(15);
    follow.watchAlone(1);
    for (let step = 300; step < 900; ++step) follow.observe(split(step), step * 16.7);
    expect(camera.pose.targetX).toBeGreaterThan(45);
    expect(follow.following).toBe('wanted');
    follow.toggle();
    expect(follow.following).toBe('no');
  });

  it('fits the view when the crowd is back at the start', () => {
    const { follow, fits } = made();
    for (let step = 1; step < 300; ++step) follow.observe(frame(step, step * 0.2, 0, true), step * 16.7);
    follow.observe(frame(0, 0, 0, false), 5100);
    expect(fits.length).toBe(1);
    expect(follow.following).toBe('no');
  });
});
