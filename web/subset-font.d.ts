// What plain_font.ts uses of subset-font.
declare module 'subset-font' {
  interface Options {
    readonly targetFormat: 'sfnt' | 'woff' | 'woff2';
    readonly keepFeatures?: readonly string[];
    readonly variationAxes?: Readonly<Record<string, { readonly min: number; readonly max: number }>>;
  }
  export default function subset(font: Uint8Array, letters: string, options: Options): Promise<Uint8Array>;
}
