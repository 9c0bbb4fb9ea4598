/** The editor's canvas: the face under work large, the others beside it, all wearing the draft; and hands on it. */

import { type Anatomy, loadAnatomy } from "../../face/anatomy/anatomy";
import { fenced } from "../../face/gpu/fence";
import { drawsInSoftware } from "../../face/quality/software_rendering";
import type { Library } from "../../link/assets";
import { now } from "../../link/clock";
import type { Manifest } from "../../link/messages";
import { flat } from "../session/control_net";
import type { DraftStore } from "../session/draft_store";
import { DrawnFaces, type ShownFace } from "./draw/drawn_face";
import { CanvasInput } from "./input/canvas_input";
import { HandleDrag } from "./input/handle_drag";
import type { ViewName } from "./math/camera";
import { surfaceOf } from "./math/hit_test";
import { ExpressionScene } from "./scene/expression_scene";
import { FaceScene } from "./scene/face_scene";
import { FramePacing } from "./scene/frame_pacing";
import { Overlay } from "./scene/overlay";
import { TilePainter } from "./scene/tile_painter";
import { TileSource } from "./scene/tile_source";
import { Viewports } from "./scene/viewports";

/** What draws. */
interface Painters {
  readonly faces: DrawnFaces;
  readonly overlay: Overlay;
  readonly tiles: TilePainter;
}

/** Milliseconds without a change after which all is drawn as well as can be; longer while a hand is about to move on. */
const [STILL, HELD] = [150, 600];

export class EditorCanvas {
  readonly pacing = new FramePacing();
  readonly viewports: Viewports;
  readonly input: CanvasInput;
  expressionScene: ExpressionScene | undefined;
  /** A face under work: in place of the expression scene, with handles in place of needles. */
  faceScene: FaceScene | undefined;
  handles: HandleDrag | undefined;
  private painters: Painters | undefined;
  private readonly tiles = new TileSource(this);
  private anatomy: Anatomy | undefined;
  private stale = true;
  /** Rises with every change of the faces' rows. */
  private version = 0;
  /** When a changed picture was finished last, milliseconds; and whether one is being drawn. */
  private changedAt = 0;
  private moving = false;
  private seen = "";
  private ended = false;
  private readonly gl: WebGL2RenderingContext;
  private readonly leave: (() => void)[] = [];

  /** Draws what the store knows; throws where it cannot. Tells `shows` with each picture whether what is open is on it,
   * and `makes` whether the server still makes the face that the hand has mixed. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly store: DraftStore,
    private readonly shows: (whole: boolean) => void = () => undefined,
    private readonly makes: (still: boolean) => void = () => undefined,
  ) {
    const gl = canvas.getContext("webgl2", {
      alpha: false,
      preserveDrawingBuffer: true, // a hand changes a part of the picture
      antialias: !drawsInSoftware(),
      powerPreference: "high-performance",
    });
    if (gl === null)
      throw new Error("This browser cannot draw the faces (WebGL 2 is off); try another, or switch it on.");
    this.gl = gl;
    this.viewports = new Viewports(canvas);
    this.input = new CanvasInput(this);
    for (const topic of ["cast", "items", "draft", "selection", "options", "live"] as const)
      this.leave.push(store.listen(topic, () => this.hear(topic)));
    this.leave.push(store.listen("notices", () => this.handles?.takeAnswer())); // what was refused goes from sight
    const size = new ResizeObserver(() => this.redraw());
    size.observe(canvas);
    this.leave.push(() => size.disconnect());
    void this.open();
    const tick = (): void => {
      if (this.ended) return;
      this.frame();
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  /** Turns the head: "front", "left", "right", "three-quarter" and the other side's; "whole" ends zoom and shift. */
  view(name: ViewName | "three-quarter" | "whole"): void {
    if (name === "whole") this.viewports.whole();
    else this.viewports.look(name === "three-quarter" ? "three_quarter_left" : name);
    this.redraw();
  }

  /** Draws anew in the next frame. */
  redraw(): void {
    this.stale = true;
  }

  /** The source of the face that wears the expression under work. */
  get workSource(): string {
    return this.store.sourceOf(this.store.work);
  }

