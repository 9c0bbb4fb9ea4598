import type { Library } from "../link/assets";
import { now } from "../link/clock";
import type { State, Welcome } from "../link/messages";
import { Link } from "../link/socket";
import { FaceView } from "./face_view";
import type { Quality, StageParameters } from "./parameters";
import type { Pose } from "./pose";
import { Timeline } from "./timeline";

/** Seconds behind the server: one and a half state intervals, so that there is a state on either side of a frame. */
const DELAY = 0.025;
/** On a wall every tile draws the state of one common instant; the slowest of them must have it by then. */
const WALL_DELAY = 0.06;
const PIXEL_RATIO: Record<Quality, number> = { low: 1, mid: 1.5, high: 2 };

/** Frames drawn in the last second. */
class Rate {
  private times: number[] = [];

  tick(time: number): void {
    this.times.push(time);
    while ((this.times[0] as number) < time - 1) this.times.shift();
  }

  at(time: number): number {
    return this.times.filter((drawn) => drawn >= time - 1).length;
  }
}

/** A page that shows the face: states in, frames out; holds the face when the server is gone. */
export class Stage {
  private readonly timeline = new Timeline();
  private readonly rate = new Rate();
  private readonly link: Link;
  private readonly delay: number;
  private held: Pose | undefined;
  private state: State | undefined;
  private reported = 0;
  private drawn = 0;
  private received = 0;
  private reloading = false;

  private constructor(
    private readonly canvas: HTMLCanvasElement,
    private view: FaceView,
    private readonly parameters: StageParameters,
  ) {
    this.delay = parameters.tile === undefined ? DELAY : WALL_DELAY;
    this.link = new Link("stage", { state: (state) => this.receive(state), welcome: (welcome) => void this.greet(welcome) });
    this.fit();
    addEventListener("resize", () => this.fit());
  }

  static async open(canvas: HTMLCanvasElement, library: Library, parameters: StageParameters): Promise<Stage> {
    return new Stage(canvas, await loadView(canvas, library, parameters), parameters);
  }

  /** Draws the frame of our time `time`. */
  frame(time: number): void {
    const pose = this.held ?? this.timeline.at((this.link.clock.at(time) ?? 0) - this.delay, time);
    if (pose !== undefined) this.view.show(pose, coming(this.state));
    if (this.view.render(time, this.held !== undefined)) {
      this.drawn += 1;
      this.rate.tick(time);
    }
    this.report(time);
  }

  private receive(state: State): void {
    this.received += 1;
    this.state = state;
    this.timeline.push(state, now());
  }

  /** Another cast than ours: takes it over without a new page. */
  private async greet(welcome: Welcome): Promise<void> {
    if (welcome.digest === this.view.library.manifest.digest || this.reloading) return;
    this.reloading = true;
    try {
      const { Library } = await import("../link/assets");
      const view = await loadView(this.canvas, await Library.open(), this.parameters);
      this.view.dispose();
      this.view = view;
      this.fit();
    } finally {
      this.reloading = false;
    }
  }

  private fit(): void {
    this.view.resize(innerWidth, innerHeight);
  }

  private report(time: number): void {
    if (time - this.reported < 1) return;
    this.reported = time;
    this.link.send({ type: "drawing", fps: this.rate.at(time) });
  }
}

const loadView = (canvas: HTMLCanvasElement, library: Library, parameters: StageParameters): Promise<FaceView> =>
  FaceView.load(canvas, library, {
    transparent: parameters.transparent,
    tile: parameters.tile,
    pixelRatio: PIXEL_RATIO[parameters.quality],
    antialias: parameters.quality !== "low",
  });

/** What the running calls will need. */
function coming(state: State | undefined): { faces: string[]; expressions: string[] } {
  const names = (call: State["face_call"] | undefined) => (call ? [call.target] : []);
  return { faces: names(state?.face_call), expressions: names(state?.expression_call) };
}
