/** The faces of the canvas as `face/` draws them: plain heads, whose rows the page itself has computed. */

import * as THREE from "three";
import type { Anatomy } from "../../../face/anatomy/anatomy";
import { type BallFrame, ballFrame } from "../../../face/anatomy/eye_mesh";
import { type Opening, opening } from "../../../face/anatomy/openings";
import { normalAt } from "../../../face/anatomy/topology";
import { ROW_WIDTH } from "../../../face/gpu/pass_shaders";
import { material } from "../../../face/gpu/renderer";
import { type RibbonStyle, ribbons, type StyleUniforms, styleUniforms } from "../../../face/hair/hair_geometry";
import { rootDensity, rootsTexture } from "../../../face/hair/hair_roots";
import { fullStrands, offsetsOn } from "../../../face/hair/hair_strands";
import { COLLAR_FRAGMENT, COLLAR_VERTEX, collar } from "../../../face/head/collar";
import { eyeTraitsOf, writeEyeTraits } from "../../../face/head/eye_traits";
import { FaceLooks } from "../../../face/head/face_looks";
import { eyeUniforms, geometryOf, type HeadUniforms, headUniforms } from "../../../face/head/head";
import { type CharacterUniforms, copyHead, type HeadTemplate, headTemplate } from "../../../face/head/head_template";
import { writeLight } from "../../../face/light/light_uniforms";
import { LIGHTS, type Light, lightAlong } from "../../../face/light/lights";
import { named } from "../../../face/pose/complexion";
import { restPose, writeTurn } from "../../../face/pose/pose";
import { definesOf, FEATURES, type Features, featuresOf } from "../../../face/quality/quality_levels";
import { writeBlood } from "../../../face/skin/blood";
import { applyLayers } from "../../../face/skin/skin_layers";
import { SkinPaint } from "../../../face/skin/skin_paint";
import { skinParts } from "../../../face/skin/skin_parts";
import { SkinPictures } from "../../../face/skin/skin_pictures";
import type { Library } from "../../../link/assets";
import type { FaceDocument } from "../../../link/messages";
import type { HairStrands } from "../../../link/strands";
import { loadPicture } from "../../session/asset_loading";
import type { Box } from "../math/boxes";
import type { Bounds, Camera } from "../math/camera";
import { coarseMeshes, FINENESS } from "../math/coarse_mesh";
import { cut, type Surface } from "../math/triangle_cut";
import { rowOf } from "../math/vectors";
import type { ChangedRows } from "../model/changed_rows";
import type { Figure } from "../model/figure";
import { type Ball, ballOf, type Gaze, shows } from "../model/gaze";
import { Repaint } from "./repaint";

/** A face that is shown, or was. */
export interface ShownFace {
  source: string;
  document: FaceDocument;
  figure: Figure;
  /** At rest, (rows, 3) metres: what its hair is posed on. */
  rest: Float32Array;
  bounds: Bounds;
  /** What draws it; undefined: it is not shown, or not yet. */
  drawn: DrawnFace | undefined;
}

/** How collar and hair cover what is behind them: colours as they are, and in alpha what is left of the background, nothing. */
const COVERING = {
  blending: THREE.CustomBlending,
  blendSrc: THREE.OneFactor,
  blendDst: THREE.ZeroFactor,
  blendSrcAlpha: THREE.ZeroFactor,
  blendDstAlpha: THREE.ZeroFactor,
};

/** Draws faces on a context, each on the same head; those that leave are kept for others that come. */
export class DrawnFaces {
  readonly renderer: THREE.WebGLRenderer;
  /** The uniforms whose textures hold for all faces. */
  readonly common = headUniforms(null, null);
  readonly template: HeadTemplate;
  /** The skin for heads that are shown smaller and smaller (`FINENESS`). */
  readonly coarse: readonly THREE.BufferGeometry[];
  /** What collar and hair may cost: they are drawn once a view. */
  readonly still: Features;
  readonly features: Features;
  readonly frames: readonly BallFrame[];
  readonly lips: Opening | undefined;
  private readonly documents = new Map<string, FaceDocument>();
  private readonly pictures: SkinPictures;
  private readonly all: DrawnFace[] = [];
  private readonly free: DrawnFace[] = [];
  private readonly roots = new Map<HairStrands | undefined, THREE.DataTexture>();

