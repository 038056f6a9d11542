// Files that become places: each is read by what stands in it.

import { kindOfFile, type FileKind } from '../../model/file_kind';
import { readGridMap } from '../../model/place_files/grid_map';
import type { ImportSource } from '../../model/place_files/imports';
import { readObj } from '../../model/place_files/obj';
import { FileProblem } from '../../model/place_files/place';

/** Larger files are not read [bytes]. */
const kMost = 256 << 20;

/** The file among several that the others belong to. */
async function mainOf(files: readonly File[]): Promise<{ readonly file: File; readonly kind: FileKind }> {
  const kinds = await Promise.all(files.map(kindOfFile));
  const at = Math.max(0, kinds.indexOf('scenery'));
  return { file: files[at]!, kind: kinds[at]! };
}

/** Throws a FileProblem. */
export async function readSource(files: readonly File[]): Promise<ImportSource> {
  const { file, kind } = await mainOf(files);
  if (file.size > kMost) throw new FileProblem(`“${file.name}” is larger than 256 MB.`);
  const { name } = file;
  if (kind === 'geojson') return { kind: 'geojson', file: name, text: await file.text() };
  if (kind === 'map') return { kind: 'map', file: name, map: readGridMap(await file.text(), name) };
  if (kind === 'obj') return { kind: 'model', file: name, meshes: readObj(await file.text(), name), up: null };
  if (kind !== 'scenery') throw new FileProblem(`“${name}” is no file that becomes a place.`);
  const { readModel } = await import('../../scene/scenery/model_file');
  return { kind: 'model', file: name, meshes: await readModel(file, files), up: 'y' };
}
