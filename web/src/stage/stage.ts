/** A stage: states in, frames out. */

import { FaceView } from "../face/face_view";
import { Breath } from "../face/pose/breath";
import { PlayoutClock } from "../face/pose/playout_clock";
import type { Pose } from "../face/pose/pose";
import { mixScenes, type ScenePose, sceneIn, sceneKey } from "../face/pose/scene_pose";
import { Timeline } from "../face/pose/timeline";
import { FrameHeadroom } from "../face/quality/frame_headroom";
import { QualityController } from "../face/quality/quality_controller";
import type { Level } from "../face/quality/quality_levels";
import { Library } from "../link/assets";
import { now } from "../link/clock";
import type { CallState, State } from "../link/messages";
import { type LinkHandlers, ShowLink } from "../link/show_link";
import type { WakeLock } from "../ui/wake_lock";
import { Curtain } from "./curtain";
import { FrameRate } from "./frame_rate";
import { findCharacter } from "./named_character";
import type { StageParameters } from "./parameters";
import { RedrawPolicy } from "./redraw_policy";
import { StageSound } from "./stage_sound";

/** Pixels of the strip that says that a stage of the preview is not on air: below the picture, never over it. */
export const PREVIEW_FOOT = 30;
/** Seconds behind the server at most, of a stage alone. */
const LONGEST_DELAY = 0.06;
/** On a wall every tile draws the state of one common instant; the slowest of them must have it by then. */
const WALL_DELAY = 0.06;
/** Seconds by which a frame is drawn early at most: a frame of a slow display. */
const LONGEST_INTERVAL = 1 / 30;
/** Seconds by which sounds wait for a picture that takes long to draw, at most. */
const LATEST_PICTURE = 0.25;
/** Seconds of silence after which the faces breathe by themselves. */
const ALONE = 1.0;

/** Seconds without a change on air after which the stage is calm. */
const CALM = 0.5;

/** Seconds without a graphics context after which the stage helps itself: a new canvas, then the page anew. */
const CONTEXT_SECONDS = 2;
/** Seconds between two reloads for want of a context at least. */
const RELOAD_SECONDS = 15;
const RELOADED_KEY = "omote-stage-reloaded";

/** What a stage counts; for the heads-up display and for tests. */
export interface Counters {
  received: number;
  ignored: number;
  /** Frames shown; a picture that stands still need not be drawn again for that. */
  drawn: number;
  fps: number;
  level: Level;
  epoch: number;
  number: number;
  connected: boolean;
}

/** A page that shows the scene, or one character of it: states in, frames out; holds the faces when the server is gone. */
export class Stage {
  private readonly timeline = new Timeline<ScenePose>(mixScenes);
  private readonly breath = new Breath();
  private readonly playout = new PlayoutClock(LONGEST_DELAY);
  private readonly redraw = new RedrawPolicy();
  private readonly rate = new FrameRate();
  private readonly link: ShowLink;
  /** What characters speak with. */
  readonly sound: StageSound;
  private state: State | undefined;
  private last = now();
  private reported = 0;
  private interval = 0;
  private early = false;
  private drawn = 0;
  private received = 0;
  private reloading = false;
  /** Since when there is no graphics context, in seconds; undefined while there is one. */
  private darkSince: number | undefined;
  private renewed = false;
  private readonly qualityController: QualityController | undefined;
  private frameHeadroom: FrameHeadroom;
  private air = "";
  private movedAt = 0;
  /** The scene last drawn. */
  shown: ScenePose | undefined;
  private held: ScenePose | undefined;
  private readonly curtain = new Curtain(dim);
  /** Pixels at the foot of the page that are not the picture's. */
  private readonly foot: number;
  /** No frame is drawn; somebody else draws with the view. */
  resting = false;

  private constructor(
    private canvas: HTMLCanvasElement,
    public view: FaceView,
    private readonly parameters: StageParameters,
    private readonly wakeLock: WakeLock,
  ) {
    if (parameters.quality === "auto") this.qualityController = new QualityController(view.level);
    this.frameHeadroom = new FrameHeadroom(view.context);
    this.foot = parameters.bus === "preview" ? PREVIEW_FOOT : 0;
    this.sound = new StageSound(parameters.sound, () => this.heartbeat());
    const handlers: LinkHandlers = {
      state: (state) => this.receive(state),
      plays_sound: ({ on }) => this.sound.choose(on),
      welcome: (welcome) => {
        this.sound.relinked(now());
        this.heartbeat();
        if (welcome.digest !== this.view.library.manifest.digest) void this.recast();
      },
      cast: () => void this.recast(),
    };
    this.link = new ShowLink("stage", handlers, () => "", "", "", parameters.bus);
    this.fit();
    addEventListener("resize", () => this.fit());
  }