  /** Whether it is a face that is under work, not an expression. */
  get editsFace(): boolean {
    return this.store.face !== null;
  }

  /** What is shown large. */
  get work(): Pick<ShownFace, "figure" | "bounds"> | undefined {
    return this.editsFace ? this.faceScene?.all[0] : this.expressionScene?.member(this.workSource);
  }

  /** Whether all that is shown is as the server has it. */
  settled(): boolean {
    return (this.editsFace ? this.faceScene : this.expressionScene)?.settled(now()) === true && !this.store.waiting;
  }

  /** Whether all that is shown is drawn as well as can be. */
  refined(): boolean {
    const { expressionScene, painters, version } = this;
    if (expressionScene === undefined || painters === undefined || this.stale || this.pacing.busy) return false;
    return this.members(expressionScene).every((_, n) => painters.tiles.finished({ n, version }));
  }

  dispose(): void {
    this.ended = true;
    this.pacing.end();
    for (const leave of this.leave) leave();
    this.input.dispose();
    this.viewports.dispose();
    for (const painter of Object.values(this.painters ?? {})) painter.dispose();
  }

  private async open(): Promise<void> {
    const { library } = this.store;
    if (library === null || this.anatomy !== undefined) return;
    if (!library.meshes.some(({ name }) => name === "skin")) throw new Error("The cast has no skin; bake it again.");
    this.anatomy = await loadAnatomy(library);
    this.build(library, this.anatomy, await library.layers());
    for (const topic of ["cast", "items", "draft", "live"] as const) this.hear(topic);
  }

  /** Makes all that draws the cast, and all that takes hold of it; layers: the pictures of its skin. */
  private build(library: Library, anatomy: Anatomy, layers: readonly ImageBitmap[]): void {
    const software = drawsInSoftware();
    const faces = new DrawnFaces(this.gl, library, anatomy, layers, software);
    this.expressionScene = new ExpressionScene(library, anatomy, faces);
    this.faceScene = new FaceScene(faces, anatomy, library.manifest.skin);
    const overlay = new Overlay(this);
    const tiles = new TilePainter(faces.renderer, overlay, (box) => this.viewports.pixels(box), software);
    this.painters = { faces, overlay, tiles };
    const surface = surfaceOf(library.meshes, anatomy);
    this.input.picker.know(anatomy, surface);
    this.handles = new HandleDrag({
      store: this.store,
      faceScene: this.faceScene,
      fans: anatomy.fans,
      skin: surface.skin,
      camera: () => this.input.picker.camera(),
      redraw: () => this.redraw(),
    });
  }

  private hear(topic: "cast" | "items" | "draft" | "selection" | "options" | "live"): void {
    if (topic !== "live" || this.editsFace) this.redraw();
    const { store, expressionScene } = this;
    if (expressionScene === undefined) {
      if (topic === "cast") void this.open();
      return;
    }
    if (topic === "items" || topic === "draft") expressionScene.setFollowers(store.followers);
    if (topic === "cast" || topic === "draft") this.cast(expressionScene);
    if (topic === "draft" || topic === "live") this.dress(expressionScene, topic === "draft");
    this.painters?.overlay.hear();
  }

  private cast(expressionScene: ExpressionScene): void {
    const { store } = this;
    if (store.manifest === null) return;
    const sources = [this.workSource, ...store.neighbours.map((name) => store.sourceOf(name))];
    const shown = expressionScene.show(store.manifest, this.editsFace ? [] : sources);
    Promise.all([shown, this.sit(store.manifest)]).then(
      () => this.redraw(),
      (error: unknown) => {
        store.say(error instanceof Error ? error.message : String(error));
        this.shows(true); // what cannot be had is waited for no more
      },
    );
  }

  /** Lets a face under work sit, or an old revision of it that is looked at. */
  private async sit(manifest: Manifest): Promise<void> {
    const { draft, face, look } = this.store;
    if (face === null || draft?.recipe.kind !== "face") {
      this.faceScene?.leave();
      return;
    }
    this.handles?.takeAnswer();
    const hand = look === null ? face : { ...face, points: [], moves: [] };
    const recipe = look === null ? draft.recipe : hand;
    await this.faceScene?.show(manifest, { item: draft.item, content: look ?? draft.content, recipe }, hand);
  }

