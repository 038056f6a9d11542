// Wavefront OBJ: corners, faces and the objects and groups that they belong to. Materials are left out.

import { FileProblem } from './place';
import type { ModelMesh } from './mesh';

const kPale: ModelMesh['colour'] = [0.55, 0.52, 0.48];

interface Part {
  readonly name: string;
  readonly positions: number[];
  readonly triangles: number[];
  /** Corner of the file to corner of the part. */
  readonly corners: Map<number, number>;
}

class ObjReader {
  private readonly all_: number[] = [];
  private readonly parts_ = new Map<string, Part>();
  private part_ = this.part('');
  private object_ = '';

  constructor(private readonly file_: string) {}

  line(words: readonly string[], number: number): void {
    const [what, ...rest] = words;
    if (what === 'v') this.corner(rest, number);
    else if (what === 'f') this.face(rest, number);
    else if (what === 'o') this.part_ = this.part((this.object_ = rest.join(' ')));
    else if (what === 'g') this.part_ = this.part([this.object_, rest.join(' ')].filter((one) => one !== '').join(' '));
  }

  finish(): ModelMesh[] {
    const meshes = [...this.parts_.values()]
      .filter(({ triangles }) => triangles.length > 0)
      .map(({ name, positions, triangles }) => ({
        name,
        positions: Float32Array.from(positions),
        triangles: Uint32Array.from(triangles),
        colour: kPale,
      }));
    if (meshes.length === 0) throw new FileProblem(`“${this.file_}” holds no faces.`);
    return meshes;
  }

  private part(name: string): Part {
    const known = this.parts_.get(name);
    if (known) return known;
    const made = { name, positions: [], triangles: [], corners: new Map<number, number>() };
    this.parts_.set(name, made);
    return made;
  }

  private corner(words: readonly string[], number: number): void {
    const xyz = words.slice(0, 3).map(Number);
    if (xyz.length < 3 || !xyz.every(Number.isFinite))
      throw new FileProblem(`“${this.file_}” is broken in line ${number}: a corner has three numbers.`);
    this.all_.push(...xyz);
  }

  private face(words: readonly string[], number: number): void {
    const count = this.all_.length / 3;
    const corners = words.map((word) => {
      const said = parseInt(word, 10);
      const index = said < 0 ? count + said : said - 1;
      if (!(index >= 0 && index < count))
        throw new FileProblem(`“${this.file_}” is broken in line ${number}: it has no corner ${word.split('/')[0]}.`);
      return this.cornerOfPart(index);
    });
    for (let i = 2; i < corners.length; ++i) this.part_.triangles.push(corners[0]!, corners[i - 1]!, corners[i]!);
  }

  private cornerOfPart(index: number): number {
    const { corners, positions } = this.part_;
    const known = corners.get(index);
    if (known !== undefined) return known;
    const made = positions.length / 3;
    positions.push(this.all_[3 * index]!, this.all_[3 * index + 1]!, this.all_[3 * index + 2]!);
    corners.set(index, made);
    return made;
  }
}

/** The meshes of an OBJ file as it has them; throws a FileProblem. */
export function readObj(text: string, file: string): ModelMesh[] {
  const reader = new ObjReader(file);
  let started = '';
  text.split('\n').forEach((raw, i) => {
    const line = started + raw.replace(/#.*/, '').trim();
    started = line.endsWith('\\') ? `${line.slice(0, -1)} ` : '';
    if (started === '' && line !== '') reader.line(line.split(/\s+/), i + 1);
  });
  return reader.finish();
}