  /** A stage on a canvas of this page; an Error with a sentence when nothing can be drawn. */
  static async open(
    canvas: HTMLCanvasElement,
    library: Library,
    parameters: StageParameters,
    wakeLock: WakeLock,
  ): Promise<Stage> {
    return new Stage(canvas, await loadView(canvas, library, parameters), parameters, wakeLock);
  }

  /** Shows the frame of our time `time`, seconds, unless it was drawn early. */
  frame(time: number): void {
    if (!this.early) this.show(time);
    this.early = false;
  }

  private show(time: number): void {
    if (this.resting) return;
    this.interval = time - this.last;
    if (this.held === undefined) this.choose(this.interval, time);
    this.shown = this.held ?? this.live(time);
    this.last = time;
    if (this.shown !== undefined) this.view.showScene(this.shown, (name) => coming(this.state, name));
    if (this.present(time) && this.shown !== undefined) {
      this.drawn += 1;
      this.rate.tick(time);
    }
    if (this.held === undefined && this.shown !== undefined)
      this.curtain.frame(this.shown.black, this.interval, this.curtain.open || this.view.settled);
    this.recover(time);
    this.report(time);
  }

  /** Draws a scene instead of the server's from now on, in full; the server's again without one. For tests and pictures. */
  hold(scene: ScenePose | undefined): void {
    this.held = scene;
    if (scene !== undefined) this.curtain.raise(scene.black);
  }

  /** Whether all of what is shown is there, and seen. */
  get settled(): boolean {
    return this.view.settled && this.curtain.open;
  }

  /**
   * A browser may never give back a graphics context that it took (a driver's reset, a sleeping screen): after two
   * seconds the stage asks for one on a new canvas, and after two more by loading the page anew.
   */
  private recover(time: number): void {
    if (this.view.alive) {
      this.darkSince = undefined;
      this.renewed = false;
      return;
    }
    this.darkSince ??= time;
    const dark = time - this.darkSince;
    if (this.reloading || dark < CONTEXT_SECONDS) return;
    if (!this.renewed) {
      this.renewed = true;
      void this.renewCanvas();
    } else if (dark > 2 * CONTEXT_SECONDS) reloadNow();
  }

  private async renewCanvas(): Promise<void> {
    const canvas = this.canvas.cloneNode() as HTMLCanvasElement;
    const former = this.canvas;
    try {
      await this.replaceView(canvas, this.view.library);
      former.replaceWith(canvas);
      this.canvas = canvas;
    } catch (error) {
      console.error("no new graphics context:", error); // the page is loaded anew next
    }
  }

  private async replaceView(canvas: HTMLCanvasElement, library: Library): Promise<void> {
    this.reloading = true;
    try {
      const view = await loadView(canvas, library, this.parameters, this.view.level);
      this.view.dispose();
      this.view = view;
      this.frameHeadroom = new FrameHeadroom(view.context);
      this.fit();
    } finally {
      this.reloading = false;
    }
  }

  counters(time = now()): Counters {
    return {
      received: this.received,
      ignored: this.link.newest.ignored,
      drawn: this.drawn,
      fps: this.rate.at(time),
      level: this.view.level,
      epoch: this.state?.epoch ?? -1,
      number: this.state?.number ?? -1,
      connected: this.link.connected,
    };
  }

  /** The pose last drawn, of the first character. */
  get pose(): Pose | undefined {
    return Object.values(this.shown?.characters ?? {})[0];
  }

  /** The character that this stage was asked to show and that the show has not, or not yet. */
  get missing(): string | undefined {
    const { character } = this.parameters;
    if (character === undefined || this.state === undefined) return undefined;
    return findCharacter(character, this.state.characters) === undefined ? character : undefined;
  }

  /** The names of the characters of the show. */
  get characters(): string[] {
    return Object.keys(this.state?.characters ?? {});
  }

  /** Draws what is shown, unless its picture is there already; false while nothing can be drawn. */
  private present(time: number): boolean {
    const settled = this.view.still && (this.qualityController?.proved ?? true);
    if (!this.redraw.needed(this.shown === undefined ? "" : sceneKey(this.shown), settled)) {
      this.view.shownAt = time;
      return true;
    }
    if (!this.view.render(time)) return false;
    if (this.shown !== undefined) this.frameHeadroom.drawn();
    return true;
  }

  /**
   * Draws the next frame as soon as the first state has come that changes a picture that stands still: where drawing is
   * slow, what the display shows next is then ready in time.
   */
  private showEarly(time: number): void {
    if (this.early || !this.redraw.still || this.held !== undefined || this.parameters.tile !== undefined) return;
    this.show(Math.max(time, this.last + Math.min(this.interval, LONGEST_INTERVAL)));
    this.view.context.flush(); // or the browser hands it over with its next frame
    this.early = true;
  }

