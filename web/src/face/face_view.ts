/** Draws one face on a canvas: pose in, picture out. */

import * as THREE from "three";
import type { Library } from "../link/assets";
import { type Anatomy, loadAnatomy } from "./anatomy/anatomy";
import { AssetResidency, namesOf } from "./blend/asset_residency";
import { Blender, type Eyeballs } from "./blend/blender";
import { frameHead, PORTRAIT, portraitCamera, type Shot, type Tile, tileView } from "./framing";
import { EdgeSmoothing } from "./gpu/edge_smoothing";
import { PictureCrossfade } from "./gpu/picture_crossfade";
import { createRenderer, NO_WEBGL2 } from "./gpu/renderer";
import { Hair } from "./hair/hair";
import { eyeTraitsOf, writeEyeTraits } from "./head/eye_traits";
import { FaceLooks } from "./head/face_looks";
import { buildHead, type EyeUniforms, eyeUniforms, type HeadUniforms, headUniforms } from "./head/head";
import { Backdrop } from "./light/backdrop";
import { writeLight } from "./light/light_uniforms";
import { before, mixLights } from "./light/lights";
import { Shadow } from "./light/shadow";
import type { Triple } from "./light/tone";
import { headOf } from "./pose/head_answer";
import { type Pose, restPose, writeTurn } from "./pose/pose";
import { type Arrival, SourceCrossfade } from "./pose/source_crossfade";
import { FEATURES, featuresOf, firstLevel, type Level, pixelRatio } from "./quality/quality_levels";
import { drawsInSoftware, hasWebGL2 } from "./quality/software_rendering";
import { applyLayers } from "./skin/skin_layers";

/** How a view draws; everything may be left out. */
export interface FaceViewOptions {
  /** The page shows through (premultiplied alpha), no backdrop. */
  transparent?: boolean;
  /** A colour behind the head, in linear light, instead of the light's own. */
  background?: Triple | undefined;
  /** A light instead of the pose's. */
  light?: string | undefined;
  /** This view's place on a wall. */
  tile?: Tile | undefined;
  /** Device pixels per CSS pixel, at most. */
  pixelRatio?: number;
  /** What the picture may cost; by default what suits the machine. */
  level?: Level | undefined;
  shot?: Shot;
}

/** Nothing is coming. */
const NOBODY: { faces: readonly string[]; expressions: readonly string[] } = { faces: [], expressions: [] };

/** A drawn face on a canvas: shows any pose of the cast, blended on the GPU; survives a lost context. */
export class FaceView {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly camera = portraitCamera();
  private readonly eyes: Eyeballs;
  private readonly eyeUniforms: [EyeUniforms, EyeUniforms] = [eyeUniforms(), eyeUniforms()];
  private readonly looks: FaceLooks;
  private readonly hair: Hair;
  private readonly sourceCrossfade: SourceCrossfade;
  private readonly size = new THREE.Vector2();
  private scene = new THREE.Scene();
  private backdrop = new Backdrop();
  private shared!: HeadUniforms;
  private blender!: Blender;
  private residency!: AssetResidency;
  private shadow!: Shadow;
  private called: Pose; // by the names of the cast
  private pose: Pose; // by source, as it is drawn
  private blended = "";
  private drawnAt: number | undefined;
  private readonly crossfade: PictureCrossfade;
  private readonly smoothing: EdgeSmoothing;
  private head = new THREE.Group();
  private nextHead: { level: Level; head: THREE.Group } | undefined;
  private wanted: Level;
  /** The level of quality that is drawn. */
  level: Level;
  /** False while the graphics context is lost. */
  alive = true;
  /** Keeps a head that turns in the middle of the picture; an audience sees it move. */
  centred = false;
  /** Whether everything of a head has been here once; before, no part of it is drawn. */
  private whole = false;

  private constructor(
    readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    readonly library: Library,
    private readonly anatomy: Anatomy,
    private readonly layers: readonly ImageBitmap[],
    private readonly options: FaceViewOptions,
  ) {
    this.level = this.wanted = options.level ?? firstLevel(drawsInSoftware());
    this.renderer = createRenderer(canvas);
    this.crossfade = new PictureCrossfade(this.renderer);
    this.smoothing = new EdgeSmoothing(this.renderer);
    this.eyes = {
      rows: anatomy.eyeRows,
      centres: new Float32Array(6),
      radii: new Float32Array(2),
      turns: new Float32Array(18),
    };
    this.looks = new FaceLooks(library.faces);
    this.hair = new Hair(library, anatomy);
    this.sourceCrossfade = new SourceCrossfade(library);
    this.called = this.pose = restPose(library.manifest.faces[0]?.name ?? "generic");
    this.build();
    canvas.addEventListener("webglcontextlost", this.contextLost);
    canvas.addEventListener("webglcontextrestored", this.contextRestored);
  }

