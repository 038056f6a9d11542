// Messages between page and server as bytes: a byte with the number of the message, then its fields. Only the worker that
// talks with the server needs them, so they stand apart from the types.

import { ByteReader, ByteWriter } from './bytes';
import { Codecs } from './codec';
import { kCommandLayouts, kCommandNumbers, kDefinitionLayouts } from './generated/command_layouts';
import type { Given } from './generated/commands';
import { kClientLayouts, kPartLayouts, kServerLayouts } from './generated/layouts';
import type { ClientMessage, ServerMessage } from './generated/messages';
import { kWords } from './generated/words';

export const codecs = new Codecs({ ...kPartLayouts, ...kDefinitionLayouts }, kWords);
codecs.addUnion('Command', 'kind', kCommandLayouts, kCommandNumbers);
codecs.addUnion('ClientMessage', 'type', kClientLayouts);
codecs.addUnion('ServerMessage', 'type', kServerLayouts);

function encode(type: string, value: unknown): ArrayBuffer {
  const w = new ByteWriter();
  codecs.of(type).write(w, value);
  return w.bytes();
}

function decode(type: string, bytes: ArrayBuffer): unknown {
  const r = new ByteReader(bytes);
  const value = codecs.of(type).read(r);
  r.end();
  return value;
}

/** The definition of that type with all that was left out. */
export const filled = <T>(type: string, given: Given<T>): T => decode(type, encode(type, given)) as T;
/** How many bytes a value of that type takes. */
export const sizeOf = (type: string, value: unknown): number => encode(type, value).byteLength;

/** Reads a message; throws ProtocolError where it does not fit. */
export const decodeClient = (bytes: ArrayBuffer): ClientMessage => decode('ClientMessage', bytes) as ClientMessage;
/** As decodeClient. */
export const decodeServer = (bytes: ArrayBuffer): ServerMessage => decode('ServerMessage', bytes) as ServerMessage;
/** A message's bytes. */
export const encodeClient = (message: ClientMessage): ArrayBuffer => encode('ClientMessage', message);
/** A message's bytes. */
export const encodeServer = (message: ServerMessage): ArrayBuffer => encode('ServerMessage', message);
