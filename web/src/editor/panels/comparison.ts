/** The comparison of two contents on one face, as a heat map of the distances. */

import { decode } from "@msgpack/msgpack";
import { css, html } from "lit";
import { customElement, property, queryAll, state } from "lit/decorators.js";
import { aligned } from "../../link/arrays";
import { fetchWithRetry } from "../../link/assets";
import type { ContentAsset } from "../../link/messages";
import { curtain } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { MILLIMETRES, shown } from "../controls/units";
import type { DraftStore } from "../session/draft_store";
import { distances, drawShape, FINER, heat, largest, largestSeen, SKIN } from "./shape_difference";

/** One of two things that are compared: a content, and what people call it. */
export interface ComparedContent {
  readonly content: string;
  readonly label: string;
}

/** Below this all is called alike, metres: what the wire rounds away. */
const ALIKE = 2e-5;

const style = css`
  section {
    padding: 14px 16px;
    display: grid;
    gap: 10px;
    max-height: 100%;
    max-width: 100%;
    overflow: auto;
  }
  .pictures {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 320px));
    gap: 8px;
  }
  figure {
    display: grid;
    gap: 4px;
  }
  canvas {
    width: 100%;
    border: 1px solid var(--line);
    border-radius: 5px;
  }
  figcaption {
    color: var(--dim);
    text-align: center;
  }
`;

/** Two revisions beside each other, and where they differ. */
@customElement("omote-comparison")
export class Comparison extends EditorElement {
  @property({ attribute: false }) sides!: readonly [ComparedContent, ComparedContent];
  @state() private sentence = "Drawing…";
  @queryAll("canvas") private canvases!: NodeListOf<HTMLCanvasElement>;
  static override styles = [base, controls, curtain, style];

  constructor() {
    super();
    layerWhileShown(this, "dialog", this.close);
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("button")?.focus();
    this.#draw().catch((error: unknown) => {
      this.sentence = error instanceof Error ? error.message : String(error);
    });
  }

  async #draw(): Promise<void> {
    const { store } = this;
    const worn = ({ content }: ComparedContent): Promise<Float32Array> =>
      store.face === null ? wearing(store, store.sourceOf(store.work), content) : wearing(store, content, "neutral");
    const [shape, other] = await Promise.all(this.sides.map(worn));
    if (shape === undefined || other === undefined) return;
    const apart = distances(shape, other);
    const most = largest(apart);
    const meshes = (store.library?.meshes ?? []).filter(({ name }) => !name.includes("lash"));
    const [first, second, third] = [...this.canvases] as [HTMLCanvasElement, HTMLCanvasElement, HTMLCanvasElement];
    drawShape(first, shape, meshes, () => SKIN);
    drawShape(second, other, meshes, () => SKIN);
    void this.#portray([first, second]);
    const seen = largestSeen(apart, other, meshes);
    drawShape(third, other, meshes, (row) => heat((apart[row] as number) / Math.max(seen, ALIKE)));
    this.sentence = differenceOf(most, seen);
  }

  /** The first two as they look on a stage; the plain shapes stay where that fails. */
  async #portray(canvases: readonly HTMLCanvasElement[]): Promise<void> {
    const thumbnailRenderer = this.context.thumbnailRenderer();
    if (thumbnailRenderer === null) return;
    const work = this.store.sourceOf(this.store.work);
    for (const [at, canvas] of canvases.entries()) {
      const { content } = this.sides[at] as ComparedContent;
      const sitting =
        this.store.face === null ? { face: work, expression: content } : { face: content, expression: "neutral" };
      const picture = await thumbnailRenderer
        .picture(sitting, FINER * canvas.width, FINER * canvas.height)
        .catch(() => null);
      if (picture !== null) canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
    }
  }

  override render() {
    const picture = (caption: unknown) =>
      html`<figure><canvas width="480" height="520"></canvas><figcaption>${caption}</figcaption></figure>`;
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Comparison">
      <div class="pictures">
        ${picture(this.sides[0].label)} ${picture(this.sides[1].label)}
        ${picture(html`<span role="status">${this.sentence}</span>`)}
      </div>
      <div class="row"><span class="grow"></span><button @click=${this.close}>Close</button></div>
    </section>`;
  }
}

/** What the picture of distances says: by how much two shapes differ, and by how much where it shows them. */
export function differenceOf(most: number, seen: number): string {
  const millimetres = (metres: number): string => `${shown(metres, MILLIMETRES)} mm`;
  if (most < ALIKE) return "They are alike.";
  const hidden = `${millimetres(most)} where you do not see it: behind, or inside the mouth`;
  if (seen < ALIKE) return `They look alike from here. They differ by up to ${hidden}.`;
  const here = `They differ by up to ${millimetres(seen)}, where it is red`;
  return millimetres(most) === millimetres(seen) ? `${here}.` : `${here}; by up to ${hidden}.`;
}

/** The positions of a face by its source, (vertices, 3) metres. */
async function facePositions({ library }: DraftStore, source: string): Promise<Float32Array> {
  if (library === null) throw new Error("The cast is not here yet; wait a moment.");
  if (library.hasFace(source)) return library.positions(source);
  const asset = decode(await fetchWithRetry(`/contents/${source.slice(1)}`)) as ContentAsset;
  return new Float32Array(aligned(asset.positions));
}

/** A face (a source) that wears an expression (a source), (vertices, 3) metres. */
async function wearing(store: DraftStore, face: string, expression: string): Promise<Float32Array> {
  const rest = await facePositions(store, face);
  if (expression === "neutral" || store.library === null) return rest;
  const { scale, indices, deltas } = await store.library.compound(face, expression);
  const worn = rest.slice();
  indices.forEach((row, at) => {
    for (let axis = 0; axis < 3; axis += 1)
      worn[3 * row + axis] = (worn[3 * row + axis] as number) + scale * (deltas[3 * at + axis] as number);
  });
  return worn;
}
