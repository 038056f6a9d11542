// Words over the scene: names of patches, kinds of controls, numbers of contours. Plain elements, moved by transforms.

import type { AreaKindWord } from '../../protocol/generated/words';
import type { ScreenPoint } from '../../model/plane';

export interface Tag {
  readonly key: string;
  readonly kind: 'patch' | 'chip' | 'contour' | 'spot';
  readonly at: ScreenPoint;
  readonly text: string;
  /** Paler words after the name. */
  readonly detail?: string;
  /** Path data of a 20 x 20 icon. */
  readonly icon?: string;
  /** Fill and text colours of a chip. */
  readonly fill?: string;
  readonly ink?: string;
  readonly opacity?: number;
}

/** Half the height of a tag [CSS px]; view.css agrees. */
const kHalfHeight = 13;
/** Between a tag and the panels, and between two tags [CSS px]. */
const kGap = 8;
const kApart = 3;
/** So far down a tag moves to come out from below the panels [CSS px]. */
const kDown = 40;

/** Where no panel lies [CSS px]. */
export interface TagRoom {
  readonly left: number;
  readonly right: number;
  readonly top: number;
}

const kAnywhere: TagRoom = { left: -Infinity, right: Infinity, top: -Infinity };

/** On the screen, the lowest first. */
export const nearestFirst = (a: Tag, b: Tag): number => b.at.y - a.at.y || a.key.localeCompare(b.key);

/** The upper left corner of a tag of half that width: the name of a patch moves out from below the panels, as long as it stays
 * above its patch; null where it cannot. */
export function tagCorner({ kind, at }: Pick<Tag, 'kind' | 'at'>, half: number, room: TagRoom): ScreenPoint | null {
  const [x, y] = [at.x - half, at.y - kHalfHeight];
  // Whole px keep the letters sharp.
  if (kind !== 'patch') return { x: Math.round(x), y: Math.round(y) };
  const free = Math.max(room.left + kGap, Math.min(x, room.right - kGap - 2 * half));
  const below = Math.max(room.top + kGap, y);
  return Math.abs(free - x) > half || below - y > kDown ? null : { x: Math.round(free), y: Math.round(below) };
}

interface TagBox extends ScreenPoint {
  readonly width: number;
}

const overlap = (a: TagBox, b: TagBox): boolean =>
  a.x < b.x + b.width + kApart && b.x < a.x + a.width + kApart && Math.abs(a.y - b.y) < 2 * kHalfHeight + kApart;

/** Leaves out tags of the place that would cover another: the nearest stays. */
export function uncrowded<T extends { readonly tag: Tag; readonly box: TagBox }>(placed: readonly T[]): T[] {
  const kept: T[] = [];
  for (const one of [...placed].sort((a, b) => nearestFirst(a.tag, b.tag))) {
    const fixed = one.tag.kind === 'patch' || one.tag.kind === 'spot';
    if (!fixed || !kept.some((other) => other.tag.kind === one.tag.kind && overlap(other.box, one.box))) kept.push(one);
  }
  return kept;
}

const kSvg = 'http://www.w3.org/2000/svg';

export class TagLayer {
  private readonly root_: HTMLElement;
  private readonly elements_ = new Map<string, HTMLElement>();

  constructor(root: HTMLElement) {
    this.root_ = document.createElement('div');
    this.root_.className = 'tags';
    root.append(this.root_);
  }

  /** Shows these tags, but for those that have no room; an element stays as long as its key does. */
  show(tags: readonly Tag[], room = kAnywhere): void {
    const unseen = new Set(this.elements_.keys());
    const placed = tags.flatMap((tag) => {
      unseen.delete(tag.key);
      const element = this.elementOf(tag);
      const half = Number(element.dataset['half']);
      const corner = tagCorner(tag, half, room);
      element.style.visibility = 'hidden';
      return corner ? [{ tag, element, box: { ...corner, width: 2 * half } }] : [];
    });
    for (const { tag, element, box } of uncrowded(placed)) {
      element.style.visibility = '';
      element.style.transform = `translate(${box.x}px, ${box.y}px)`;
      element.style.opacity = String(tag.opacity ?? 1);
      if (tag.fill) element.style.background = tag.fill;
      if (tag.ink) element.style.color = tag.ink;
    }
    for (const key of unseen) {
      this.elements_.get(key)?.remove();
      this.elements_.delete(key);
    }
  }

