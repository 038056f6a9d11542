// Chooses the words over the scene: names of patches and areas, kinds of controls, numbers of contours.

import type { ControlKind, SceneClip, SceneArea, ScenePatch } from '../../protocol/messages';
import { kKindNames } from '../../model/control_watch';
import type { Vec2 } from '../../protocol/generated/commands';
import { isMoving, type SceneFacts } from '../../protocol/scene';
import type { CameraController } from '../camera/camera_controller';
import type { MarkState } from './mark_state';
import type { ContourLabel } from '../ground/field_raster';
import { formatClock } from '../../model/formatters';
import type { AreaView, FrameView, MovingView, OverlayView } from '../../model/frame_view';
import { centroid } from '../drawing/geometry_builder';
import { accentColour, inkOn, type Palette } from '../drawing/palette';
import { heightOfLook, lookOfMotion } from '../patches/patch_geometry';
import { kAreaIcons, kMotionIcons, kStairsIcon, nearestFirst, type Tag } from './tag_layer';
import type { ScreenPoint } from '../../model/plane';

/** How long a chip names a control's kind [ms]. */
const kChipTime = 1200;
const kChipFade = 180;
/** Of a patch whose motion the scene does not have. */
const kNoClip: SceneClip = { name: '', speed: 1 };

export interface TagScene {
  readonly camera: CameraController;
  readonly palette: Palette;
  readonly colours: readonly number[];
  readonly now: number;
  readonly moving: readonly MovingView[];
  readonly areas: readonly AreaView[];
  /** Of the world [s]. */
  readonly time: number;
  readonly overlay: OverlayView | null;
  readonly contours: readonly ContourLabel[];
  readonly chosenGroup: number;
}

const percent = (speed: number): string => `${Math.round(100 * speed)} %`;

/** `Net` and `crawl`; with a speed of its own `Net` and `crawl, 50 % of running speed`. */
export function patchWords(name: string, clip: SceneClip, speed: number): { text: string; detail: string } {
  const own = speed > 0 && Math.abs(speed - clip.speed) > 0.005 ? [`${percent(speed)} of running speed`] : [];
  const named = name && name !== clip.name;
  return { text: named ? name : clip.name, detail: [...(named ? [clip.name] : []), ...own].join(', ') };
}

/** Of stairs both speeds: `Stairs` and `up 50 %, down 70 % of running speed`. */
function wordsOfPatch(
  { name, speed, ascent, speedDown }: ScenePatch,
  clip: SceneClip,
): { text: string; detail: string } {
  if (ascent === null) return patchWords(name, clip, speed);
  const up = speed > 0 ? speed : clip.speed;
  const down = speedDown > 0 ? speedDown : up;
  return { text: name || 'Stairs', detail: `up ${percent(up)}, down ${percent(down)} of running speed` };
}

const kAreaWords = {
  exit: { name: 'Exit', passed: 'out' },
  source: { name: 'Source', passed: 'in' },
  waiting: { name: 'Waiting area', passed: '' },
};

/** What tags of areas need of a frame. */
export function areasOf(frame: Pick<FrameView, 'areas' | 'time'> | null): Pick<TagScene, 'areas' | 'time'> {
  return { areas: frame?.areas ?? [], time: frame?.time ?? 0 };
}

/** Whether an exit is closed, or opens later; empty for others. */
function closedWords({ kind, open, from, until }: SceneArea, time: number): string[] {
  if (!open || (kind === 'exit' && time >= until)) return ['closed'];
  return kind === 'exit' && time < from ? [`opens at ${formatClock(from)}`] : [];
}

/** `Main door` and `24 out`. */
export function areaWords(
  area: SceneArea,
  { passed, waiting }: Omit<AreaView, 'id'>,
  time = 0,
): { text: string; detail: string } {
  const { name, kind } = area;
  const words = kAreaWords[kind];
  const parts = [
    ...closedWords(area, time),
    ...(passed > 0 ? [`${passed} ${words.passed}`] : []),
    ...(waiting > 0 ? [`${waiting} have no room`] : []),
  ];
  return { text: name || words.name, detail: parts.join(', ') };
}

function areaTags(scene: SceneFacts, view: TagScene): Tag[] {
  return scene.areas.flatMap((area): Tag[] => {
    const at = aboveOutline(area.polygon, 0, undefined, view.camera);
    if (!onScreen(at, view.camera)) return [];
    const seen = view.areas.find(({ id }) => id === area.id) ?? { passed: 0, waiting: 0 };
    return [
      { key: `area:${area.id}`, kind: 'patch', at, ...areaWords(area, seen, view.time), icon: kAreaIcons[area.kind] },
    ];
  });
}