  /** layers: the pictures of the skin that all faces share; software: the context draws without a graphics processor. */
  constructor(
    gl: WebGL2RenderingContext,
    private readonly library: Pick<Library, "meshes" | "hair" | "manifest">,
    readonly anatomy: Anatomy,
    layers: readonly ImageBitmap[],
    software: boolean,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas: gl.canvas as HTMLCanvasElement, context: gl });
    gl.getExtension("EXT_color_buffer_float"); // to read positions back
    this.renderer.autoClear = false;
    this.renderer.setClearColor(0x000000, 1);
    this.features = { ...featuresOf(software ? "lowest" : "good", software), shadow: 0 };
    this.still = { ...FEATURES[software ? "low" : "good"], shadow: 0, multisample: true };
    applyLayers(this.common, layers, this.features);
    const parts = { meshes: library.meshes, anatomy: { ...anatomy, rim: [] }, features: this.features };
    this.template = headTemplate(parts, this.common);
    this.coarse = coarseMeshes(library.meshes, anatomy).map((mesh) => {
      const geometry = geometryOf(mesh);
      skinParts(geometry, mesh, anatomy, this.common, false);
      return geometry.setIndex(new THREE.BufferAttribute(mesh.triangles, 1)); // its large triangles too
    });
    this.frames = [0, 1].flatMap((side) => {
      const [first, end] = [anatomy.eyeRows[2 * side] as number, anatomy.eyeRows[2 * side + 1] as number];
      return end > first ? [ballFrame(anatomy.positions, first, end)] : [];
    });
    const lips = anatomy.lines.get("lips");
    this.lips = lips && opening([...lips], anatomy.positions);
    const albedo = (face: string): Promise<ImageBitmap> => loadPicture(this.documents.get(face) as FaceDocument);
    const upload = (texture: THREE.Texture): void => this.renderer.initTexture(texture);
    this.pictures = new SkinPictures({ faces: this.documents, albedo }, upload, this.features);
  }

  /** Waits for the picture on a face's skin and for its hair, as a face at `rest` ((rows, 3) metres) wears it. */
  async wardrobe(document: FaceDocument, rest: Float32Array): Promise<RibbonStyle | undefined> {
    const { hair_style: name } = document.look;
    this.documents.set(document.source, document);
    this.pictures.want([document.source]);
    const refused = (error: unknown): undefined => console.warn(String(error)) as undefined;
    const [hair] = await Promise.all([
      name === "" ? undefined : this.library.hair(name).catch(refused),
      this.pictures.complete(),
    ]);
    return hair && { name, hair, strands: fullStrands(hair, offsetsOn(hair, this.anatomy.positions, rest)) };
  }

  /** Where the hair of a style grows out of the skin; undefined: the shade of hair on who wears none. */
  rootsOf(hair: HairStrands | undefined): THREE.DataTexture {
    const { positions, traits } = this.anatomy;
    const known = this.roots.get(hair);
    if (known !== undefined) return known;
    const texture = rootsTexture(positions.length / 3);
    const density = hair && rootDensity(hair, positions, this.library.manifest.skin);
    (texture.image.data as Float32Array).set(density ?? traits.filter((_, at) => at % 4 === 2));
    this.roots.set(hair, texture);
    return texture;
  }

  /** The looks of a face, with the picture on its skin where that is here. */
  looksOf(document: FaceDocument): FaceLooks {
    const seen = this.all.map((face) => ({ facesSeen: [face.source] }));
    this.pictures.advance([...seen, { facesSeen: [document.source] }], 0, true);
    return new FaceLooks(new Map([[document.source, document]]), (face) => this.pictures.of(face));
  }

  /** What draws one more face. */
  take(): DrawnFace {
    const face = this.free.pop() ?? new DrawnFace(this, this.library.manifest.vertices);
    this.all.push(face);
    return face;
  }

  /** Takes back what draws a face no more. */
  give(face: DrawnFace): void {
    this.all.splice(this.all.indexOf(face), 1);
    this.free.push(face);
  }

  dispose(): void {
    this.renderer.dispose();
  }
}

