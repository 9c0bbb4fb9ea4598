/** The editor's canvas: the face under work large, the others beside it, all wearing the draft; and hands on it. */

import { type Anatomy, study } from "../../face/anatomy/anatomy";
import { fenced } from "../../face/gpu/fence";
import { drawsInSoftware } from "../../face/quality/software_rendering";
import { now } from "../../link/clock";
import type { Manifest } from "../../link/messages";
import type { Workbench } from "../session/draft_store";
import { flat } from "../session/net";
import { Grounds } from "./draw/backgrounds";
import { Painter } from "./draw/face_painter";
import { HEAD, NeedleMarks } from "./draw/needle_renderer";
import { type Changed, Repaint, type Tile } from "./draw/repaint";
import { Complexions } from "./draw/skin_texture";
import { HandleHands } from "./input/handle_drag";
import { Hands } from "./input/input";
import type { Camera, ViewName } from "./math/camera";
import { coarseMeshes } from "./math/coarse_mesh";
import { surfaceOf } from "./math/hit_test";
import { ballFrames, ballsOf, gazeOf, shows } from "./model/gaze";
import type { Member } from "./model/shown_face";
import { boxOf } from "./model/spread";
import { exposeProbe } from "./probe";
import { Company } from "./scene/expression_scene";
import { Sitters } from "./scene/face_scene";
import { Pace } from "./scene/frame_pacing";
import { Overlay } from "./scene/overlay";
import { Aspect } from "./scene/viewports";

export class EditorCanvas {
  readonly pace = new Pace();
  readonly aspect: Aspect;
  readonly hands: Hands;
  company: Company | undefined;
  /** A face under work: in place of the company, with handles in place of needles. */
  sitters: Sitters | undefined;
  handles: HandleHands | undefined;
  private painter: Painter | undefined;
  private overlay: Overlay | undefined;
  private marks: NeedleMarks | undefined;
  private frames: ReturnType<typeof ballFrames> = [];
  private anatomy: Anatomy | undefined;
  private stale = true;
  private repaint: Repaint | undefined;
  private grounds: Grounds | undefined;
  private seen = "";
  private ended = false;
  private readonly gl: WebGL2RenderingContext;
  private readonly leave: (() => void)[] = [];

  /** Draws on a canvas of the page what a workbench knows; an Error with a sentence where nothing can be drawn. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly bench: Workbench,
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
    this.aspect = new Aspect(canvas);
    this.hands = new Hands(this);
    for (const topic of ["cast", "items", "draft", "selection", "options", "live"] as const)
      this.leave.push(bench.listen(topic, () => this.hear(topic)));
    this.leave.push(bench.listen("notices", () => this.handles?.settle())); // what was refused goes from sight
    const size = new ResizeObserver(() => this.redraw());
    size.observe(canvas);
    this.leave.push(() => size.disconnect());
    exposeProbe(this);
    void this.open();
    const tick = (): void => {
      if (this.ended) return;
      this.frame();
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  /** Turns the head: "front", "left", "right", "three-quarter" and the other side's. */
  view(name: ViewName | "three-quarter"): void {
    this.aspect.look(name === "three-quarter" ? "three_quarter_left" : name);
    this.redraw();
  }

  /** Draws anew in the next frame. */
  redraw(): void {
    this.stale = true;
  }

  /** The source of the face that wears the expression under work. */
  get workSource(): string {
    return this.bench.sourceOf(this.bench.work);
  }

  /** Whether it is a face that is under work, not an expression. */
  get sitting(): boolean {
    return this.bench.face !== null;
  }

  /** What is shown large. */
  get work(): Pick<Member, "figure" | "bounds"> | undefined {
    return this.sitting ? this.sitters?.all[0] : this.company?.member(this.workSource);
  }

  /** Whether all that is shown is as the server has it. */
  settled(): boolean {
    return (this.sitting ? this.sitters : this.company)?.settled(now()) === true && !this.bench.waiting;
  }

  dispose(): void {
    this.ended = true;
    for (const leave of this.leave) leave();
    this.hands.dispose();
    this.aspect.dispose();
    this.overlay?.dispose();
    this.company?.dispose();
  }

