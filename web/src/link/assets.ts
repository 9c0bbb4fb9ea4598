/** Fetches and remembers what the manifest lists: faces, compounds, hair, the skin's picture. */

import { decode } from "@msgpack/msgpack";
import { aligned } from "./arrays";
import { downloads } from "./fetch_progress";
import { type Body, type FigurePose, type FigureSpace, readBody, readFigurePose, readFigureSpace } from "./figures";
import type {
  BodyAsset,
  CompoundAsset,
  ExpressionDocument,
  FaceAsset,
  FaceDocument,
  FigureAsset,
  HairAsset,
  LineDocument,
  Manifest,
  MeshDocument,
  PoseDocument,
} from "./messages";
import { Backoff } from "./reconnecting_socket";
import { type HairStrands, readStrands } from "./strands";

/** A drawn mesh; `source` maps its vertices to rows of the positions, `uv` (0, 0) is the upper left corner.
 *  `openness`: how much of the sky each sees on the generic face, 0 to 255. */
export interface Mesh {
  name: string;
  source: Uint32Array;
  uv: Float32Array;
  triangles: Uint32Array;
  openness: Uint8Array;
}

/** A compound less its face: row `indices[n]` moves by `scale * deltas[3n .. 3n+2]` metres. */
export interface Compound {
  scale: number;
  indices: Uint32Array;
  deltas: Int16Array;
  /** What it uses up by itself of what sums may not (omote.perform.blending.correctives), where the cast says so. */
  allowed: { places: Uint32Array; values: Float32Array } | undefined;
}

/** Reads an address's bytes; may throw. */
export type Fetch = (address: string) => Promise<Uint8Array>;

/** An answer that trying again will not change. */
export class RefusedAddress extends Error {}

/** The bytes behind an address of our server; RefusedAddress for a 4xx answer. */
export async function fetchBytes(address: string): Promise<Uint8Array> {
  const { response, bytes } = await downloads.follow(address, () => fetch(address));
  if (response.status >= 400 && response.status < 500)
    throw new RefusedAddress(`The server answered ${response.status} for ${address}.`);
  if (!response.ok) throw new Error(`The server answered ${response.status} for ${address}.`);
  return bytes;
}

/** Reads an address until it comes: the server may be away for a while. */
export async function fetchWithRetry(address: string, read: Fetch = fetchBytes): Promise<Uint8Array> {
  const backoff = new Backoff();
  for (;;) {
    try {
      return await read(address);
    } catch (error) {
      if (error instanceof RefusedAddress) throw error;
      await new Promise((resolve) => setTimeout(resolve, backoff.next() * 1000));
    }
  }
}

/** A mesh of the manifest as typed arrays; an Error when an index points past the positions. */
export function readMesh(mesh: MeshDocument, vertices: number): Mesh {
  const source = new Uint32Array(aligned(mesh.source));
  const triangles = new Uint32Array(aligned(mesh.triangles));
  const uv = new Float32Array(aligned(mesh.uv));
  if (source.some((row) => row >= vertices) || triangles.some((corner) => corner >= source.length))
    throw new Error(`Mesh ${mesh.name} points past its ${vertices} positions; bake the cast again.`);
  if (uv.length !== 2 * source.length || triangles.length % 3 !== 0)
    throw new Error(`Mesh ${mesh.name} has ${source.length} vertices but ${uv.length / 2} texture coordinates.`);
  if (mesh.openness.length !== source.length)
    throw new Error(`Mesh ${mesh.name} has ${source.length} vertices but openness for ${mesh.openness.length}.`);
  return { name: mesh.name, source, uv, triangles, openness: mesh.openness };
}

/** The rows of a line around an opening, in walking order; an Error when one points past the positions. */
export function readLine(line: LineDocument, vertices: number): Uint32Array {
  const loop = new Uint32Array(aligned(line.loop));
  if (loop.some((row) => row >= vertices))
    throw new Error(`Line ${line.name} points past its ${vertices} positions; bake the cast again.`);
  return loop;
}

/** A compound as typed arrays; an Error when it does not fit `vertices` positions. */
export function readCompound(bytes: Uint8Array, vertices: number): Compound {
  const asset = decode(bytes) as CompoundAsset;
  const indices = new Uint32Array(aligned(asset.indices));
  const deltas = new Int16Array(aligned(asset.deltas));
  if (!Number.isFinite(asset.scale) || deltas.length !== 3 * indices.length || indices.some((row) => row >= vertices))
    throw new Error(`A compound of ${indices.length} vertices does not fit the cast's ${vertices}.`);
  return { scale: asset.scale, indices, deltas, allowed: readAllowance(asset.allowed) };
}

function readAllowance(document: CompoundAsset["allowed"]): Compound["allowed"] {
  if (document === null || document === undefined) return undefined;
  return {
    places: new Uint32Array(aligned(document.places)),
    values: new Float32Array(aligned(document.values)),
  };
}

