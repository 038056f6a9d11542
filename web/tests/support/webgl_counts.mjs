// In a page, before its scripts run: counts what the page asks of WebGL.

export function countWebgl() {
  const counts = { calls: 0, bytes: 0 };
  globalThis.webgl = counts;
  const proto = globalThis.WebGL2RenderingContext.prototype;
  const uploads = /^(bufferData|bufferSubData|texImage2D|texSubImage2D|uniform.*v)$/;
  for (const name of Object.getOwnPropertyNames(proto)) {
    const { value, writable } = Object.getOwnPropertyDescriptor(proto, name);
    if (typeof value !== 'function' || !writable) continue;
    proto[name] = function counted(...given) {
      counts.calls += 1;
      if (uploads.test(name)) counts.bytes += bytesOf(name, given);
      return value.apply(this, given);
    };
  }

  /** A part of an array goes up where offset and length follow it. */
  function bytesOf(name, given) {
    const at = given.findIndex((one) => ArrayBuffer.isView(one) || one instanceof ArrayBuffer);
    if (at < 0) return 0;
    const length = name.startsWith('buffer') ? given[at + 2 + (name === 'bufferData' ? 1 : 0)] : undefined;
    return length ? length * (given[at].BYTES_PER_ELEMENT ?? 1) : given[at].byteLength;
  }
}
