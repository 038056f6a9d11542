export const kFaces: readonly (readonly number[])[];
export const kYard: Readonly<Record<string, readonly (readonly number[])[]>>;
export function madeObj(objects?: typeof kYard): Uint8Array<ArrayBuffer>;
export function madeModel(options?: { objects?: typeof kYard; shift?: number }): Uint8Array<ArrayBuffer>;
export function madeTown(options?: { bad?: number }): Uint8Array<ArrayBuffer>;
export function madeMap(): Uint8Array<ArrayBuffer>;
