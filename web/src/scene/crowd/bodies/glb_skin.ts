// Reads the first skinned mesh of a GLB file as the server writes it: one buffer, no extension, no sparse accessor. Characters
// of visitors are read by three.js, which is loaded for them.

/** Numbers of one attribute, a row a corner. */
export interface Rows {
  readonly count: number;
  at(row: number, column: number): number;
}

export interface GlbSkin {
  /** Names of its joints, in the order of the skin. */
  readonly joints: readonly string[];
  /** 16 numbers a joint, column by column. */
  readonly inverseBinds: Rows;
  readonly index: Rows;
  /** Null where the mesh has none of that name. */
  attribute(name: string): Rows | null;
}

interface Accessor {
  readonly bufferView: number;
  readonly byteOffset?: number;
  readonly componentType: number;
  readonly normalized?: boolean;
  readonly count: number;
  readonly type: string;
}

interface Gltf {
  readonly accessors: readonly Accessor[];
  readonly bufferViews: readonly { readonly byteOffset?: number; readonly byteStride?: number }[];
  readonly nodes: readonly { readonly name?: string; readonly mesh?: number; readonly skin?: number }[];
  readonly skins: readonly { readonly joints: readonly number[]; readonly inverseBindMatrices: number }[];
  readonly meshes: readonly {
    readonly primitives: readonly { readonly attributes: Readonly<Record<string, number>>; readonly indices: number }[];
  }[];
}

const kMagic = 0x46546c67;
const kChunkHead = 8;
const kFileHead = 12;
const kColumns: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };

type Reader = (view: DataView, at: number) => number;
/** By a component's number: its bytes, the value that stands for 1 where it is normalized, and how it is read. */
const kComponents: Readonly<Record<number, readonly [size: number, one: number, read: Reader]>> = {
  5121: [1, 0xff, (view, at) => view.getUint8(at)],
  5123: [2, 0xffff, (view, at) => view.getUint16(at, true)],
  5125: [4, 1, (view, at) => view.getUint32(at, true)],
  5126: [4, 1, (view, at) => view.getFloat32(at, true)],
};

function rowsOf(gltf: Gltf, bytes: DataView, number: number): Rows {
  const accessor = gltf.accessors[number];
  const view = accessor && gltf.bufferViews[accessor.bufferView];
  const columns = accessor && kColumns[accessor.type];
  const component = accessor && kComponents[accessor.componentType];
  if (!accessor || !view || !columns || !component) throw new Error('it has numbers of an unknown form');
  const [size, one, read] = component;
  const stride = view.byteStride ?? columns * size;
  const first = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  if (first + (accessor.count - 1) * stride + columns * size > bytes.byteLength) throw new Error('it is cut off');
  const unit = accessor.normalized ? one : 1;
  return { count: accessor.count, at: (row, column) => read(bytes, first + row * stride + column * size) / unit };
}

/** JSON and numbers of a file. */
function chunksOf(file: ArrayBuffer): { readonly gltf: Gltf; readonly bytes: DataView } {
  const view = new DataView(file);
  if (file.byteLength < kFileHead + kChunkHead || view.getUint32(0, true) !== kMagic)
    throw new Error('it is no GLB file');
  const length = view.getUint32(kFileHead, true);
  const begin = kFileHead + kChunkHead;
  if (begin + length + kChunkHead > file.byteLength) throw new Error('it is cut off');
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(file, begin, length))) as Gltf;
  return { gltf, bytes: new DataView(file, begin + length + kChunkHead) };
}

/** Throws with a reason. */
export function readGlbSkin(file: ArrayBuffer): GlbSkin {
  const { gltf, bytes } = chunksOf(file);
  const node = gltf.nodes.find(({ mesh, skin }) => mesh !== undefined && skin !== undefined);
  const skin = gltf.skins?.[node?.skin ?? -1];
  const primitive = gltf.meshes?.[node?.mesh ?? -1]?.primitives[0];
  if (!skin || !primitive) throw new Error('there is no skinned mesh');
  return {
    joints: skin.joints.map((joint) => gltf.nodes[joint]?.name ?? ''),
    inverseBinds: rowsOf(gltf, bytes, skin.inverseBindMatrices),
    index: rowsOf(gltf, bytes, primitive.indices),
    attribute: (name) => {
      const accessor = primitive.attributes[name];
      return accessor === undefined ? null : rowsOf(gltf, bytes, accessor);
    },
  };
}
