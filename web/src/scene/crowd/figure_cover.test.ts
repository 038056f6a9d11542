import { expect, it } from 'vitest';
import { CameraController } from '../camera/camera_controller';
import { coversFigure } from './figure_cover';

it('finds the figure whose body or face the mark would cover, not who stands on it or behind it', () => {
  const camera = new CameraController();
  camera.resize(1280, 800);
  camera.setPose({ targetX: 0, targetY: 0, distance: 30, turn: 0.4, pitch: 0.8 });
  const mark = { x: 1, y: 2 };
  const covers = (person: { x: number; y: number }): boolean =>
    coversFigure({ someoneNear: (x, y, r) => Math.hypot(x - person.x, y - person.y) < r }, camera, mark);
  // Someone whose face is where the mark is on the screen.
  const wanted = camera.worldToScreen(mark.x, mark.y);
  const { eye } = camera.basis();
  const share = 1.6 / eye[2];
  const person = { x: mark.x + (eye[0] - mark.x) * share, y: mark.y + (eye[1] - mark.y) * share };
  const face = camera.worldToScreen(person.x, person.y, 1.6);
  expect(Math.hypot(face.x - wanted.x, face.y - wanted.y)).toBeLessThan(0.5);
  expect(covers(person)).toBe(true);
  expect(covers(mark)).toBe(false);
  expect(covers({ x: 2 * mark.x - person.x, y: 2 * mark.y - person.y })).toBe(false);
});