/** Begins the source of what is known by its content; other sources are names of the built-in cast. */
export const KEY = "#";

/** A face without hair, and without its shadow on the scalp. */
const shaved = (face: FaceDocument): FaceDocument => ({ ...face, look: { ...face.look, hair_style: "", scalp: 0 } });

/** What names stand for something that may change during the show. */
export type SourceKind = "faces" | "expressions" | "poses";
const NONE: ReadonlyMap<string, string> = new Map();

/**
 * The cast as documents: the manifest, and faces and compounds that are fetched once, when first asked for. What a name
 * of the cast stands for may change during the show; a source (`sourceOf`) stands for the same for ever.
 */
export class Library {
  readonly meshes: readonly Mesh[];
  /** Rows of the lines around the openings, by name, in walking order. */
  readonly lines: ReadonlyMap<string, Uint32Array>;
  /** Every face and every expression that ever was in the cast, by source. */
  readonly faces = new Map<string, FaceDocument>();
  readonly expressions = new Map<string, ExpressionDocument>();
  private present: Manifest;
  private renewals = 0;
  private shown = "";
  private sources: Record<SourceKind, ReadonlyMap<string, string>> = { faces: NONE, expressions: NONE, poses: NONE };
  private readonly positioned = new Map<string, Promise<Float32Array>>();
  private readonly compounds = new Map<string, Promise<Compound>>();
  private readonly styles = new Map<string, Promise<HairStrands>>();
  private readonly bodies = new Map<string, Promise<Body>>();
  private space: Promise<FigureSpace> | undefined;
  private posed: ReadonlyMap<string, FigurePose> = new Map();
  private unread: readonly PoseDocument[] = [];
  private picture: Promise<ImageBitmap[]> | undefined;

  constructor(
    manifest: Manifest,
    private readonly read: Fetch = fetchBytes,
    private readonly haired = true,
  ) {
    this.present = manifest;
    this.meshes = manifest.meshes.map((mesh) => readMesh(mesh, manifest.vertices));
    this.lines = new Map(manifest.lines.map((line) => [line.name, readLine(line, manifest.vertices)]));
    this.recast(manifest);
  }

  /** The cast as it is now. */
  get manifest(): Manifest {
    return this.present;
  }

  /** Takes in the cast as it is now; false: the built-in cast is another, which needs another library. */
  async renew(): Promise<boolean> {
    this.renewals += 1;
    const turn = this.renewals;
    const manifest = decode(await fetchWithRetry("/manifest", this.read)) as Manifest;
    if (manifest.base !== this.present.base) return false;
    if (turn === this.renewals) this.recast(manifest); // else a newer one is on its way
    return true;
  }

  /** Another cast on the same built-in one: names come, change what they stand for, or go. */
  recast(manifest: Manifest): void {
    this.present = manifest;
    const { faces, expressions, figures } = manifest;
    const poses = figures?.poses ?? [];
    const named = (documents: readonly { name: string; source: string }[]) =>
      new Map(documents.map(({ name, source }) => [name, source]));
    this.sources = { faces: named(faces), expressions: named(expressions), poses: named(poses) };
    this.unread = poses;
    for (const face of manifest.faces) this.faces.set(face.source, this.haired ? face : shaved(face));
    for (const expression of manifest.expressions) this.expressions.set(expression.source, expression);
  }

  /** What a name of the cast stands for now; a source stands for itself, and so does a name that the cast has not. */
  sourceOf(kind: SourceKind, name: string): string {
    return this.sources[kind].get(name) ?? name;
  }

  /** The library of the server that served this page; waits until the server is there. `haired`: else its heads are bald. */
  static async open(haired = true, read: Fetch = fetchBytes): Promise<Library> {
    return new Library(decode(await fetchWithRetry("/manifest", read)) as Manifest, read, haired);
  }

  /** Whether the cast has bodies. */
  get hasFigures(): boolean {
    return (this.manifest.figures?.bodies.length ?? 0) > 0;
  }

  hasFace(source: string): boolean {
    return this.faces.has(source);
  }

  hasExpression(source: string): boolean {
    return this.expressions.has(source) || source.startsWith(KEY);
  }

  /** The positions of a face by its source, (vertices, 3) metres. */
  positions(face: string): Promise<Float32Array> {
    return remembered(this.positioned, face, async () => {
      const url = this.faces.get(face)?.url;
      if (url === undefined) throw new Error(`There is no face "${face}" in this cast.`);
      const asset = decode(await fetchWithRetry(url, this.read)) as FaceAsset;
      const positions = new Float32Array(aligned(asset.positions));
      if (positions.length !== 3 * this.manifest.vertices)
        throw new Error(`Face "${face}" has ${positions.length / 3} vertices, expected ${this.manifest.vertices}.`);
      return positions;
    });
  }

