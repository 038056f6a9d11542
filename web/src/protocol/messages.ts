// Messages between page and server; encoding.ts has their bytes.

export * from './generated/choices';
export type * from './generated/messages';