  /** A view of a library's cast; an Error with a message when the browser gives no WebGL2. */
  static async load(
    canvas: HTMLCanvasElement | OffscreenCanvas,
    library: Library,
    options: FaceViewOptions = {},
  ): Promise<FaceView> {
    if (!hasWebGL2()) throw new Error(NO_WEBGL2); // first: what cannot be drawn is not fetched
    const [anatomy, layers] = await Promise.all([loadAnatomy(library), library.layers().catch(() => [])]);
    return new FaceView(canvas, library, anatomy, layers, options);
  }

  /** What the next `render` draws; `coming`: names that will be needed soon and are fetched ahead. */
  show(pose: Pose, coming = NOBODY): void {
    this.called = pose;
    const names = namesOf(pose);
    const faces = this.sourceCrossfade.wanted("faces", [...names.faces, ...coming.faces]);
    const expressions = this.sourceCrossfade.wanted("expressions", [...names.expressions, ...coming.expressions]);
    this.residency.want(faces, expressions);
    this.hair.want(faces);
  }

  /** Draws at another level from when its shaders are ready on, fading over to it. */
  async change(level: Level): Promise<void> {
    if (level === this.wanted) return;
    this.wanted = level;
    const [head, { shared }] = [this.buildHead(level), this];
    await this.renderer.compileAsync(head, this.camera, this.scene);
    if (this.wanted === level && this.shared === shared) this.nextHead = { level, head };
    else this.hair.drop(head); // another level was wished for meanwhile, or the context was lost
  }

  /** Sets the size in CSS pixels. */
  resize(width: number, height: number): void {
    const display = Math.min(globalThis.devicePixelRatio ?? 1, this.options.pixelRatio ?? 2);
    this.renderer.setPixelRatio(pixelRatio(FEATURES[this.level], width, height, display));
    this.renderer.setSize(Math.max(1, width), Math.max(1, height), false);
  }

  /** Draws; `atOnce` shows everything that is loaded in full, without catching up. False while the context is lost. */
  render(time = performance.now() / 1000, atOnce = false): boolean {
    if (!this.alive) return false;
    const seconds = Math.min(0.1, Math.max(0, time - (this.drawnAt ?? time)));
    this.drawnAt = time;
    const arrival: Arrival = (faces, worn) => this.residency.arrival(faces, worn, this.blender);
    this.pose = this.sourceCrossfade.pose(this.called, seconds, arrival, atOnce);
    this.blend(seconds, atOnce);
    this.hair.dress(this.residency.faces(this.pose, this.blender), seconds, atOnce || !this.whole);
    this.whole ||= this.blended !== "" && (atOnce || this.hair.here); // at once: what is wanted for later may be on its way
    if (this.nextHead !== undefined) this.exchange(this.nextHead);
    this.head.visible = this.whole;
    this.paint();
    this.crossfade.paint(seconds);
    return true;
  }

  /** Fetches all that a pose needs, then draws it in full, as at `time` in seconds; fetches for `next` meanwhile. */
  async present(pose: Pose, time?: number, next?: Pose): Promise<void> {
    this.show(pose);
    await Promise.all([this.residency.complete(), this.hair.complete()]);
    for (const shown of [next ?? pose, pose]) this.show(shown); // others may have shown something meanwhile
    this.render(time, true);
  }

  /** Whether all of the present pose shows in full. */
  get settled(): boolean {
    const { alive, sourceCrossfade, residency, hair } = this;
    return alive && sourceCrossfade.settled(this.called) && residency.settled(this.pose, this.blender) && hair.settled;
  }

  /** The graphics context that the view draws with. */
  get context(): WebGL2RenderingContext {
    return this.renderer.getContext() as WebGL2RenderingContext;
  }

  /** The blended positions, (vertices, 3) metres, read back from the GPU (slow: for tests). */
  readPositions(): Float32Array {
    return this.blender.readPositions();
  }

  /** Frees the GPU; the canvas keeps its context. */
  dispose(): void {
    this.alive = false;
    this.canvas.removeEventListener("webglcontextlost", this.contextLost);
    this.canvas.removeEventListener("webglcontextrestored", this.contextRestored);
    for (const part of [this.blender, this.shadow, this.smoothing, this.renderer]) part.dispose();
  }

