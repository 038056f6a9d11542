import { describe, expect, it } from 'vitest';
import type { Vec2 } from '../../protocol/generated/commands';
import { areaOf, kMoves, sceneOf } from '../../protocol/test_scene';
import { CameraController } from '../camera/camera_controller';
import { MarkState } from './mark_state';
import { paletteOf } from '../drawing/palette';
import { areaWords, chipTags, overlayTags, patchTags, patchWords, type TagScene, once } from './scene_tags';
import { madeControl, madeGroup } from '../../model/test_frames';

function view(now: number, more: Partial<TagScene> = {}): TagScene {
  const camera = new CameraController();
  camera.resize(1280, 800);
  camera.setPose({ targetX: 0, targetY: 0, distance: 40, turn: 0, pitch: 0.8 });
  return {
    camera,
    palette: paletteOf('light'),
    colours: [0, 1],
    now,
    moving: [],
    areas: [],
    time: 0,
    overlay: null,
    contours: [],
    chosenGroup: 1,
    ...more,
  };
}

const kScene = sceneOf({
  box: { min: [-10, -10], max: [10, 10] },
  clips: [
    { name: 'run', speed: 1 },
    { name: 'crawl', speed: 0.21 },
  ],
  patches: [
    {
      id: 1,
      name: 'Net',
      polygon: [
        [0, 0],
        [2, 0],
        [2, 2],
        [0, 2],
      ],
      motion: 1,
      speed: 0.21,
    },
    {
      id: 2,
      name: 'Far',
      polygon: [
        [900, 0],
        [902, 0],
        [902, 2],
      ],
      motion: 1,
      speed: 0.21,
    },
    {
      id: 3,
      name: 'Drift',
      polygon: [
        [0, 0],
        [2, 0],
        [2, 2],
        [0, 2],
      ],
      motion: 1,
      speed: 0.21,
      path: kMoves,
    },
  ],
});

describe('tags', () => {
  it('name patches in view, above their object', () => {
    const tags = patchTags({ ...kScene, patches: kScene.patches.slice(0, 2) }, view(0));
    expect(tags.map((tag) => tag.key)).toEqual(['patch:1']);
    expect(tags[0]).toMatchObject({ text: 'Net', detail: 'crawl' });
    const corner = view(0).camera.worldToScreen(1, 2, 1.1);
    expect(tags[0]?.at.y).toBeLessThan(corner.y);
    const run = { name: 'run', speed: 1 };
    expect(patchWords('', run, 1)).toEqual({ text: 'run', detail: '' });
    expect(patchWords('run', run, 1.5)).toEqual({ text: 'run', detail: '150 % of running speed' });
    expect(patchWords('Mud', run, 0.5)).toEqual({ text: 'Mud', detail: 'run, 50 % of running speed' });
  });

  it('follow patches that move', () => {
    const drift = { ...kScene, patches: kScene.patches.slice(2) };
    const still = patchTags(drift, view(0))[0];
    const moved = patchTags(drift, view(0, { moving: [{ kind: 1, id: 3, x: 4, y: 0, angle: 0 }] }))[0];
    expect((moved?.at.x ?? 0) - (still?.at.x ?? 0)).toBeGreaterThan(50);
  });

  it('do not repeat themselves side by side', () => {
    const tag = (key: string, text: string, x: number, y: number) => ({
      key,
      kind: 'patch' as const,
      text,
      at: { x, y },
    });
    const kept = once([
      tag('a', 'Net', 0, 100),
      tag('b', 'Pool', 40, 110),
      tag('c', 'Net', 200, 60),
      tag('area:1', 'Pool', 200, 60),
    ]);
    expect(kept.map((one) => one.key)).toEqual(['a', 'b', 'area:1']);
  });

  it('name a control for 1.2 s, anew where it grows', () => {
    const marks = new MarkState();
    const show = (kind: number, now: number) => {
      const handles = [
        [0, 0],
        [1, 0],
        [1, 1],
      ].slice(0, kind + 1) as [number, number][];
      marks.update([madeGroup(1, [madeControl(1, kind, handles)])], now);
      return chipTags(marks, view(now)).map((tag) => tag.text);
    };
    expect(show(0, 0)).toEqual(['Point']);
    expect(show(0, 1300)).toEqual([]);
    expect(show(1, 1400)).toEqual(['Line']);
    expect(show(2, 1500)).toEqual(['Area']);
    expect(show(2, 2800)).toEqual([]);
  });

  it('name the chosen character and its place in the group colour', () => {
    const overlay = {
      kind: 2,
      character: 30,
      x: 0,
      y: 0,
      cell: 1,
      width: 1,
      height: 1,
      values: [0],
      path: [0, 0, 3, 3],
    };
    const tags = overlayTags(view(0, { overlay, contours: [{ text: '5', x: 1, y: 1 }] }));
    expect(tags.map((tag) => tag.text)).toEqual(['5', 'Character 30', 'Its place']);
    expect(tags[1]?.fill).toBe(paletteOf('light').accents.ember);
    expect(overlayTags(view(0))).toEqual([]);
  });
});

describe('tags of areas', () => {
  it('say what an area is, whether it is closed, and how many have passed', () => {
    const area = areaOf({ id: 1, kind: 'exit' });
    const none = { passed: 0, waiting: 0 };
    expect(areaWords(area, none)).toEqual({ text: 'Exit', detail: '' });
    expect(areaWords({ ...area, name: 'Door', open: false }, { passed: 24, waiting: 0 })).toEqual({
      text: 'Door',
      detail: 'closed, 24 out',
    });
    const timed = { ...area, from: 30, until: 90 };
    expect([0, 30, 90].map((time) => areaWords(timed, none, time).detail)).toEqual(['opens at 0:30.0', '', 'closed']);
    const source = areaWords({ ...area, kind: 'source' }, { passed: 3, waiting: 2 });
    expect(source).toEqual({ text: 'Source', detail: '3 in, 2 have no room' });
  });

  it('stay beside each other where they have the same words', () => {
    const square = (x: number): Vec2[] => [
      [x, 0],
      [x + 2, 0],
      [x + 2, 2],
      [x, 2],
    ];
    const areas = [-8, 8].map((x, k) => ({ id: k + 1, kind: 'waiting' as const, polygon: square(x) }));
    const scene = sceneOf({ box: { min: [-10, -10], max: [10, 10] }, areas });
    expect(patchTags(scene, view(0)).map(({ key }) => key)).toEqual(['area:1', 'area:2']);
  });

  it('tell both speeds of stairs', () => {
    const patch = { ...kScene.patches[0]!, name: '', speed: 0.5, ascent: 1, speedDown: 0.7 };
    const [tag] = patchTags({ ...kScene, patches: [patch] }, view(0));
    expect(tag).toMatchObject({ text: 'Stairs', detail: 'up 50 %, down 70 % of running speed' });
  });
});
