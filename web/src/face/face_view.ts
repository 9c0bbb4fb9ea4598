/** Draws a scene of characters on a canvas: poses in, picture out. */

import * as THREE from "three";
import type { Library } from "../link/assets";
import { PORTRAIT_SIZE, type ShotSize, showsFigures } from "../link/framings";
import { type Anatomy, loadAnatomy } from "./anatomy/anatomy";
import { rowTriangles } from "./anatomy/topology";
import { Blender } from "./blend/blender";
import { type Coming, DrawnCharacter, type FigureDrawing, type SharedParts, sharedParts } from "./drawn_character";
import type { Figure } from "./figure/figure";
import { FigurePass } from "./figure/figure_pass";
import { loadFigures, type SharedFigures } from "./figure/shared_figures";
import { type PictureBox, PORTRAIT, portraitCamera, type Shot, tileView, type WallTile } from "./framing";
import { EdgeSmoothing } from "./gpu/edge_smoothing";
import { PictureCrossfade } from "./gpu/picture_crossfade";
import { createRenderer, NO_WEBGL2 } from "./gpu/renderer";
import { type HeadUniforms, headUniforms } from "./head/head";
import { type HeadTemplate, headTemplate } from "./head/head_template";
import { Backdrop } from "./light/backdrop";
import { before, mixLights } from "./light/lights";
import type { Triple } from "./light/tone";
import { type Pose, restPose } from "./pose/pose";
import { alone, lightOf, type ScenePose } from "./pose/scene_pose";
import { type Features, featuresOf, firstLevel, type Level, pixelRatio } from "./quality/quality_levels";
import { drawsInSoftware, hasWebGL2 } from "./quality/software_rendering";
import { asPortraits, type Framing, frameScene, headBoxes, portraitsAs } from "./scene_framing";
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
  tile?: WallTile | undefined;
  /** Device pixels per CSS pixel, at most. */
  pixelRatio?: number;
  /** What the picture may cost; by default what suits the machine. */
  level?: Level | undefined;
  shot?: Shot;
  /** How much of figures the picture shows where the scene's framing has portraits. */
  shotSize?: ShotSize | undefined;
}

/** From where on nothing is seen, metres: a camera stands far off for whole figures. */
const [NEAR, FAR] = [10, 60];

/** Until bodies that could not be fetched are asked for again. */
const RETRY_MILLISECONDS = 2000;

/** A level of quality, and figures or heads alone, that will be drawn once shaders and figures are ready. */
interface NextDrawing {
  level: Level;
  template: HeadTemplate;
  heads: ReadonlyMap<DrawnCharacter, THREE.Group>;
  drawing: FigureDrawing | undefined;
  figures: ReadonlyMap<DrawnCharacter, Figure>;
}

/** A scene on a canvas, or one face: shows any poses of the cast, blended on the GPU; survives a lost context. */
export class FaceView {
  private readonly renderer: THREE.WebGLRenderer;
  readonly camera = portraitCamera();
  private readonly parts: SharedParts;
  private readonly size = new THREE.Vector2();
  private readonly characters = new Map<string, DrawnCharacter>();
  private scene = new THREE.Scene();
  private backdrop = new Backdrop();
  private common!: HeadUniforms;
  private blender!: Blender;
  private drawing: FigureDrawing | undefined; // what figures are drawn with, where they are
  private passes: FigureDrawing | undefined; // of this graphics context, once figures were wanted
  private template!: HeadTemplate;
  private called: ScenePose;
  private light: Pose["light"];
  private readonly crossfade: PictureCrossfade;
  private readonly smoothing: EdgeSmoothing;
  private next: NextDrawing | undefined;
  private wanted: Level;
  private wantsFigures: boolean;
  private prepared: Promise<void> = Promise.resolve();
  /** When the picture was last shown, in seconds: what comes later begins from here. */
  shownAt: number | undefined;
  private begun = false; // a character has been drawn: one that comes after that rises into the picture
  /** The level of quality that is drawn. */
  level: Level;
  /** False while the graphics context is lost. */
  alive = true;
  /** Keeps a head that turns in the middle of the picture; an audience sees it move. */
  centred = false;
  /** What the next picture shows of a head. */
  shot: Shot;

