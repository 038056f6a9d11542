// A file that becomes a place, or part of one: what was read, what can be set, and what comes of it.

import type { GroundPoint } from '../plane';
import { footprintsOf, groundOf } from './footprint';
import { kUsualGeoOptions, readGeoJson } from './geojson';
import { placeOfMap, type GridMap } from './grid_map';
import { leftOutText } from './left_out';
import { extentOf, likelyUp, type ModelMesh, standing, type UpAxis } from './mesh';
import { placeAround } from './new_place';
import { boundsOfOutlines, type Outline, placedOutlines, type PlaceDefinition } from './place';

export type ImportSource =
  | { readonly kind: 'geojson'; readonly file: string; readonly text: string }
  | { readonly kind: 'map'; readonly file: string; readonly map: GridMap }
  /** `up` where the file says which axis stands up. */
  | {
      readonly kind: 'model';
      readonly file: string;
      readonly meshes: readonly ModelMesh[];
      readonly up: UpAxis | null;
    };

export interface ImportSettings {
  readonly name: string;
  readonly people: number;
  /** Metres for one unit of the file. */
  readonly scale: number;
  /** Counter-clockwise [degrees]. */
  readonly turn: number;
  /** Edge of a cell of a map [m]. */
  readonly cell: number;
  /** Of buildings that say nothing of their height, and of walls [m]. */
  readonly usualHeight: number;
  readonly wallWidth: number;
  readonly up: UpAxis;
  /** Where its middle comes to stand when it is added [m]. */
  readonly at: GroundPoint;
}

export interface Imported {
  /** About the origin [m]; empty for maps. */
  readonly outlines: readonly Outline[];
  /** What is shown of a model, about the origin. */
  readonly meshes: readonly ModelMesh[];
  /** As a place of its own. */
  readonly place: PlaceDefinition;
  /** For the visitor. */
  readonly notes: readonly string[];
}

/** "town" of "town.geojson". */
export function titleOf(file: string): string {
  const plain = file
    .replace(/\.(geo)?json$|\.\w{2,8}$/i, '')
    .replace(/[_-]+/g, ' ')
    .trim();
  return plain === '' ? 'Place' : plain.charAt(0).toUpperCase() + plain.slice(1);
}

export function usualSettings(source: ImportSource): ImportSettings {
  return {
    name: titleOf(source.file),
    people: 50,
    scale: 1,
    turn: 0,
    cell: 1,
    ...kUsualGeoOptions,
    up: source.kind === 'model' ? (source.up ?? likelyUp(source.meshes)) : 'z',
    at: { x: 0, y: 0 },
  };
}

/** Scaled, turned, with their ground at 0 and their middle at the origin. */
function placedMeshes(meshes: readonly ModelMesh[], scale: number, turn: number): ModelMesh[] {
  const ground = groundOf(meshes);
  const { min, max } = extentOf(meshes);
  const [mx, my] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
  const [c, s] = [scale * Math.cos(turn), scale * Math.sin(turn)];
  return meshes.map((mesh) => {
    const positions = new Float32Array(mesh.positions.length);
    for (let i = 0; i + 2 < positions.length; i += 3) {
      const [x, y] = [mesh.positions[i]! - mx, mesh.positions[i + 1]! - my];
      positions[i] = c * x - s * y;
      positions[i + 1] = s * x + c * y;
      positions[i + 2] = scale * (mesh.positions[i + 2]! - ground);
    }
    return { ...mesh, positions };
  });
}

/** Objects of a model are called after it, so that its obstacles are told from others. */
function named(outlines: readonly Outline[], file: string): Outline[] {
  return outlines.map((one) => ({
    ...one,
    name: one.name === '' || one.name === file ? file : `${file}: ${one.name}`,
  }));
}

const number = (value: number, one: string, more: string): string =>
  `${value.toLocaleString('en')} ${value === 1 ? one : more}`;

function sizeText(outlines: readonly Outline[]): string {
  const bounds = boundsOfOutlines(outlines);
  if (!bounds) return 'Nothing of it stands in the way.';
  const metres = (value: number): string => (value < 10 ? value.toFixed(1) : Math.round(value).toLocaleString('en'));
  const [wide, high] = [bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y];
  const waters = outlines.filter(({ water }) => water).length;
  const water = waters > 0 ? ` and ${number(waters, 'piece of water', 'pieces of water')}` : '';
  return `${number(outlines.length - waters, 'obstacle', 'obstacles')}${water} on ${metres(wide)} × ${metres(high)} m.`;
}

function ofOutlines(outlines: readonly Outline[], settings: ImportSettings, file: string): PlaceDefinition {
  const { name, people } = settings;
  return placeAround(outlines, { name, people, description: `Made from ${file}.` });
}

/** Throws a FileProblem where nothing can be used. */
export function importedFrom(source: ImportSource, settings: ImportSettings): Imported {
  const turn = (settings.turn * Math.PI) / 180;
  const { scale, name, people, cell } = settings;
  if (source.kind === 'map') {
    const { width, height, free } = source.map;
    const place = placeOfMap(source.map, name, cell, people);
    const notes = [`${width} × ${height} cells, ${number(free, 'of them free', 'of them free')}.`];
    const room = place.groups?.[0]?.count ?? people;
    if (room < people) notes.push(`There is room for ${number(room, 'person', 'people')}.`);
    return { outlines: [], meshes: [], place, notes };
  }
  if (source.kind === 'geojson') {
    const read = readGeoJson(source.text, source.file, settings);
    const outlines = placedOutlines(read.outlines, { scale, turn, at: { x: 0, y: 0 } });
    const notes = [sizeText(outlines), leftOutText(read.left, read.total)];
    if (read.withoutHeight > 0)
      notes.push(`${number(read.withoutHeight, 'outline says', 'outlines say')} nothing of the height.`);
    return { outlines, meshes: [], place: ofOutlines(outlines, settings, source.file), notes: notes.filter(Boolean) };
  }
  const meshes = placedMeshes(
    source.meshes.map((mesh) => standing(mesh, settings.up)),
    scale,
    turn,
  );
  const { outlines: plain, left, total } = footprintsOf(meshes, { scale: 1, ground: 0 });
  const outlines = named(plain, source.file);
  const notes = [sizeText(outlines), leftOutText(left, total, 'objects')].filter(Boolean);
  return { outlines, meshes, place: ofOutlines(outlines, settings, source.file), notes };
}

/** Moved from the origin to a point. */
export function movedTo(outlines: readonly Outline[], at: GroundPoint): Outline[] {
  return outlines.map((one) => ({ ...one, corners: one.corners.map(({ x, y }) => ({ x: x + at.x, y: y + at.y })) }));
}