  private dress(expressionScene: ExpressionScene, anew: boolean): void {
    const { store } = this;
    const { shownRecipe: recipe, layerPreview, net, manifest } = store;
    const worn =
      recipe === null || layerPreview.solo.size > 0
        ? undefined
        : {
            vectors: flat(recipe.vectors),
            pulls: new Map(recipe.pulls.map(({ muscle, contraction }) => [muscle, contraction])),
          };
    const moves = worn === undefined ? undefined : { vectors: store.live, pulls: store.livePulls };
    expressionScene.follow({ net, moves, muscles: store.muscles });
    if (anew && manifest !== null) expressionScene.dress(manifest, { source: store.shown, moves: worn, net });
  }

  private frame(): void {
    const time = now();
    this.pacing.look(performance.now());
    this.makes(this.faceScene?.makes === true);
    if (this.pacing.busy) return;
    if (this.moving) this.changedAt = performance.now(); // slow machines are not still while they draw
    this.moving = false;
    const { expressionScene, painters } = this;
    if (expressionScene === undefined || painters === undefined) return;
    const resized = this.viewports.fit();
    const editsFace = this.editsFace && this.faceScene !== undefined;
    const changed = editsFace ? this.sat(time) : expressionScene.advance(time);
    if (changed !== "nothing") this.version += 1;
    if (resized || this.unlike() || changed === "whole") this.redraw();
    if (this.stale || changed === "part") this.draw(expressionScene, painters, changed !== "nothing");
    else if (!this.refine(expressionScene, painters.tiles)) this.pacing.idle();
  }

  private sat(time: number): "nothing" | "whole" {
    return this.faceScene?.advance(time, this.handles?.ahead ?? false) === true ? "whole" : "nothing";
  }

  /** Whether eyes or muscles' lines look otherwise than in the last picture. */
  private unlike(): boolean {
    const { store } = this;
    const now = JSON.stringify([store.liveEyes, store.options.muscles ? [...store.livePulls] : []]);
    const unlike = now !== this.seen;
    this.seen = now;
    return unlike;
  }

  private draw(expressionScene: ExpressionScene, painters: Painters, moved: boolean): void {
    const whole = this.stale;
    this.stale = false;
    this.moving = true;
    if (this.store.manifest === null) return;
    const members = this.members(expressionScene);
    const boxes = this.viewports.share(members.length - 1);
    if (whole) painters.tiles.clear(this.viewports.ground);
    if (whole) for (const member of members) member?.drawn?.repaint.forget();
    painters.tiles.drawParts(
      members.flatMap((member, n) => this.tiles.tile(expressionScene, member, n, whole, this.version)),
    );
    painters.overlay.place(
      members.map((member) => member?.document.label ?? "..."),
      boxes,
    );
    this.pacing.frame(moved, fenced(this.gl));
    this.pacing.whenDone(() => {
      if (!this.ended) this.frame();
    });
    if (this.faceScene?.awaits === true) this.shows(false);
    else if (members.every((member) => member?.drawn !== undefined)) this.shows(true);
  }

  /** Once all is still, draws one tile as well as can be; whether there was anything to draw. */
  private refine(scene: ExpressionScene, tilePainter: Painters["tiles"]): boolean {
    const { tiles, version, store } = this;
    const still = performance.now() - this.changedAt;
    if (store.manifest === null || still < (this.input.pointers.size > 0 ? HELD : STILL)) return false;
    const members = this.members(scene);
    const n = members.findIndex((member, n) => member?.drawn !== undefined && !tilePainter.finished({ n, version }));
    if (n < 0) return false;
    for (const tile of tiles.tile(scene, members[n], n, true, version)) tilePainter.drawWhole(tile);
    this.pacing.frame(false, fenced(this.gl));
    return true;
  }

  /** Who is drawn, the work first; undefined: not here yet. */
  private members(expressionScene: ExpressionScene): readonly (ShownFace | undefined)[] {
    const { store } = this;
    if (this.editsFace)
      return this.faceScene === undefined || this.faceScene.all.length === 0 ? [undefined] : this.faceScene.all;
    return [store.work, ...store.neighbours].map((name) => expressionScene.member(store.sourceOf(name)));
  }
}