  private elementOf(tag: Tag): HTMLElement {
    const words = tag.text + (tag.detail ?? '');
    const known = this.elements_.get(tag.key);
    if (known && known.dataset['text'] === words) return known;
    known?.remove();
    const element = this.make(tag);
    this.elements_.set(tag.key, element);
    this.root_.append(element);
    element.dataset['half'] = String(element.offsetWidth / 2);
    return element;
  }

  private make(tag: Tag): HTMLElement {
    const element = document.createElement('div');
    element.className = `tag tag-${tag.kind}`;
    element.dataset['text'] = tag.text + (tag.detail ?? '');
    if (tag.icon) element.append(makeIcon(tag.icon));
    const name = document.createElement('b');
    name.textContent = tag.text;
    element.append(name);
    if (tag.detail) {
      const detail = document.createElement('span');
      detail.textContent = tag.detail;
      element.append(detail);
    }
    return element;
  }
}

function makeIcon(path: string): SVGElement {
  const svg = document.createElementNS(kSvg, 'svg');
  svg.setAttribute('viewBox', '0 0 20 20');
  svg.setAttribute('aria-hidden', 'true');
  const line = document.createElementNS(kSvg, 'path');
  line.setAttribute('d', path);
  svg.append(line);
  return svg;
}

/** Out through a door, in through it, and an hourglass. */
export const kAreaIcons: Readonly<Record<AreaKindWord, string>> = {
  exit: 'M8.500 3.500h-5v13h5M8 10h9M13.400 6.400 17 10l-3.600 3.600',
  source: 'M11.500 3.500h5v13h-5M3 10h9M8.400 6.400 12 10l-3.600 3.600',
  waiting: 'M5 3.500h10M5 16.500h10M6.500 3.500c0 3.500 7 9.500 7 13M13.500 3.500c0 3.500-7 9.500-7 13',
};
export const kStairsIcon = 'M2.500 16.500h4v-4h4v-4h4v-4h3';

/** A small figure per motion: strokes of a head, trunk and limbs. */
export const kMotionIcons: Readonly<Record<string, string>> = {
  crawl:
    'M16.4 9.2a.9.9 0 1 0 .01 0M14.6 10.6 7.5 11.2 4 15h-2M7.5 11.2 8.6 15H6.4M14.6 10.6 15.6 15h1.8M11.5 11 12 14.6',
  swim: 'M14.6 7.6a1 1 0 1 0 .01 0M4 11.6 9 8.2l3.4 3.4M9 8.2 11.6 5.6M2.4 14.4q1.9-1.6 3.8 0t3.8 0 3.8 0 3.8 0',
  climb:
    'M10.6 3.6a1 1 0 1 0 .01 0M15.4 2.2v15.6M10.4 6.6 9.2 11.4 12.2 13.6 11.4 17.6M9.2 11.4 7.2 17M10.4 6.8 13.4 5M10.2 7.4 13.8 9.4',
  jump: 'M11.6 3.4a1 1 0 1 0 .01 0M11.2 6.2 9.4 10.4 13 11.6 12 14.6M9.4 10.4 5.4 12M11.2 6.6 14.6 5.4M11 6.8 7.2 6.4M4 17.2h12',
  duck: 'M13.4 6.6a1 1 0 1 0 .01 0M12 8.8 7 10.4l3.2 2.8-1.4 4M7 10.4 5.4 13.6 6.2 17.2M12 9 14.4 12.4M3 3.4h14',
};