export function patchTags(scene: SceneFacts, view: TagScene): Tag[] {
  const tags: Tag[] = areaTags(scene, view);
  for (const patch of scene.patches) {
    const clip = scene.clips[patch.motion] ?? kNoClip;
    const move = isMoving(patch) ? view.moving.find((one) => one.kind === 1 && one.id === patch.id) : undefined;
    const at = aboveOutline(patch.polygon, heightOf(patch, clip.name), move, view.camera);
    if (!onScreen(at, view.camera)) continue;
    const icon = patch.ascent === null ? kMotionIcons[clip.name] : kStairsIcon;
    tags.push({
      key: `patch:${patch.id}`,
      kind: 'patch',
      at,
      ...wordsOfPatch(patch, clip),
      ...(icon ? { icon } : {}),
    });
  }
  const spots: Tag[] = [];
  scene.checkpoints.forEach((checkpoint, i) => {
    const at = view.camera.worldToScreen(checkpoint.position[0], checkpoint.position[1]);
    if (onScreen(at, view.camera)) spots.push({ key: `spot:${i}`, kind: 'spot', at, text: checkpoint.formation.kind });
  });
  return [...once(tags), ...once(spots)];
}

/** Of patches with the same words the nearest alone stays. */
export function once(tags: readonly Tag[]): Tag[] {
  const kept: Tag[] = [];
  for (const tag of [...tags].sort(nearestFirst)) {
    const told = kept.some(({ text, detail }) => text === tag.text && detail === tag.detail);
    if (!told || tag.key.startsWith('area:')) kept.push(tag);
  }
  return tags.filter((tag) => kept.includes(tag));
}

function heightOf({ ascent }: ScenePatch, clip: string): number {
  return ascent === null ? heightOfLook(lookOfMotion(clip)) : 0;
}

/** The middle of the outline, just above its highest corner on the screen. */
function aboveOutline(
  polygon: readonly Vec2[],
  height: number,
  move: MovingView | undefined,
  camera: CameraController,
): ScreenPoint {
  const centre = centroid(polygon);
  const c = Math.cos(move?.angle ?? 0);
  const s = Math.sin(move?.angle ?? 0);
  let top = Infinity;
  for (const point of polygon) {
    const dx = point[0] - centre[0];
    const dy = point[1] - centre[1];
    const at = camera.worldToScreen(
      centre[0] + (move?.x ?? 0) + c * dx - s * dy,
      centre[1] + (move?.y ?? 0) + s * dx + c * dy,
      height,
    );
    top = Math.min(top, at.y);
  }
  const middle = camera.worldToScreen(centre[0] + (move?.x ?? 0), centre[1] + (move?.y ?? 0), height);
  return { x: middle.x, y: top - 20 };
}

/** Names the kinds of young controls. */
export function chipTags(marks: MarkState, view: TagScene): Tag[] {
  const tags: Tag[] = [];
  for (const shown of marks.controls) {
    const age = view.now - shown.kindSince;
    if (shown.ended > 0 || age > kChipTime) continue;
    const at = shown.control.points.map((point, i) => {
      const n = point.path.length;
      const handle = shown.handles[i] ?? point;
      return view.camera.worldToScreen(point.path[n - 2] ?? handle.x, point.path[n - 1] ?? handle.y);
    });
    const top = Math.min(...at.map((point) => point.y));
    const middle = at.reduce((sum, point) => sum + point.x, 0) / Math.max(1, at.length);
    const fill = accentColour(view.palette, view.colours[shown.group] ?? 0);
    tags.push({
      key: `chip:${shown.group}:${shown.control.id}`,
      kind: 'chip',
      text: kKindNames[shown.control.kind as ControlKind],
      at: { x: middle, y: Math.max(16, top - 50) },
      fill,
      ink: inkOn(view.palette, fill),
      opacity: Math.min(1, (kChipTime - age) / kChipFade),
    });
  }
  return tags;
}

/** Names the chosen character and its place, and numbers the contours. */
export function overlayTags(view: TagScene): Tag[] {
  const { overlay, camera } = view;
  if (!overlay) return [];
  const tags: Tag[] = view.contours.map((label) => ({
    key: `contour:${label.text}`,
    kind: 'contour',
    text: label.text,
    at: camera.worldToScreen(label.x, label.y),
  }));
  const path = overlay.path;
  if (path.length < 4) return tags;
  const fill = accentColour(view.palette, view.colours[view.chosenGroup] ?? 0);
  const ink = inkOn(view.palette, fill);
  const from = camera.worldToScreen(path[0] ?? 0, path[1] ?? 0, 1.8);
  const to = camera.worldToScreen(path[path.length - 2] ?? 0, path[path.length - 1] ?? 0);
  tags.push({
    key: 'chosen',
    kind: 'chip',
    text: `Character ${overlay.character}`,
    at: { x: from.x, y: from.y - 20 },
    fill,
    ink,
  });
  tags.push({ key: 'place', kind: 'chip', text: 'Its place', at: { x: to.x, y: to.y + 32 }, fill, ink });
  return tags;
}

function onScreen(at: ScreenPoint, camera: CameraController): boolean {
  return at.x > -80 && at.y > -30 && at.x < camera.width + 80 && at.y < camera.height + 30;
}