  private constructor(
    readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    readonly library: Library,
    anatomy: Anatomy,
    private readonly layers: readonly ImageBitmap[],
    private readonly options: FaceViewOptions,
    private figures: SharedFigures | undefined,
  ) {
    this.wantsFigures = figures !== undefined;
    this.shot = options.shot ?? PORTRAIT;
    this.level = this.wanted = options.level ?? firstLevel(drawsInSoftware());
    this.renderer = createRenderer(canvas);
    this.crossfade = new PictureCrossfade(this.renderer);
    this.smoothing = new EdgeSmoothing(this.renderer);
    this.parts = sharedParts(library, anatomy, (texture) => this.renderer.initTexture(texture));
    this.called = alone(restPose(library.manifest.faces[0]?.name ?? "generic"));
    this.light = lightOf(this.called) as Pose["light"];
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
    const [anatomy, layers, figures] = await Promise.all([
      loadAnatomy(library),
      library.layers().catch(() => []),
      (options.shotSize ?? PORTRAIT_SIZE) === PORTRAIT_SIZE ? undefined : loadFigures(library),
    ]);
    return new FaceView(canvas, library, anatomy, layers, options, figures);
  }

  /** What the next `render` draws; `coming`: names that a character will need soon. */
  showScene(scene: ScenePose, coming: (name: string) => Coming = () => ({ faces: [], expressions: [] })): void {
    this.called = scene;
    this.light = lightOf(scene) ?? this.light;
    for (const [name, character] of this.characters)
      if (scene.characters[name] === undefined) {
        character.dispose(this.blender);
        this.characters.delete(name);
      }
    for (const [name, pose] of Object.entries(scene.characters)) {
      const character = this.characters.get(name) ?? this.add(name, new DrawnCharacter(this.parts, pose, !this.begun));
      character.show(pose, coming(name));
    }
    const wants = this.library.hasFigures && showsFigures(Object.keys(this.framing));
    if (wants === this.wantsFigures) return;
    this.wantsFigures = wants;
    this.prepared = this.prepare().catch((error: unknown) => {
      console.warn(String(error)); // heads stay alone until they can be fetched
      setTimeout(() => {
        this.wantsFigures = this.drawing !== undefined;
      }, RETRY_MILLISECONDS);
    });
  }

  /** Draws at another level from when its shaders are ready on, fading over to it. */
  async change(level: Level): Promise<void> {
    if (level === this.wanted) return;
    this.wanted = level;
    this.prepared = this.prepare();
    await this.prepared;
  }

  /** The weights of framings as this view has them. */
  private get framing(): Framing {
    const { framing } = this.called;
    const { shotSize } = this.options;
    return shotSize === undefined ? framing : portraitsAs(framing, shotSize);
  }

  /** Gets ready what is wanted to be drawn: shaders, heads, and figures with all that they wear. */
  private async prepare(): Promise<void> {
    const { common, wanted: level, wantsFigures } = this;
    for (const [character, head] of this.next?.heads ?? []) character.forget(head); // something else is wished for
    this.next = undefined;
    if (level === this.level && wantsFigures === (this.drawing !== undefined)) return; // as it is drawn
    if (wantsFigures) this.figures ??= await loadFigures(this.library);
    if (this.common !== common) return; // a new context has what is wanted
    const drawing = wantsFigures ? this.createDrawing() : undefined;
    const features = this.featuresAt(level, drawing);
    const [template, heads] = [this.templateOf(level, drawing), new Map<DrawnCharacter, THREE.Group>()];
    const figures = new Map<DrawnCharacter, Figure>();
    for (const character of this.characters.values()) {
      heads.set(character, character.prepare(template, features));
      if (drawing !== undefined) figures.set(character, character.createFigure(drawing.figures));
    }
    const compile = (part: THREE.Object3D) => this.renderer.compileAsync(part, this.camera, this.scene).then(() => {});
    const [first] = heads;
    if (first !== undefined) await first[0].compile(first[1], features, compile);
    await Promise.all([...figures.values()].map((figure) => figure.complete()));
    if (this.wanted === level && this.wantsFigures === wantsFigures && this.common === common)
      this.next = { level, template, heads, drawing, figures };
    else for (const [character, head] of heads) character.forget(head); // another was wished for, or the context was lost
  }

  /** Sets the size in CSS pixels. */
  resize(width: number, height: number): void {
    const display = Math.min(globalThis.devicePixelRatio ?? 1, this.options.pixelRatio ?? 2);
    this.renderer.setPixelRatio(pixelRatio(this.featuresAt(this.level, this.drawing), width, height, display));
    this.renderer.setSize(Math.max(1, width), Math.max(1, height), false);
  }

