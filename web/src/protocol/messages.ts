// Messages between page and server, as bytes: a byte with the number of the message, then its fields.

import { ByteReader, ByteWriter } from './bytes';
import { Codecs } from './codec';
import { kCommandLayouts, kDefinitionLayouts } from './generated/command_layouts';
import type { Given } from './generated/commands';
import { kClientNames, kMessageLayouts, kServerNames } from './generated/layouts';
import type { ClientMessage, ServerMessage } from './generated/messages';
import { kWords } from './generated/words';

export * from './generated/choices';
export type * from './generated/messages';

export const codecs = new Codecs({ ...kMessageLayouts, ...kDefinitionLayouts }, kWords);
codecs.addUnion('Command', kCommandLayouts);

/** The definition of that type with all that was left out. */
export function filled<T>(type: string, given: Given<T>): T {
  const w = new ByteWriter();
  codecs.of(type).write(w, given);
  return codecs.of(type).read(new ByteReader(w.bytes())) as T;
}

/** How many bytes a value of that type takes. */
export function sizeOf(type: string, value: unknown): number {
  const w = new ByteWriter();
  codecs.of(type).write(w, value);
  return w.bytes().byteLength;
}

function decode(names: readonly string[], buffer: ArrayBuffer): unknown {
  const r = new ByteReader(buffer);
  const type = names[r.choice(names.length)]!;
  const message = Object.assign({ type }, codecs.of(type).read(r));
  r.end();
  return message;
}

function encode(names: readonly string[], message: ClientMessage | ServerMessage): ArrayBuffer {
  const w = new ByteWriter();
  w.u8(names.indexOf(message.type));
  codecs.of(message.type).write(w, message);
  return w.bytes();
}

/** Reads a message; throws ProtocolError where it does not fit. */
export const decodeClient = (buffer: ArrayBuffer): ClientMessage => decode(kClientNames, buffer) as ClientMessage;
/** As decodeClient. */
export const decodeServer = (buffer: ArrayBuffer): ServerMessage => decode(kServerNames, buffer) as ServerMessage;
/** A message's bytes. */
export const encodeClient = (message: ClientMessage): ArrayBuffer => encode(kClientNames, message);
/** A message's bytes. */
export const encodeServer = (message: ServerMessage): ArrayBuffer => encode(kServerNames, message);
