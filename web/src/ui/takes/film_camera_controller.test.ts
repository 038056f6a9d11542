// @vitest-environment jsdom
import { beforeEach, expect, it, vi } from 'vitest';
import type { CameraPose } from '../../scene/camera/camera_controls';
import type { CameraKey } from '../../scene/camera/film_camera';
import { FilmCameraController } from './film_camera_controller';

let pose: CameraPose;
let changed: ReturnType<typeof vi.fn<() => void>>;
let kept: (readonly CameraKey[])[];
const camera = {
  get pose() {
    return pose;
  },
  glideToPose: (next: CameraPose) => {
    pose = { ...next };
  },
};
const controller = (): FilmCameraController =>
  new FilmCameraController({ camera, changed, keep: (keys) => kept.push(keys) });
const at = (targetX: number): CameraPose => ({ targetX, targetY: 0, distance: 10, turn: 0, pitch: 1 });

beforeEach(() => {
  window.localStorage.clear();
  pose = at(0);
  changed = vi.fn();
  kept = [];
});

it('leads the view along its keys, and lets go when it is switched off', () => {
  const film = controller();
  film.open('a.take', []);
  film.observe(10);
  expect(pose.targetX).toBe(0);
  pose = at(4);
  film.keep(0);
  pose = at(8);
  film.keep(100);
  expect(film.on).toBe(true);
  film.observe(50);
  expect(pose.targetX).toBeCloseTo(6);
  film.cut(100, true);
  film.observe(99);
  expect(pose.targetX).toBe(4);
  film.move(100, 60);
  film.observe(60);
  expect(pose.targetX).toBe(8);
  film.switch(false);
  pose = at(99);
  film.observe(50);
  expect(pose.targetX).toBe(99);
  film.switch(true);
  film.observe(100);
  expect(pose.targetX).toBe(8);
});

it('keeps its keys with the take, and those that the browser kept before', () => {
  const film = controller();
  film.open('a.take', []);
  film.keep(30);
  expect(kept.at(-1)!.map(({ step }) => step)).toEqual([30]);
  const keys = film.keys;
  film.open('b.take', []);
  expect(film.keys).toEqual([]);
  expect(film.on).toBe(false);
  film.open('c.take', keys);
  expect(film.on).toBe(true);
  // The same take, changed: whoever switched the camera off left it off.
  film.switch(false);
  film.open('c-2.take', [...keys]);
  expect([film.on, film.keys.length]).toEqual([false, 1]);
  window.localStorage.setItem('muster.film.old.take', JSON.stringify([{ step: 7, pose: at(1) }]));
  film.open('old.take', []);
  expect(kept.at(-1)!.map(({ step }) => step)).toEqual([7]);
  film.remove(7);
  expect(film.on).toBe(false);
  film.open(null, []);
  film.keep(5);
  expect(film.keys).toEqual([]);
});

it('tells of every change', () => {
  const film = controller();
  film.open('a.take', []);
  film.open('a.take', []);
  film.keep(30);
  film.switch(false);
  expect(changed).toHaveBeenCalledTimes(3);
});
