/** Numbers out of base64; both sides are little-endian. */
function bytesOf(text: string): ArrayBuffer {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}

export const floats = (text: string): Float32Array => new Float32Array(bytesOf(text));
export const parts = (text: string): Int16Array => new Int16Array(bytesOf(text));
export const wholes = (text: string): Uint16Array => new Uint16Array(bytesOf(text));

/** Of two bytes each, or of four where there are too many to count with two. */
export function indices(text: string, count: number): Uint16Array | Uint32Array {
  const bytes = bytesOf(text);
  return bytes.byteLength > 2 * count ? new Uint32Array(bytes) : new Uint16Array(bytes);
}

export const PART = 32767;
export const WHOLE = 65535;
