// The crowd engine for JavaScript: the C API's verbs (docs/javascript.md).

export type { LogFunction, ProgressFunction, ReplayFunction } from './binding/callbacks.js';
export type { NumberArray } from './binding/layout.js';
export type { ReadOut } from './binding/read_out.js';
export { Rows } from './binding/rows.js';
export * from './generated/enums.js';
export type * from './generated/structs.js';
export {
  Bvh,
  ClipLibrary,
  GridMap,
  Motion,
  MotionMoment,
  Scenario,
  Take,
  TakeWriter,
  World,
} from './generated/verbs.js';
export type { WasmSource } from './load_module.js';
export { ModuleFiles } from './module_files.js';
export { loadMuster, Muster, type LoadOptions } from './muster.js';
export type { SqlLibrary } from './sql_files.js';
export { MusterError } from './muster_error.js';