  /** As good as the machine can: judged by how long the last frame took, `interval` seconds. */
  private choose(interval: number, time: number): void {
    const calm = !this.calling && time - this.movedAt > CALM;
    const level = this.qualityController?.after({ interval, early: this.frameHeadroom.take(), calm });
    if (level !== undefined) void this.view.change(level);
  }

  /** Whether any character is on its way to another face, expression, pose or body, or the picture to another framing. */
  private get calling(): boolean {
    const { state } = this;
    if (state === undefined) return false;
    const calls = Object.values(state.characters).flatMap((character) => [
      character.face_call,
      character.expression_call,
      ...Object.values(character.region_calls),
      character.figure?.pose_call ?? null,
      character.figure?.body_call ?? null,
    ]);
    return [state.framing_call, ...calls].some((call) => call !== null);
  }

  private live(time: number): ScenePose | undefined {
    const server = this.link.clock.at(time) ?? 0;
    const alone = this.parameters.tile === undefined;
    const due = alone ? this.playout.at(server, time - this.last) : server - WALL_DELAY;
    this.sound.play(server - (alone ? this.playout.delay : WALL_DELAY) - Math.min(this.rate.interval, LATEST_PICTURE));
    const scene = this.timeline.at(due, time);
    return scene && this.breath.on(scene, this.timeline.silence(time) > ALONE, time - this.last);
  }

  private receive(state: State): void {
    this.received += 1;
    this.state = state;
    const time = now();
    const { character } = this.parameters;
    const only = character && (findCharacter(character, state.characters) ?? character);
    const scene = sceneIn(state, only);
    const air = `${scene.black} ${sceneKey(scene)}`;
    const moved = air !== this.air;
    this.playout.arrived(state.time, !moved);
    if (moved) this.movedAt = time;
    this.air = air;
    this.timeline.push(scene, time);
    this.sound.follow(state, only, time);
    if (moved) this.showEarly(time);
  }

  /** Another cast than ours: takes it in; on another built-in cast with a new view. */
  private async recast(): Promise<void> {
    if ((await this.view.library.renew()) || this.reloading) return;
    this.reloading = true; // while the other cast comes, too
    try {
      await this.replaceView(this.canvas, await Library.open(this.parameters.hair));
    } finally {
      this.reloading = false;
    }
  }

  private fit(): void {
    this.view.resize(innerWidth, innerHeight - this.foot);
    this.redraw.forget();
    this.qualityController?.forget();
  }

  private report(time: number): void {
    if (time - this.reported < 1) return;
    this.reported = time;
    this.heartbeat();
  }

  /** Tells the show what is drawn, from where, whether sounds can be played and whether the screen stays on. */
  private heartbeat(): void {
    const { camera, level } = this.view;
    const stands = camera.position.z > 0 ? camera.position.toArray() : null; // at the origin until a head is framed
    this.link.send({
      type: "drawing",
      fps: this.rate.at(now()),
      level,
      name: this.parameters.name,
      camera: stands,
      sound: this.sound.state,
      sound_here: this.parameters.sound === "here",
      dark: this.darkSince === undefined ? 0 : Math.max(0, now() - this.darkSince),
      awake: this.wakeLock.state,
    });
  }
}

/** Shows a share of the picture, 0..1, with all that lies on it. */
function dim(share: number): void {
  document.body.style.opacity = String(share);
}

/** Loads the page anew, unless that was done a moment ago. */
function reloadNow(): void {
  const before = Number(sessionStorage.getItem(RELOADED_KEY) ?? 0);
  if (Date.now() - before < 1000 * RELOAD_SECONDS) return;
  sessionStorage.setItem(RELOADED_KEY, String(Date.now()));
  location.reload();
}

const loadView = (
  canvas: HTMLCanvasElement,
  library: Library,
  parameters: StageParameters,
  level?: Level,
): Promise<FaceView> =>
  FaceView.load(canvas, library, {
    transparent: parameters.transparent,
    background: parameters.background,
    light: parameters.light,
    tile: parameters.tile,
    shotSize: parameters.shotSize,
    level: parameters.quality === "auto" ? level : parameters.quality,
  });

/** What the running calls of a character will need. */
function coming(state: State | undefined, name: string): { faces: string[]; expressions: string[] } {
  const names = (call: CallState | null | undefined) => (call ? [call.target] : []);
  const character = state?.characters[name];
  const regional = Object.values(character?.region_calls ?? {}).flatMap(names);
  return { faces: names(character?.face_call), expressions: [...names(character?.expression_call), ...regional] };
}