  private async open(): Promise<void> {
    const { bench, gl } = this;
    const { library } = bench;
    if (library === null || this.anatomy !== undefined) return;
    const skin = library.meshes.find(({ name }) => name === "skin");
    if (skin === undefined) throw new Error("The cast has no skin; bake it again.");
    this.anatomy = await study(library);
    const complexions = await Complexions.open(gl, library, this.anatomy, skin);
    const side = drawsInSoftware() ? 512 : 1024;
    this.company = new Company(gl, library, this.anatomy, complexions, side);
    this.sitters = new Sitters(this.company.crowd, complexions, this.anatomy, library.manifest.skin, side);
    this.painter = new Painter(gl, this.company.crowd, library.meshes, coarseMeshes(library.meshes, this.anatomy));
    this.repaint = new Repaint(this.painter);
    this.grounds = new Grounds(gl);
    this.marks = new NeedleMarks(gl, this.painter);
    this.overlay = new Overlay(this, this.painter, this.marks);
    this.frames = ballFrames(this.anatomy);
    const surface = surfaceOf(library.meshes, this.anatomy);
    this.hands.picker.know(this.anatomy, surface);
    this.handles = new HandleHands({
      bench,
      sitters: this.sitters,
      fans: this.anatomy.fans,
      skin: surface.skin,
      camera: () => this.hands.picker.camera(),
      redraw: () => this.redraw(),
    });
    for (const topic of ["cast", "items", "draft", "live"] as const) this.hear(topic);
  }

  private hear(topic: "cast" | "items" | "draft" | "selection" | "options" | "live"): void {
    if (topic !== "live" || this.sitting) this.redraw();
    const { bench, company } = this;
    if (company === undefined) {
      if (topic === "cast") void this.open();
      return;
    }
    if (topic === "items" || topic === "draft") company.setFollowers(bench.followers);
    if (topic === "cast" || topic === "draft") this.cast(company);
    if (topic === "draft" || topic === "live") this.dress(company, topic === "draft");
    this.overlay?.hear();
  }

  private cast(company: Company): void {
    const { bench } = this;
    if (bench.manifest === null) return;
    const sources = [this.workSource, ...bench.neighbours.map((name) => bench.sourceOf(name))];
    const shown = company.show(bench.manifest, this.sitting ? [] : sources);
    Promise.all([shown, this.sit(bench.manifest)]).then(
      () => this.redraw(),
      (error: unknown) => bench.say(error instanceof Error ? error.message : String(error)),
    );
  }

  /** Lets a face under work sit, or an old revision of it that is looked at. */
  private async sit(manifest: Manifest): Promise<void> {
    const { draft, face, look } = this.bench;
    if (face === null || draft === null) {
      this.sitters?.leave();
      return;
    }
    this.handles?.settle();
    const recipe = look === null ? face : { ...face, points: [], moves: [] };
    await this.sitters?.show(manifest, draft.item, look ?? draft.content, recipe);
  }

  private dress(company: Company, anew: boolean): void {
    const { bench } = this;
    const { recipe, look, net, manifest } = bench;
    const worn =
      recipe === null || look !== null ? undefined : { vectors: flat(recipe.vectors), pulls: pullsOf(recipe) };
    const moves = worn === undefined ? undefined : { vectors: bench.live, pulls: bench.livePulls };
    company.follow({ net, moves, muscles: bench.muscles });
    if (anew && manifest !== null) company.dress(manifest, { source: bench.shown, moves: worn, net });
  }

  private frame(): void {
    const time = now();
    this.pace.look(performance.now());
    if (this.pace.busy) return;
    const { company, painter } = this;
    if (company === undefined || painter === undefined) return;
    const resized = this.aspect.fit();
    const sitting = this.sitting && this.sitters !== undefined;
    const changed = sitting ? this.sat(time) : company.advance(time);
    if (resized || this.unlike() || changed === "whole") this.redraw();
    if (this.stale || changed === "part") this.draw(company, painter, changed !== "nothing");
    else this.pace.idle();
  }