/** A part of a head, and its triangles as far as they are drawn. */
interface Part extends Surface {
  readonly mesh: THREE.Mesh;
  readonly whole: THREE.BufferGeometry;
  readonly some: THREE.BufferGeometry;
  readonly index: THREE.BufferAttribute;
  count: number;
}

/** What draws one face of the canvas. */
export class DrawnFace {
  /** The source of the face that it was dressed in last. */
  source = "";
  /** What an expression moves. */
  readonly head: THREE.Group;
  /** What it does not move: collar and hair. */
  readonly still = new THREE.Group();
  readonly repaint = new Repaint();
  /** Rises when it is dressed. */
  dressed = 0;
  readonly uniforms: CharacterUniforms;
  private readonly paint: SkinPaint;
  /** By how coarse the skin is drawn. */
  private readonly parts: readonly (readonly Part[])[];
  private readonly turns = new Float32Array(18);
  private figure: Figure | undefined;
  private lag = 0;
  private gazed = "";
  private bled = "";
  private hair: { mesh: THREE.Mesh; uniforms: StyleUniforms } | undefined;

  /** rows: of the positions. */
  constructor(
    private readonly faces: DrawnFaces,
    rows: number,
  ) {
    const { anatomy, common, template, still } = faces;
    const shared = headUniforms(null, null, common);
    [shared.positions.value, shared.normals.value] = [rowTexture(rows), rowTexture(rows)];
    this.uniforms = { shared, eyes: [eyeUniforms(), eyeUniforms()] };
    this.paint = new SkinPaint(shared);
    this.head = copyHead(template, this.uniforms);
    const meshes = this.head.children as THREE.Mesh[];
    const fine = meshes.flatMap((mesh) => partOf(mesh, mesh.geometry));
    const skin = meshes.find(({ name }) => name === "skin") as THREE.Mesh;
    const others = fine.filter(({ mesh }) => mesh.name !== "skin");
    this.parts = [fine, ...faces.coarse.map((geometry) => [...partOf(skin, geometry), ...others])];
    this.look({ angles: [0, 0, 0, 0], pupil: 0 });
    this.still.renderOrder = 1; // after a mask
    if (anatomy.rim.length === 0) return;
    const cloth = material(COLLAR_VERTEX, COLLAR_FRAGMENT, shared);
    cloth.defines = definesOf(still);
    this.add(new THREE.Mesh(collar(anatomy), cloth));
  }

  /** Dresses it in the looks of a face, and in its hair (`wardrobe`). */
  dress(document: FaceDocument, style: RibbonStyle | undefined): void {
    const { shared, eyes } = this.uniforms;
    const pose = restPose(document.source);
    this.source = document.source;
    this.dressed += 1;
    const { value: pupil } = shared.pupil;
    this.faces.looksOf(document).dress(pose, shared, eyes);
    const faces = new Map([[document.source, document]]);
    writeEyeTraits({ ...eyeTraitsOf(pose, { faces, expressions: new Map() }), pupil }, shared);
    if (!this.faces.features.pixelLight) this.paint.draw(this.faces.renderer);
    this.wear(style, document.look.hair);
  }

  /** Puts rows where a figure has them, with `lag` (0..1) of what easing holds back; `turned`: rows whose normals change. */
  put(figure: Figure, lag: number, { moved, turned }: ChangedRows["all"]): void {
    const { positions, normals } = this.uniforms.shared;
    [this.figure, this.lag] = [figure, lag];
    const [data, facing] = [dataOf(positions), dataOf(normals)];
    for (const row of moved)
      for (let axis = 0; axis < 3; axis++)
        data[4 * row + axis] =
          (figure.live[3 * row + axis] as number) + lag * (figure.offset[3 * row + axis] as number);
    this.turnEyes();
    const { fans } = this.faces.anatomy;
    for (const row of turned) facing.set(normalAt(fans, data, row, 4), 4 * row);
    positions.value.needsUpdate = true;
    normals.value.needsUpdate = true;
  }

