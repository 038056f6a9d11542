// The studio's session: what the studio's page runs in a worker where there is no server (docs/site.md). Its modules come with a
// site, in the folder `engine`.

export { ModuleMemory } from '../binding/module_memory.js';
export type { ModuleFileSystem } from '../binding/module_types.js';
export { Engine, type EngineAnswer } from './engine.js';
export { loadStudioModule, type ExporterModule, type StudioModule } from './studio_module.js';
