// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { CameraPose } from '../../scene/camera/camera_controls';
import { FilmCameraController } from './film_camera_controller';

let pose: CameraPose;
let changed: ReturnType<typeof vi.fn>;
const camera = {
  get pose() {
    return pose;
  },
  glideToPose: (next: CameraPose) => {
    pose = { ...next };
  },
};
const controller = (): FilmCameraController => new FilmCameraController(camera, changed);
const at = (targetX: number): CameraPose => ({ targetX, targetY: 0, distance: 10, turn: 0, pitch: 1 });

beforeEach(() => {
  window.localStorage.clear();
  pose = at(0);
  changed = vi.fn();
});

it('leads the view along its keys, and lets go when it is switched off', () => {
  const film = controller();
  film.open('a.take');
  film.observe(10);
  expect(pose.targetX).toBe(0);
  pose = at(4);
  film.keep(0);
  pose = at(8);
  film.keep(100);
  expect(film.on).toBe(true);
  film.observe(50);
  expect(pose.targetX).toBeCloseTo(6);
  film.switch(false);
  pose = at(99);
  film.observe(60);
  expect(pose.targetX).toBe(99);
  film.switch(true);
  film.observe(100);
  expect(pose.targetX).toBe(8);
});

it('keeps the keys of each take, also for another page', () => {
  const film = controller();
  film.open('a.take');
  film.keep(30);
  film.open('b.take');
  expect(film.keys).toEqual([]);
  expect(film.on).toBe(false);
  const later = controller();
  later.open('a.take');
  expect(later.keys.map(({ step }) => step)).toEqual([30]);
  expect(later.on).toBe(true);
  later.remove(30);
  expect(later.on).toBe(false);
  later.open('');
  later.keep(5);
  expect(later.keys).toEqual([]);
});

it('tells of every change', () => {
  const film = controller();
  film.open('a.take');
  film.open('a.take');
  film.keep(30);
  film.switch(false);
  expect(changed).toHaveBeenCalledTimes(3);
});
