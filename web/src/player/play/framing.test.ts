import { describe, expect, it } from 'vitest';
import { loadCrowd } from '../file/loaded_crowd';
import { madeFile, type MadeSample } from '../file/test_support';
import { Follower, wholeAim } from './framing';
import { ViewCamera } from './view_camera';

const soon = (): Promise<void> => Promise.resolve();

describe('framing', () => {
  it('goes with a crowd that walks away, smoothly, and sees all of it from afar otherwise', async () => {
    // Ten people go 80 m in twenty seconds, after five in which they stand.
    const frames = Array.from({ length: 251 }, (_, k): MadeSample[] =>
      Array.from({ length: 10 }, (_, i) => ({ id: i + 1, x: 80 * Math.max(0, k - 50), y: 300 * i })),
    );
    const loaded = await loadCrowd(madeFile(frames), soon);
    const camera = new ViewCamera(loaded.head.camera);
    const whole = wholeAim(loaded, camera);
    expect(whole.x).toBeGreaterThan(30);
    expect(whole.x).toBeLessThan(50);
    const follower = new Follower(loaded, camera);
    expect(Math.abs(follower.at(0).x)).toBeLessThan(3);
    expect(Math.abs(follower.at(15).x - 40)).toBeLessThan(4);
    expect(follower.at(15).distance).toBeLessThan(0.8 * whole.distance);
    let last = follower.at(0);
    for (let time = 0; time <= 25; time += 0.02) {
      const now = follower.at(time);
      // People walk at 4 m/s.
      expect(Math.hypot(now.x - last.x, now.y - last.y)).toBeLessThan(0.02 * 6);
      last = now;
    }
  });

  it('looks at the ground where nobody is', async () => {
    const loaded = await loadCrowd(madeFile([[], []]), soon);
    const aim = wholeAim(loaded, new ViewCamera(loaded.head.camera));
    expect(aim).toEqual({ x: 0, y: 0, distance: 40 });
    expect(new Follower(loaded, new ViewCamera(loaded.head.camera)).at(0.1).distance).toBeGreaterThan(20);
  });
});
