// The generated part of the JavaScript binding, from the description of the C API.
import { description } from './description.mjs';
import { emitEnums, emitStructs } from './javascript/emit_types.mjs';
import { emitLayouts, emitSignatures, emitVerbs } from './javascript/emit_verbs.mjs';
import { Model } from './javascript/model.mjs';
import { TypeNames } from './javascript/types.mjs';

export function javascriptFiles() {
  const model = new Model(description);
  const names = new TypeNames(model);
  const folder = 'bindings/javascript/src/generated';
  return {
    [`${folder}/enums.ts`]: emitEnums(model),
    [`${folder}/structs.ts`]: emitStructs(model, names),
    [`${folder}/layouts.ts`]: emitLayouts(model, names),
    [`${folder}/signatures.ts`]: emitSignatures(model, names),
    [`${folder}/verbs.ts`]: emitVerbs(model, names),
  };
}