  /** Turns its eyes, and opens its pupils. */
  look({ angles, pupil }: Gaze): void {
    this.uniforms.shared.pupil.value = pupil;
    const gazed = angles.join();
    if (gazed === this.gazed) return;
    this.gazed = gazed;
    for (const side of [0, 1] as const) {
      writeTurn(angles[2 * side] ?? 0, angles[2 * side + 1] ?? 0, this.turns, 9 * side);
      this.uniforms.eyes[side].eyeTurn.value.fromArray(this.turns, 9 * side);
    }
    this.turnEyes();
    this.uniforms.shared.positions.value.needsUpdate = true;
  }

  /** Reddens, pales and weeps by these numbers; whether they are others than before. */
  bleed(numbers: readonly number[]): boolean {
    const { shared } = this.uniforms;
    const key = [...numbers, shared.lacquer.value, shared.fur.value].join();
    if (key === this.bled) return false;
    this.bled = key;
    writeBlood(named(numbers), { lacquer: shared.lacquer.value, fur: shared.fur.value }, shared);
    return true;
  }

  /** Lights it from where a camera looks. */
  see({ right, up, back, eye }: Camera): void {
    const { shared } = this.uniforms;
    shared.viewPoint.value.fromArray(eye);
    writeLight(lightAlong(LIGHTS.portrait as Light, [right, up, back]), shared);
  }

  /** Whether its lips are apart anywhere: teeth and tongue behind closed ones are seen from nowhere. */
  private get parted(): boolean {
    const { figure, faces } = this;
    if (figure === undefined || faces.lips === undefined) return true;
    const { upper, lower } = faces.lips;
    const height = (row: number): number => figure.live[3 * row + 1] as number;
    return upper.some((row, n) => height(row) - height(lower[n] as number) > SHUT);
  }

  /** Its eyeballs as they stand. */
  get balls(): Ball[] {
    const { figure } = this;
    return figure === undefined ? [] : this.faces.frames.map((frame) => ballOf(frame, figure.base));
  }

  /** Draws all of its head from now on, fine where it is large, coarse where it is small. */
  whole(camera: Camera): void {
    for (const mesh of this.head.children) mesh.visible = mesh.name === "lashes" || EYES.includes(mesh.name);
    for (const { mesh, whole } of this.partsFor(camera)) Object.assign(mesh, { geometry: whole, visible: true });
  }

  /** Draws from now on what of its head may show in a box, while no row goes further than `reach` (metres) from its base. */
  only(box: Box, camera: Camera, reach: number): void {
    const cover = this.repaint.cover(box, reach);
    const places = cover && camera.projectAll((this.figure as Figure).base);
    const slack = (cover?.reach ?? 0) / camera.metresPerPixel(camera.middle);
    const eyes = this.balls.map((ball) => shows(ball, camera, box));
    for (const mesh of this.head.children)
      mesh.visible = mesh.name === "lashes" ? eyes.includes(true) : (eyes[EYES.indexOf(mesh.name)] ?? false);
    for (const part of this.partsFor(camera)) {
      if (MOUTH.includes(part.mesh.name)) {
        Object.assign(part.mesh, { geometry: part.whole, visible: true });
        continue;
      }
      if (cover && places) {
        part.count = cut(part, places, cover.box, slack, part.index.array as Uint32Array);
        part.some.setDrawRange(0, part.count);
        part.index.needsUpdate = true;
      }
      part.mesh.geometry = part.some;
      part.mesh.visible = part.count > 0;
    }
  }

  /** Its head as depth alone: what comes after stays away from where its skin stands before it. */
  get mask(): THREE.Group {
    this.colour(false);
    return this.head;
  }

  unmask(): void {
    this.colour(true);
  }

  private colour(colorWrite: boolean): void {
    for (const mesh of this.head.children as THREE.Mesh[]) Object.assign(mesh.material, { colorWrite });
  }

