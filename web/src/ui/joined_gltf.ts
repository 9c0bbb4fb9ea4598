/** A .gltf with the files that it names, as one file: what a page sends is one file each. */

interface Named {
  uri?: string;
  mimeType?: string;
}

/** The same files, but each .gltf holds the buffers and pictures beside it that it names, which are no more of their own. */
export async function joinGltf(files: readonly File[]): Promise<readonly File[]> {
  if (files.length < 2) return files;
  const joined = new Map<File, File>();
  const used = new Set<File>();
  for (const file of files.filter(({ name }) => /\.gltf$/i.test(name)))
    joined.set(file, await withNamed(file, files, used));
  return files.filter((file) => !used.has(file)).map((file) => joined.get(file) ?? file);
}

/** A .gltf with what it names of `files`, which are noted as used; as it is where it cannot be read: the show says why. */
async function withNamed(gltf: File, files: readonly File[], used: Set<File>): Promise<File> {
  const document = parse(await gltf.text());
  if (document === null) return gltf;
  for (const named of [...listOf(document.buffers), ...listOf(document.images)]) {
    const beside = files.find(({ name }) => name === fileNameOf(named.uri ?? ""));
    if (beside === undefined) continue;
    const kind = named.mimeType ?? (beside.type || "application/octet-stream");
    named.uri = `data:${kind};base64,${base64(new Uint8Array(await beside.arrayBuffer()))}`;
    used.add(beside);
  }
  return new File([JSON.stringify(document)], gltf.name, { type: gltf.type });
}

function parse(text: string): Record<string, unknown> | null {
  try {
    const document: unknown = JSON.parse(text);
    return typeof document === "object" && document !== null ? (document as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}

const listOf = (value: unknown): Named[] =>
  Array.isArray(value)
    ? value.filter((each) => typeof each === "object" && each !== null && typeof each.uri === "string")
    : [];

/** The name of the file that an address beside a document means. */
function fileNameOf(uri: string): string {
  const last = uri.split("/").at(-1) ?? "";
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

/** Bytes that are written at once: an argument each. */
const PIECE = 0x8000;

function base64(bytes: Uint8Array): string {
  const pieces: string[] = [];
  for (let at = 0; at < bytes.length; at += PIECE) pieces.push(String.fromCharCode(...bytes.subarray(at, at + PIECE)));
  return btoa(pieces.join(""));
}
