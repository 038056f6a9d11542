// The studio's session: what the studio's page runs in a worker where there is no server (docs/site.md). Its module comes with a
// site, in the folder `engine`.

export { ModuleMemory } from '../binding/module_memory.js';
export type { ModuleFileSystem } from '../binding/module_types.js';
export { Engine, type EngineAnswer } from './engine.js';
export { SplitModule, webSource, type ModuleSource } from './split_module.js';
export {
  loadStudioModule,
  loadThreadedModule,
  type ExportParts,
  type LoadedStudioModule,
  type StudioModule,
} from './studio_module.js';
export { SqlFiles, type SqlLibrary } from '../sql_files.js';