  private build(): void {
    const { fans, correctives } = this.anatomy;
    this.blender = new Blender(this.context, this.library.manifest.vertices, fans, correctives);
    this.residency ??= new AssetResidency(this.library, correctives?.size);
    this.shared = headUniforms(this.blender.positions, this.blender.normals);
    this.shadow = new Shadow(this.shared);
    applyLayers(this.shared, this.layers, featuresOf(this.wanted, drawsInSoftware()));
    this.scene = new THREE.Scene();
    this.backdrop = new Backdrop();
    if (!this.options.transparent) this.scene.add(this.backdrop.mesh);
    this.level = this.wanted;
    this.hair.drop(this.head);
    this.head = this.buildHead(this.level);
    this.scene.add(this.head);
    this.nextHead = undefined;
    this.blended = "";
    this.renderer.resetState();
  }

  private buildHead(level: Level, features = featuresOf(level, drawsInSoftware())): THREE.Group {
    const { library, anatomy, shared, eyeUniforms: eyes } = this;
    const head = buildHead({ meshes: library.meshes, anatomy, shared, eyes, features });
    this.hair.on(head, shared, features);
    return head;
  }

  /** Keeps the picture of the old level to fade from, and puts the head of the new one on the stage. */
  private exchange({ level, head }: { level: Level; head: THREE.Group }): void {
    this.nextHead = undefined;
    this.paint();
    this.crossfade.begin();
    this.scene.remove(this.head);
    this.hair.drop(this.head);
    for (const child of this.head.children) if (child instanceof THREE.Mesh) child.geometry.dispose();
    this.scene.add(head);
    [this.level, this.head] = [level, head];
    this.renderer.getSize(this.size);
    this.resize(this.size.x, this.size.y);
  }

  private readonly contextLost = (event: Event): void => {
    event.preventDefault(); // or it never comes back
    this.alive = false;
  };

  private readonly contextRestored = (): void => {
    this.build();
    this.alive = true;
    this.render(undefined, true); // all is in memory: nothing is eased
  };

  private blend(seconds: number, atOnce: boolean): void {
    const mix = this.residency.mix(this.pose, this.blender, seconds, atOnce);
    if (mix.entries.length === 0) return; // nothing loaded yet: what shows stays
    const key = JSON.stringify([mix.entries, this.pose.eyes]);
    if (key === this.blended) return;
    this.blended = key;
    this.looks.writeCentres(this.pose, this.eyes.centres);
    this.looks.writeRadii(this.pose, this.eyes.radii);
    writeTurn(this.pose.eyes[0], this.pose.eyes[1], this.eyes.turns, 0);
    writeTurn(this.pose.eyes[2], this.pose.eyes[3], this.eyes.turns, 9);
    this.blender.blend(mix, this.eyes);
    this.renderer.resetState();
  }

  private paint(): void {
    this.renderer.getSize(this.size);
    const { x: width, y: height } = this.size;
    const { tile } = this.options;
    this.turnHead();
    const head = { ...this.shared, straight: this.looks.extremes(this.pose), centred: this.centred };
    const columns = frameHead(this.camera, this.options.shot ?? PORTRAIT, head, [width, height], tile);
    this.backdrop.place(tile === undefined ? [width, height, 0, 0, width, height] : tileView(tile, width, height));
    this.looks.dress(this.pose, this.shared, this.eyeUniforms);
    writeEyeTraits(eyeTraitsOf(this.pose, this.library), this.shared);
    this.lightUp();
    this.backdrop.first = FEATURES[this.level].multisample;
    this.smoothing.render(this.scene, this.camera, this.backdrop.first, columns);
  }

  /** The light on air, or that of this stage alone. */
  private lightUp(): void {
    const { light: own, background } = this.options;
    const mixed = mixLights(own === undefined ? this.pose.light : { [own]: 1 });
    const light = background === undefined ? mixed : before(mixed, background);
    writeLight(light, this.shared);
    this.backdrop.light(light);
    this.shadow.draw(this.renderer, light, this.head, FEATURES[this.level].shadow);
  }

  /** Head: yaw, then pitch, then roll; + is the character's left, up, tilt to its left. */
  private turnHead(): void {
    const [yaw, pitch, roll] = headOf(this.pose, this.library);
    const turn = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(-pitch, yaw, -roll, "YXZ"));
    this.shared.headTurn.value.setFromMatrix4(turn);
    const pivot = this.shared.pivot.value;
    this.eyeUniforms.forEach((eye, side) => {
      eye.centre.value
        .fromArray(this.eyes.centres, 3 * side)
        .sub(pivot)
        .applyMatrix3(this.shared.headTurn.value)
        .add(pivot);
      eye.eyeTurn.value.fromArray(this.eyes.turns, 9 * side).premultiply(this.shared.headTurn.value);
    });
  }
}