  /** Draws; `atOnce` shows everything that is loaded in full, without catching up. False while the context is lost. */
  render(time = performance.now() / 1000, atOnce = false): boolean {
    if (!this.alive) return false;
    const seconds = Math.min(0.1, Math.max(0, time - (this.shownAt ?? time)));
    this.shownAt = time;
    const characters = [...this.characters.values()];
    this.begun ||= characters.length > 0;
    const poses = characters.map((character) => character.advance(seconds, this.blender, atOnce));
    this.parts.residency.advance(poses, this.blender, seconds, atOnce);
    const columns = this.frame();
    const blended = characters.map((character) => character.blend(this.blender, seconds, atOnce));
    if (blended.includes(true)) {
      this.blender.onProcessor = !this.featuresAt(this.level, this.drawing).shaderBlend;
      this.blender.finish();
    }
    const jobs = characters.flatMap((character) => character.takeFigure());
    this.drawing?.pass.draw(jobs);
    if (blended.includes(true) || jobs.length > 0) this.renderer.resetState();
    this.parts.pictures.advance(characters, seconds, atOnce);
    if (this.next !== undefined) {
      this.exchange(this.next, columns, atOnce);
      return this.render(time, atOnce); // what is drawn anew is blended, and stands elsewhere
    }
    this.paint(columns);
    this.crossfade.paint(seconds);
    return true;
  }

  /** Fetches all that a pose needs, then draws it in full, as at `time` in seconds; fetches for `next` meanwhile. */
  async present(pose: Pose, time?: number, next?: Pose): Promise<void> {
    await this.presentScene(alone(pose), time, next && alone(next));
  }

  /** Fetches all that a scene needs, then draws it in full, as at `time` in seconds; fetches for `next` meanwhile. */
  async presentScene(scene: ScenePose, time?: number, next?: ScenePose): Promise<void> {
    this.showScene(scene);
    const hair = [...this.characters.values()].map((character) => character.complete());
    await Promise.all([this.parts.residency.complete(), ...hair, this.prepared]);
    for (const shown of [next ?? scene, scene]) this.showScene(shown); // others may have shown something meanwhile
    this.render(time, true);
  }

  /** Whether all of the present scene shows in full. */
  get settled(): boolean {
    if (!this.alive || this.wantsFigures !== (this.drawing !== undefined)) return false;
    return [...this.characters.values()].every((character) => character.settled(this.blender));
  }

  /** Whether the same scene would be drawn the same again: nothing comes or fades. */
  get still(): boolean {
    const swings = [...this.characters.values()].some((character) => !character.still);
    return this.settled && !swings && !this.crossfade.running && this.next === undefined;
  }

  /** Where heads lie in the picture last drawn, by name. */
  get heads(): Map<string, PictureBox> {
    return headBoxes(this.camera, this.characters);
  }

  /** A character's figure, and the matrix from its metres to those of the stage; undefined while it is not here. */
  figureOf(name: string): { figure: Figure; matrix: THREE.Matrix4 } | undefined {
    return this.characters.get(name)?.placedFigure;
  }

  /** The graphics context that the view draws with. */
  get context(): WebGL2RenderingContext {
    return this.renderer.getContext() as WebGL2RenderingContext;
  }

  /** The blended positions of a character, by default the first, (vertices, 3) metres, read back from the GPU (slow: for tests). */
  readPositions(name = [...this.characters.keys()][0] ?? ""): Float32Array {
    return this.characters.get(name)?.readPositions(this.blender) ?? new Float32Array();
  }

  /** The rows of a character's figure, skin then body, (rows, 3) metres, read back from the GPU (slow: for tests). */
  readFigure(name = [...this.characters.keys()][0] ?? ""): Float32Array {
    return this.characters.get(name)?.readFigure() ?? new Float32Array();
  }

  /** How far a character's skin is pressed, (vertices, 3): level, mixed, upright, read back from the GPU (slow: for tests). */
  readStrains(name = [...this.characters.keys()][0] ?? ""): Float32Array {
    return this.characters.get(name)?.readStrains(this.blender) ?? new Float32Array();
  }

  /** Where points of the first character's skin lie in the picture last drawn: right, down as shares of it, and depth, metres. */
  placesOf(rows: readonly number[]): number[][] {
    const [character] = this.characters.values();
    return character?.placesOf(rows, this.camera, this.blender) ?? [];
  }

  /** Frees the GPU; the canvas keeps its context. */
  dispose(): void {
    this.alive = false;
    this.canvas.removeEventListener("webglcontextlost", this.contextLost);
    this.canvas.removeEventListener("webglcontextrestored", this.contextRestored);
    for (const character of this.characters.values()) character.dispose(this.blender);
    this.passes?.pass.dispose();
    for (const part of [this.parts.pictures, this.blender, this.smoothing, this.renderer]) part.dispose();
  }

  /** What is drawn at a level here, with figures or without. */
  private featuresAt(level: Level, drawing: FigureDrawing | undefined): Features {
    return { ...featuresOf(level, drawsInSoftware()), figure: drawing !== undefined };
  }

