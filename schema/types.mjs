// The types that fields may have, and how each is written in C++, C and TypeScript.

/** Numbers, flags and texts. */
const kPlain = {
  u8: { cpp: 'std::uint8_t', c: 'uint8_t', initial: '0', ts: 'number' },
  i8: { cpp: 'std::int8_t', c: 'int8_t', initial: '0', ts: 'number' },
  i16: { cpp: 'std::int16_t', c: 'int16_t', initial: '0', ts: 'number' },
  u16: { cpp: 'std::uint16_t', c: 'uint16_t', initial: '0', ts: 'number' },
  u32: { cpp: 'std::uint32_t', c: 'uint32_t', initial: '0', ts: 'number' },
  u64: { cpp: 'std::uint64_t', c: 'uint64_t', initial: '0', ts: 'number' },
  size: { cpp: 'std::size_t', c: 'size_t', initial: '0', ts: 'number' },
  i32: { cpp: 'std::int32_t', c: 'int32_t', initial: '0', ts: 'number' },
  f32: { cpp: 'float', c: 'float', initial: '0.0f', ts: 'number' },
  f64: { cpp: 'double', c: 'double', initial: '0.0', ts: 'number' },
  bool: { cpp: 'bool', c: 'bool', initial: 'false', ts: 'boolean' },
  Vec2: { cpp: 'Vec2', c: 'MusterVec2', initial: '', ts: 'readonly [number, number]' },
  CharacterId: { cpp: 'std::uint32_t', c: 'MusterCharacterId', initial: '0', ts: 'number' },
  OrderId: { cpp: 'std::uint32_t', c: 'MusterOrderId', initial: '0', ts: 'number' },
  MotionIndex: { cpp: 'MotionId', c: 'MusterMotionIndex', initial: '0', ts: 'string | number' },
  Polygon: { cpp: 'Polygon', c: 'MusterPolygon', initial: '', ts: 'readonly (readonly [number, number])[]' },
  PolygonWithHoles: { cpp: 'PolygonWithHoles', c: 'MusterPolygon', initial: '', ts: 'readonly (readonly [number, number])[]' },
  Box: { cpp: 'Box', c: 'MusterBox', initial: '', ts: 'readonly [readonly [number, number], readonly [number, number]]' },
  Parameters: { cpp: 'Parameters', c: '', initial: '', ts: 'Readonly<Record<string, number>>' },
  Colour: { cpp: 'std::uint32_t', c: 'uint32_t', initial: '0', ts: 'string' },
};

/** Types of C that are not named after Muster, or after another thing. */
const kOther = { text: 'const char*', address: 'void*', void: 'void', MapGround: 'MusterMapDef' };

export const isId = (type) => /^(Group|Obstacle|Patch|Item|Checkpoint|Area|Control)Id$/.test(type);
/** True of a field that is an optional in C++: none of an id is 0. */
export const mayBeNone = ({ type, isOptional }) => isOptional && !isId(type);
export const plain = (type) => kPlain[type];
export const isType = (type) => type === 'text' || isId(type) || type in kPlain;

/** How C spells the type of a single value. */
export const cType = (type) => kOther[type] ?? kPlain[type]?.c ?? `Muster${type}`;
