/** Pictures of certain people's skin on the GPU: fetched lazily, uploaded one a frame, eased in where they come late. */

import * as THREE from "three";
import type { Library } from "../../link/assets";
import type { ShownPicture } from "./picture_mix";
import { type LayerFilter, pictureTexture } from "./skin_layers";

/** Seconds in which a picture that came late grows over the painted skin. */
const EASE = 0.4;

/** Pictures that stay on the GPU, 5.6 or 22 MB each; more only while they are on air. */
const KEPT = 8;

interface Held extends ShownPicture {
  texture: THREE.Texture;
  grown: number;
  readonly picture: ImageBitmap;
  uploaded: boolean;
}

/** The pictures of a view, by their digests, shared by all of its characters; the least recently used goes. */
export class SkinPictures {
  private readonly held = new Map<string, Held>();
  private readonly asked = new Map<string, Promise<void>>();
  private readonly lost = new Set<string>();
  private wanted = new Set<string>();

  constructor(
    private readonly library: Pick<Library, "faces" | "albedo">,
    private readonly upload: (texture: THREE.Texture) => void,
    private filter: LayerFilter = { detail: false, anisotropy: 1 },
  ) {}

  /** Fetches the pictures of these faces, and keeps them until the next frame at least. */
  want(faces: Iterable<string>): void {
    for (const face of faces) {
      const digest = this.digestOf(face);
      if (digest === undefined) continue;
      this.wanted.add(digest);
      const held = this.held.get(digest);
      if (held !== undefined) {
        this.held.delete(digest); // the last in the order is the newest
        this.held.set(digest, held);
      } else this.fetch(digest, face);
    }
  }

  /** Waits until all pictures that are wanted have come, or were refused. */
  async complete(): Promise<void> {
    await Promise.all(this.asked.values());
  }

  /** Whether the pictures of these faces have come, or were refused. */
  here(faces: Iterable<string>): boolean {
    return this.every(faces, () => true);
  }

  /** Whether the pictures of these faces show in full. */
  settled(faces: Iterable<string>): boolean {
    return this.every(faces, ({ uploaded, grown }) => uploaded && grown === 1);
  }

  /**
   * Uploads what has come, one a frame, and lets it grow in, `seconds` after the last frame; at once, or where none of
   * the characters shows a face with it, in full.
   */
  advance(characters: readonly { readonly facesSeen: string[] }[], seconds: number, atOnce: boolean): void {
    const seen = new Set(characters.flatMap(({ facesSeen }) => facesSeen).map((face) => this.digestOf(face)));
    let left = atOnce ? Infinity : 1;
    for (const [digest, held] of this.held) {
      const eases = seen.has(digest) && !atOnce;
      if (held.uploaded) held.grown = eases ? Math.min(1, held.grown + seconds / EASE) : 1;
      else if (left > 0) {
        left -= 1;
        this.upload(held.texture);
        held.uploaded = true;
        held.grown = eases ? 0 : 1;
      }
    }
    this.forget(seen);
  }

  /** The picture of a face, where it has one on the GPU. */
  of(face: string): ShownPicture | undefined {
    const digest = this.digestOf(face);
    const held = digest === undefined ? undefined : this.held.get(digest);
    return held?.uploaded ? held : undefined;
  }

  /** Makes the textures anew, on another graphics context. */
  rebuild(filter: LayerFilter): void {
    this.filter = filter;
    for (const held of this.held.values()) {
      held.texture = colourTexture(held.picture, filter);
      held.uploaded = false;
    }
  }

  /** Frees all of it. */
  dispose(): void {
    for (const digest of [...this.held.keys()]) this.drop(digest);
  }

  private digestOf(face: string): string | undefined {
    return this.library.faces.get(face)?.albedo || undefined;
  }

  private every(faces: Iterable<string>, test: (held: Held) => boolean): boolean {
    return Array.from(faces).every((face) => {
      const digest = this.digestOf(face);
      if (digest === undefined || this.lost.has(digest)) return true;
      const held = this.held.get(digest);
      return held !== undefined && test(held);
    });
  }

  private fetch(digest: string, face: string): void {
    if (this.asked.has(digest) || this.lost.has(digest)) return;
    const came = this.library.albedo(face).then(
      (picture) => {
        this.held.set(digest, { picture, texture: colourTexture(picture, this.filter), grown: 0, uploaded: false });
      },
      (error: unknown) => {
        this.lost.add(digest);
        console.warn(String(error));
      },
    );
    this.asked.set(
      digest,
      came.finally(() => this.asked.delete(digest)),
    );
  }

  private forget(seen: ReadonlySet<string | undefined>): void {
    for (const [digest, { uploaded }] of this.held) {
      if (this.held.size <= KEPT) break;
      if (uploaded && !this.wanted.has(digest) && !seen.has(digest)) this.drop(digest);
    }
    this.wanted = new Set();
  }

  private drop(digest: string): void {
    const held = this.held.get(digest);
    this.held.delete(digest);
    held?.texture.dispose();
    held?.picture.close();
  }
}

/** Read, filtered and made smaller in linear light. */
const colourTexture = (picture: ImageBitmap, filter: LayerFilter): THREE.Texture =>
  Object.assign(pictureTexture(picture, filter), { colorSpace: THREE.SRGBColorSpace });