  /** The strands of a hair style. */
  hair(style: string): Promise<HairStrands> {
    return remembered(this.styles, style, async () => {
      const url = this.manifest.hair.find(({ name }) => name === style)?.url;
      if (url === undefined) throw new Error(`There is no hair style "${style}" in this cast.`);
      return readStrands(decode(await fetchWithRetry(url, this.read)) as HairAsset, this.manifest.skin);
    });
  }

  /** One face wearing one expression, by their sources, less the face. */
  compound(face: string, expression: string): Promise<Compound> {
    const path = [this.manifest.base, face, expression].map(encodeURIComponent).join("/");
    return remembered(this.compounds, path, async () => {
      if (!this.hasFace(face) || !this.hasExpression(expression))
        throw new Error(`There is no compound of "${face}" and "${expression}" in this cast.`);
      return readCompound(await fetchWithRetry(`/compounds/${path}`, this.read), this.manifest.vertices);
    });
  }

  /** What all bodies share; an Error where the cast has no figures. */
  figures(): Promise<FigureSpace> {
    this.space ??= this.readFigures();
    this.space.catch(() => {
      this.space = undefined; // a failure may be asked again
    });
    return this.space;
  }

  private async readFigures(): Promise<FigureSpace> {
    const url = this.manifest.figures?.url;
    if (url === undefined) throw new Error("This cast has no figures; bake it again.");
    const garments = (this.manifest.figures?.garments ?? []).map(({ name }) => name);
    return readFigureSpace(decode(await fetchWithRetry(url, this.read)) as FigureAsset, this.manifest.skin, garments);
  }

  /** A body by its name. */
  body(name: string): Promise<Body> {
    return remembered(this.bodies, name, async () => {
      const url = this.manifest.figures?.bodies.find((body) => body.name === name)?.url;
      if (url === undefined) throw new Error(`There is no body "${name}" in this cast.`);
      const [space, bytes] = await Promise.all([this.figures(), fetchWithRetry(url, this.read)]);
      return readBody(decode(bytes) as BodyAsset, space);
    });
  }

  /** Makes a pose known that the cast has not, in place of the one that was shown before. */
  showPose(name: string, pose: { readonly [what in keyof FigurePose]: ArrayLike<number> }): void {
    if (this.shown !== name) (this.poses as Map<string, FigurePose>).delete(this.shown);
    this.shown = name;
    const [turns, travel, feet, feetTurns] = [pose.turns, pose.travel, pose.feet, pose.feetTurns].map((values) =>
      Float32Array.from(values),
    ) as [Float32Array, Float32Array, Float32Array, Float32Array];
    (this.poses as Map<string, FigurePose>).set(name, { turns, travel, feet, feetTurns });
  }

  /** Every pose that ever was in the cast, by source; none where it has no figures. */
  get poses(): ReadonlyMap<string, FigurePose> {
    const come = this.unread.filter(({ source }) => !this.posed.has(source));
    this.unread = [];
    if (come.length > 0)
      this.posed = new Map([...this.posed, ...come.map((pose) => [pose.source, readFigurePose(pose)] as const)]);
    return this.posed;
  }

  /** The picture on a face's skin, decoded off the main thread; it is the caller's to close. */
  async albedo(face: string): Promise<ImageBitmap> {
    const digest = this.faces.get(face)?.albedo;
    if (!digest) throw new Error(`There is no picture on the skin of "${face}".`);
    const bytes = await fetchWithRetry(`/albedos/${digest}/${encodeURIComponent(face)}`, this.read);
    return decodePicture(bytes);
  }

  /** The layers of the skin (tools/baking/skin/mask.py says what they hold): they lie one below the other in one picture. */
  layers(): Promise<ImageBitmap[]> {
    this.picture ??= fetchWithRetry(this.manifest.mask, this.read).then((bytes) =>
      cutSquares(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: "image/png" })),
    );
    return this.picture;
  }
}

function remembered<T>(memory: Map<string, Promise<T>>, key: string, make: () => Promise<T>): Promise<T> {
  const cached = memory.get(key);
  if (cached !== undefined) return cached;
  const promise = make();
  memory.set(key, promise);
  promise.catch(() => memory.delete(key)); // a failure may be asked again
  return promise;
}

/** Pictures whose bytes stay as they are. */
const RAW: ImageBitmapOptions = { premultiplyAlpha: "none", colorSpaceConversion: "none" };

/** The texels of a PNG as they are, decoded off the main thread. */
export const decodePicture = (bytes: Uint8Array): Promise<ImageBitmap> =>
  createImageBitmap(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: "image/png" }), RAW);

/** The squares of a tall picture from top to bottom, their bytes untouched. */
async function cutSquares(file: Blob): Promise<ImageBitmap[]> {
  const whole = await createImageBitmap(file, RAW);
  const { width: side, height } = whole;
  const rows = Array.from({ length: Math.floor(height / side) }, (_, row) => row * side);
  const squares = await Promise.all(rows.map((top) => createImageBitmap(whole, 0, top, side, side, RAW)));
  whole.close();
  return squares;
}