  /** Its positions as the graphics context has them, (rows, 3) metres (slow: for tests). */
  read(): Float32Array {
    const { renderer } = this.faces;
    const { value } = this.uniforms.shared.positions;
    const { width, height } = value.image as { width: number; height: number };
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const texels = new Float32Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    const { __webglTexture } = renderer.properties.get(value) as { __webglTexture: WebGLTexture };
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, __webglTexture, 0);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, texels);
    gl.deleteFramebuffer(gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer);
    renderer.resetState();
    const { rest } = this.figure as Figure;
    return rest.map((_, at) => texels[4 * Math.floor(at / 3) + (at % 3)] as number);
  }

  private partsFor(camera: Camera): readonly Part[] {
    const metresPerPixel = camera.metresPerPixel(camera.middle);
    const parts = this.parts[FINENESS.filter(({ from }) => metresPerPixel > from).length] ?? [];
    return this.parted ? parts : parts.filter(({ mesh }) => mesh.name === "skin");
  }

  private add(mesh: THREE.Mesh): void {
    mesh.frustumCulled = false;
    Object.assign(mesh.material, COVERING);
    this.still.add(mesh);
  }

  private wear(style: RibbonStyle | undefined, colour: string): void {
    if (this.hair !== undefined) {
      this.hair.mesh.removeFromParent();
      (this.hair.mesh.material as THREE.Material).dispose();
      this.hair.uniforms.strands.value.dispose();
    }
    this.hair = undefined;
    this.uniforms.shared.roots.value = this.faces.rootsOf(style?.hair);
    if (style === undefined) return;
    const uniforms = styleUniforms(style, { value: new THREE.Color().setStyle(colour) });
    this.hair = { mesh: ribbons(style, this.uniforms.shared, uniforms, this.faces.still), uniforms };
    this.add(this.hair.mesh);
  }

  /** Puts the eyeballs' rows where they are when they have turned about their middles. */
  private turnEyes(): void {
    const { figure, lag, turns, faces } = this;
    if (figure === undefined) return;
    const data = dataOf(this.uniforms.shared.positions);
    faces.frames.forEach((frame, side) => {
      const { centre } = ballOf(frame, figure.live);
      const [first, end] = faces.anatomy.eyeRows.subarray(2 * side, 2 * side + 2) as unknown as [number, number];
      for (let row = first; row < end; row++) {
        const [offset, place] = [rowOf(figure.offset, row), rowOf(figure.live, row)];
        const off = centre.map((middle, axis) => place[axis as 0] + lag * offset[axis as 0] - middle);
        centre.forEach((middle, axis) => {
          const turned = off.reduce((sum, part, n) => sum + (turns[9 * side + 3 * n + axis] as number) * part, middle);
          data[4 * row + axis] = turned;
        });
      }
    });
  }
}

/** Lips that are no farther apart are shut, metres. */
const SHUT = 0.0003;
/** The meshes of the eyeballs, left and right. */
const EYES = ["eye_left", "eye_right"];
/** Meshes that are drawn as a whole or not at all: what shows of them is not where their rows are. */
const MOUTH = ["teeth_upper", "teeth_lower", "tongue"];

const NO_ROWS = new THREE.BufferAttribute(new Float32Array(), 1);

const dataOf = ({ value }: HeadUniforms["positions"]): Float32Array =>
  (value as THREE.DataTexture).image.data as unknown as Float32Array;

function rowTexture(rows: number): THREE.DataTexture {
  const lines = Math.ceil(rows / ROW_WIDTH);
  const data = new Float32Array(4 * ROW_WIDTH * lines);
  return new THREE.DataTexture(data, ROW_WIDTH, lines, THREE.RGBAFormat, THREE.FloatType);
}

/** What of a mesh can be drawn in part; nothing where its vertices are not on rows, but the mouth, which is drawn as a whole. */
function partOf(mesh: THREE.Mesh, whole: THREE.BufferGeometry): Part[] {
  const on =
    whole.getAttribute("source") ?? whole.getAttribute("rows") ?? (MOUTH.includes(mesh.name) ? NO_ROWS : undefined);
  if (on === undefined || whole.index === null) return [];
  const some = new THREE.BufferGeometry();
  const index = new THREE.BufferAttribute(new Uint32Array(whole.index.count), 1);
  some.setIndex(index);
  for (const [name, values] of Object.entries(whole.attributes)) some.setAttribute(name, values);
  const surface = { rows: on.array, width: on.itemSize, triangles: whole.index.array };
  return [{ ...surface, mesh, whole, some, index, count: 0 }];
}
