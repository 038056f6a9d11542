// What is wrong with a file, told to the visitor: never what a reader of files tells its programmer.

/** Why a glTF file cannot be read. */
export function gltfTrouble(error: unknown): string {
  const told = error instanceof Error ? error.message : String(error);
  if (/DRACO/i.test(told)) return 'it is compressed with Draco, which the studio does not read';
  if (/meshopt/i.test(told)) return 'it is compressed with meshopt, which the studio does not read';
  if (/KTX2/i.test(told)) return 'it has KTX2 pictures, which the studio does not read';
  if (/Unsupported asset|Legacy binary/i.test(told)) return 'it is glTF 1; the studio reads glTF 2';
  return 'it is no whole glTF file';
}

/** The sentence of an error that was meant for the visitor; `otherwise` for an error of the program itself. */
export function sentenceOf(error: unknown, otherwise: string): string {
  const internal = [TypeError, RangeError, SyntaxError, ReferenceError].some((kind) => error instanceof kind);
  const text = error instanceof Error && !internal ? error.message : '';
  return text ? `${text.replace(/\.$/, '')}.` : otherwise;
}

/** A server's reason without the name of the file, which is told before it, and the `$` before the part of the file. */
export function plainReason(reason: string): string {
  if (reason.includes('found no take')) return 'it is no take';
  return reason
    .trim()
    .replace(/\.$/, '')
    .replace(/^[^:$]*: \$\.?/, '')
    .replace(/^(: |take: )/, '');
}