  private templateOf(level: Level, drawing: FigureDrawing | undefined): HeadTemplate {
    const { library, anatomy } = this.parts;
    const onFloor = this.options.background === undefined; // a colour is there to be keyed
    const features = this.featuresAt(level, drawing);
    return headTemplate({ meshes: library.meshes, anatomy, features, figures: drawing?.figures, onFloor }, this.common);
  }

  private build(): void {
    const { fans, correctives, regions, foldingFans } = this.parts.anatomy;
    const { vertices } = this.library.manifest;
    this.blender = new Blender(
      this.context,
      vertices,
      fans,
      correctives,
      regions?.rows,
      foldingFans,
      drawsInSoftware(),
    );
    this.passes = undefined;
    this.drawing = this.wantsFigures ? this.createDrawing() : undefined;
    this.common = headUniforms(null, null);
    applyLayers(this.common, this.layers, this.featuresAt(this.wanted, this.drawing));
    this.parts.pictures.rebuild(this.featuresAt(this.wanted, this.drawing));
    this.scene = new THREE.Scene();
    this.backdrop = new Backdrop();
    if (!this.options.transparent) this.scene.add(this.backdrop.mesh);
    this.level = this.wanted;
    this.template = this.templateOf(this.level, this.drawing);
    this.camera.far = this.drawing === undefined ? NEAR : FAR;
    this.next = undefined;
    for (const [name, character] of this.characters) this.add(name, character);
    this.renderer.resetState();
  }

  /** What figures are drawn with on this graphics context; undefined where the cast has none. */
  private createDrawing(): FigureDrawing | undefined {
    const { figures, library } = this;
    const skin = library.meshes.find(({ name }) => name === "skin");
    if (figures === undefined || skin === undefined) return undefined;
    if (this.passes === undefined) {
      this.renderer.resetState(); // else buffers that are bound now become part of what three draws
      this.passes = { figures, pass: new FigurePass(this.context, figures, rowTriangles(skin)) };
      this.renderer.resetState();
    }
    return this.passes;
  }

  /** Takes a character onto the stage, or onto a new graphics context. */
  private add(name: string, character: DrawnCharacter): DrawnCharacter {
    character.build(this.blender, this.common, this.drawing);
    character.exchange(character.prepare(this.template, this.featuresAt(this.level, this.drawing)));
    this.scene.add(character.head);
    this.characters.set(name, character);
    this.renderer.resetState();
    return character;
  }

  /** Keeps the picture of before to fade from, and puts the heads of the new one on the stage. */
  private exchange(next: NextDrawing, columns: [number, number], atOnce: boolean): void {
    const { level, template, heads, drawing, figures } = next;
    this.next = undefined;
    this.paint(columns);
    if (!atOnce) this.crossfade.begin();
    for (const part of this.template.head.children) if (part instanceof THREE.Mesh) part.geometry.dispose();
    [this.level, this.template] = [level, template];
    const stays = (drawing === undefined) === (this.drawing === undefined);
    this.drawing = drawing;
    this.renderer.resetState();
    this.camera.far = drawing === undefined ? NEAR : FAR;
    for (const character of this.characters.values()) {
      const head = heads.get(character) ?? character.prepare(template, this.featuresAt(level, this.drawing));
      if (!stays && drawing === undefined) character.standAlone();
      else if (!stays && drawing !== undefined)
        character.stand(figures.get(character) ?? character.createFigure(drawing.figures), drawing.pass);
      character.exchange(head);
      this.scene.add(head);
    }
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

  /** Points the camera, and puts everybody in their places before it; the part of the picture's columns that heads lie in. */
  private frame(): [number, number] {
    const { camera, characters, shot, centred } = this;
    this.renderer.getSize(this.size);
    const picture = { size: [this.size.x, this.size.y] as const, tile: this.options.tile, shot, centred };
    return frameScene(
      camera,
      characters,
      this.drawing === undefined ? asPortraits(this.framing) : this.framing,
      picture,
    );
  }

  private paint(columns: [number, number]): void {
    const { x: width, y: height } = this.size;
    const { tile, light: own, background } = this.options;
    this.backdrop.place(tile === undefined ? [width, height, 0, 0, width, height] : tileView(tile, width, height));
    const mixed = mixLights(own === undefined ? this.light : { [own]: 1 }); // on air, or of this stage alone
    const light = background === undefined ? mixed : before(mixed, background);
    for (const character of this.characters.values())
      if (character.head.visible) character.dress(this.renderer, light, this.featuresAt(this.level, this.drawing));
    this.backdrop.first = this.featuresAt(this.level, this.drawing).multisample;
    this.backdrop.light(light);
    this.smoothing.render(this.scene, this.camera, this.backdrop.first, columns);
  }
}
