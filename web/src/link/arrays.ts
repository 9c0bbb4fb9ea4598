/** Aligned copies of bytes. */

/** The memory of a document's bytes on its own, for a typed array over it: a view's offset may be odd. */
export const aligned = (bytes: Uint8Array): ArrayBuffer => bytes.slice().buffer as ArrayBuffer;
