// The types that fields of definitions and commands may have, and how each is written in C++, C, files and TypeScript.

/** Numbers, flags and texts. */
const kPlain = {
  u8: { cpp: 'std::uint8_t', c: 'uint8_t', initial: '0', ts: 'number' },
  u32: { cpp: 'std::uint32_t', c: 'uint32_t', initial: '0', ts: 'number' },
  u64: { cpp: 'std::uint64_t', c: 'uint64_t', initial: '0', ts: 'number' },
  i32: { cpp: 'std::int32_t', c: 'int32_t', initial: '0', ts: 'number' },
  f64: { cpp: 'double', c: 'double', initial: '0.0', ts: 'number' },
  bool: { cpp: 'bool', c: 'bool', initial: 'false', ts: 'boolean' },
  Vec2: { cpp: 'Vec2', c: 'MusterVec2', initial: '', ts: 'readonly [number, number]' },
  CharacterId: { cpp: 'std::uint32_t', c: 'MusterCharacterId', initial: '0', ts: 'number' },
  OrderId: { cpp: 'std::uint32_t', c: 'MusterOrderId', initial: '0', ts: 'number' },
  MotionId: { cpp: 'MotionId', c: 'MusterMotionIndex', initial: '0', ts: 'string | number' },
  Polygon: { cpp: 'Polygon', c: 'MusterPolygon', initial: '', ts: 'readonly (readonly [number, number])[]' },
  PolygonWithHoles: { cpp: 'PolygonWithHoles', c: 'MusterPolygon', initial: '', ts: 'readonly (readonly [number, number])[]' },
  Box: { cpp: 'Box', c: 'MusterBox', initial: '', ts: 'readonly [readonly [number, number], readonly [number, number]]' },
  Parameters: { cpp: 'Parameters', c: '', initial: '', ts: 'Readonly<Record<string, number>>' },
  Colour: { cpp: 'std::uint32_t', c: 'uint32_t', initial: '0', ts: 'string' },
};

/** What messages call a value of an enumeration, and its key in files where that is not the name of the field. */
const kEnums = {
  ControlKind: { called: 'control kind', key: 'control' },
  QueueMode: { called: 'queue mode' },
  TouchPhase: { called: 'phase' },
  ControlEdit: { called: 'edit' },
  QueueEdit: { called: 'queue edit' },
  SplitBy: { called: 'way of splitting' },
  PartShape: { called: 'shape of parts' },
  Driver: { called: 'driver' },
  ThingKind: { called: 'thing' },
  BodyBuild: { called: 'build' },
  MotionSet: { called: 'set of motions' },
};

/**
 * Definitions: the check of one, or of a list (`checkAll`), and the function that describes it in files. It stands in an object of
 * its own ("definition", or `key`) or among the fields of the command (`inline`).
 */
const kDefinitions = {
  FormationDef: { check: 'validate', describe: 'describe(inner, #)', key: 'formation', visit: 'objectOrKind' },
  GroupColour: { check: 'validate', describe: 'describe(inner, #)' },
  GroupLook: { check: 'validate', describe: 'describe(inner, #)' },
  GroupDef: { check: 'validate', describe: 'describe(inner, #)' },
  ObstacleDef: { check: 'validate', describe: 'describe(inner, #)' },
  PatchDef: { check: 'validatePatch', checkMore: ', kAnyMotion', describe: 'describe(inner, #, {})' },
  ItemDef: { check: 'validate', describe: 'describe(inner, #)', isPlainInC: true },
  CheckpointDef: { cpp: 'FormationCheckpointDef', check: 'validateCheckpoint', checkMore: ', kMaxGroups', describe: 'describe(inner, #, [] {})' },
  AreaDef: { check: 'validate', describe: 'describe(inner, #, [] {})' },
  Order: { check: 'validate', inline: 'describe(v, #)' },
  Conduct: { check: 'validate', inline: 'describe(v, #)' },
  RoleDef: { checkAll: 'validateRoles', inline: 'describeRoles(v, #, &)' },
  PeopleDef: { checkAll: 'validatePeople', inline: 'describePeople(v, #, &)' },
  Body: { inline: 'describeBodies(v, "bodies", #, &)', isPlainInC: true },
};

export const isId = (type) => /^(Group|Obstacle|Patch|Item|Checkpoint|Area|Control)Id$/.test(type);
/** True of a field that is an optional in C++: none of an id is 0. */
export const mayBeNone = ({ type, isOptional }) => isOptional && !isId(type);
export const plain = (type) => kPlain[type];
export const enumerated = (type) => kEnums[type];
export const definition = (type) => kDefinitions[type];
export const isType = (type) => type === 'text' || isId(type) || type in kPlain || type in kEnums || type in kDefinitions;

/** How C++ spells the type of a single value. */
export function cppItem(type) {
  if (type === 'text') return 'std::string';
  return kPlain[type]?.cpp ?? kDefinitions[type]?.cpp ?? type;
}

/** The same in C. */
export function cItem(type) {
  if (type === 'text') return 'const char*';
  return kPlain[type]?.c ?? `Muster${type}`;
}
