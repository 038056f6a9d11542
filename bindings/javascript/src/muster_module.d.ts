/** What emscripten makes of the C API (CMakeLists.txt); build.mjs puts it into the package's file. */
declare module 'muster-module' {
  const makeModule: (options: object) => Promise<unknown>;
  export default makeModule;
}
