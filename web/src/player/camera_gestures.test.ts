// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from 'vitest';
import { CameraGestures } from './camera_gestures';
import { ViewCamera } from './play/view_camera';

const kHint = { turn: 0, pitch: 0.8, angle: 0.42 };

describe('CameraGestures', () => {
  let camera: ViewCamera | null;
  let whole = false;
  let moves = 0;
  let area: HTMLElement;

  beforeEach(() => {
    camera = new ViewCamera(kHint);
    camera.aim({ x: 0, y: 0, distance: 40 });
    [whole, moves] = [false, 0];
    area = document.createElement('div');
    area.setPointerCapture = (): void => undefined;
    Object.defineProperty(area, 'clientHeight', { value: 400 });
    new CameraGestures(area, {
      get camera() {
        return camera;
      },
      get whole() {
        return whole;
      },
      moved: () => ++moves,
    });
  });

  function send(type: string, more: Readonly<Record<string, unknown>>): boolean {
    const event = new MouseEvent(type, { bubbles: true, cancelable: true });
    for (const [name, value] of Object.entries({ pointerType: 'touch', pointerId: 1, ...more }))
      Object.defineProperty(event, name, { value });
    return area.dispatchEvent(event);
  }

  function drag(path: readonly (readonly [number, number])[], more: Readonly<Record<string, unknown>> = {}): void {
    path.forEach(([x, y], k) => send(k === 0 ? 'pointerdown' : 'pointermove', { clientX: x, clientY: y, ...more }));
    send('pointerup', more);
  }

  it('turns by a finger that goes across, not by one that goes up first', () => {
    drag([
      [100, 100],
      [102, 90],
      [104, 60],
      [105, 20],
    ]);
    expect(moves).toBe(0);
    drag([
      [100, 100],
      [112, 102],
      [200, 110],
    ]);
    expect(camera!.turn).toBeCloseTo((-3 * 100) / 400);
  });

  it('turns by a mouse at once, and by its first button only', () => {
    drag(
      [
        [100, 100],
        [101, 140],
      ],
      { pointerType: 'mouse', button: 0 },
    );
    expect(camera!.pitch).toBeCloseTo(0.8 + (1.6 * 40) / 400);
    moves = 0;
    drag(
      [
        [100, 100],
        [190, 140],
      ],
      { pointerType: 'mouse', button: 2 },
    );
    expect(moves).toBe(0);
  });

  it('moves the ground with Shift', () => {
    drag(
      [
        [100, 100],
        [140, 100],
      ],
      { pointerType: 'mouse', button: 0, shiftKey: true },
    );
    expect(camera!.turn).toBe(0);
    expect(camera!.target[0]).toBeCloseTo(-0.1 * 2 * Math.tan(0.21) * 40);
  });

  it('zooms by two fingers: twice as far apart is half as far away', () => {
    send('pointerdown', { pointerId: 1, clientX: 100, clientY: 100 });
    send('pointerdown', { pointerId: 2, clientX: 200, clientY: 100 });
    send('pointermove', { pointerId: 2, clientX: 300, clientY: 100 });
    expect(camera!.distance).toBeCloseTo(20);
    send('pointermove', { pointerId: 2, clientX: 100, clientY: 300 });
    expect(camera!.turn).toBeCloseTo(Math.PI / 2);
  });

  it('leaves the wheel to the page, but with Ctrl or when it fills the screen', () => {
    expect(send('wheel', { deltaY: -100, deltaMode: 0, ctrlKey: false })).toBe(true);
    expect(camera!.distance).toBe(40);
    expect(send('wheel', { deltaY: -100, deltaMode: 0, ctrlKey: true })).toBe(false);
    expect(camera!.distance).toBeLessThan(40);
    whole = true;
    expect(send('wheel', { deltaY: 100, deltaMode: 0, ctrlKey: false })).toBe(false);
    expect(camera!.distance).toBeCloseTo(40);
  });

  it('does nothing where the camera is fixed', () => {
    camera = null;
    drag([
      [100, 100],
      [200, 100],
    ]);
    expect(send('wheel', { deltaY: -100, deltaMode: 0, ctrlKey: true })).toBe(true);
    expect(send('keydown', { key: 'ArrowLeft' })).toBe(true);
    expect(moves).toBe(0);
  });

  it('is steered by keys and begins again with 0', () => {
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '0', '-']) expect(send('keydown', { key })).toBe(false);
    expect(camera!.distance).toBeCloseTo(46);
    expect(send('keydown', { key: 'x' })).toBe(true);
    expect(send('keydown', { key: '+', ctrlKey: true })).toBe(true);
  });
});