  private sat(time: number): "nothing" | "whole" {
    return this.sitters?.advance(time, this.handles?.ahead ?? false) === true ? "whole" : "nothing";
  }

  /** Whether eyes or muscles' lines look otherwise than in the last picture. */
  private unlike(): boolean {
    const { bench } = this;
    const pulls = bench.options.muscles ? [...bench.livePulls] : [];
    const now = JSON.stringify([bench.liveEyes, pulls]);
    const unlike = now !== this.seen;
    this.seen = now;
    return unlike;
  }

  private draw(company: Company, painter: Painter, moved: boolean): void {
    const whole = this.stale;
    this.stale = false;
    const { bench, aspect, gl } = this;
    if (bench.manifest === null) return;
    const members = this.members(company);
    const boxes = aspect.share(members.length - 1);
    if (whole) painter.clear(aspect.ground);
    if (whole) this.repaint?.forget();
    const tiles = members.flatMap((member, n) => this.tile(company, member, n, whole));
    this.grounds?.lay(tiles.map(({ part, ground }) => ({ part: aspect.pixels(part), colour: ground })));
    const gaze = gazeOf(bench.look === null ? bench.recipe : null, bench.liveEyes, bench.manifest);
    for (const { n, member, camera, part, only } of tiles) {
      painter.frame(aspect.pixels(camera.box), aspect.pixels(part));
      const balls = ballsOf(this.frames, member.figure.base, gaze.angles).filter((ball) => shows(ball, camera, part));
      const { block, complexion, document } = member;
      painter.face({ block, complexion, look: document.look, balls, pupil: gaze.pupil }, camera, only?.());
      if (n === 0) this.overlay?.draw(block, camera);
    }
    this.overlay?.place(
      members.map((member) => member?.document.label ?? "..."),
      boxes,
    );
    this.pace.frame(moved, fenced(gl));
    this.watch();
  }

  /** What of face `n` is drawn now; nothing when nothing of it is. */
  private tile(company: Company, member: Member | undefined, n: number, whole: boolean): Tile[] {
    if (member === undefined || member.block < 0) return [];
    const { aspect } = this;
    const camera = aspect.camera(n, member.bounds);
    const changed = this.sitting ? undefined : this.changed(company, member, n, camera);
    const { part, only }: Changed = whole || changed === undefined ? { part: camera.box } : changed;
    if (part.width === 0 || part.height === 0) return [];
    const ground = this.hands.over === n && n > 0 ? aspect.hovered : aspect.tile(n);
    return [{ n, member, camera, part, only, ground }];
  }

  /** Draws on as soon as the machine is done, not only when the display asks next: what it is late by is not doubled. */
  private watch(): void {
    setTimeout(() => {
      if (this.ended) return;
      this.pace.look(performance.now());
      if (this.pace.busy) this.watch();
      else this.frame();
    });
  }

  /** What of a face's tile the hand has changed; around the work's needles stand too. */
  private changed(company: Company, member: Member, n: number, camera: Camera): Changed | undefined {
    const { repaint } = this;
    if (repaint === undefined) return undefined;
    const spread = company.spread(member);
    const needle = n > 0 ? 0 : this.hands.picker.needleLength + 2 * HEAD * camera.metresPerPixel(camera.middle);
    const part = repaint.next(n, boxOf(camera, spread, needle), camera.box);
    return { part, only: () => repaint.triangles(n, part, camera, member.figure.base, spread.reach) };
  }

  /** Who is drawn, the work first; undefined: not here yet. */
  private members(company: Company): readonly (Member | undefined)[] {
    const { bench } = this;
    if (this.sitting)
      return this.sitters === undefined || this.sitters.all.length === 0 ? [undefined] : this.sitters.all;
    return [bench.work, ...bench.neighbours].map((name) => company.member(bench.sourceOf(name)));
  }
}

const pullsOf = (recipe: NonNullable<Workbench["recipe"]>): Map<string, number> =>
  new Map(recipe.pulls.map(({ muscle, contraction }) => [muscle, contraction]));
