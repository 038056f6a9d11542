// What functions take and give, read from the generated table when first needed.

import { kSignatures, type FunctionName } from '../generated/signatures.js';

export interface Parameter {
  readonly name: string;
  /** A scalar for numbers; else what it is: 'text', 'struct', 'out'... */
  readonly role: string;
  readonly type: string;
  readonly count: number;
}

export interface Signature {
  readonly name: FunctionName;
  /** What it returns: 'status', 'void', 'text', a scalar, 'struct', 'list' or 'fixed'. */
  readonly returns: string;
  readonly type: string;
  readonly count: number;
  /** True where read-outs of its first argument end with it. */
  readonly moves: boolean;
  readonly parameters: readonly Parameter[];
}

function parsed(name: FunctionName): Signature {
  const [head = '', ...rest] = kSignatures[name].split(' | ');
  const words = head.split(' ');
  const moves = words.at(-1) === 'moves';
  const [returns = '', type = '', count] = moves ? words.slice(0, -1) : words;
  const parameters = rest.map((text) => {
    const [own = '', role = '', of = '', many] = text.split(' ');
    return { name: own, role, type: of, count: Number(many ?? 0) };
  });
  return { name, returns, type, count: Number(count ?? 0), moves, parameters };
}

const kKnown = new Map<FunctionName, Signature>();

export function signatureOf(name: FunctionName): Signature {
  let signature = kKnown.get(name);
  if (!signature) {
    signature = parsed(name);
    kKnown.set(name, signature);
  }
  return signature;
}
