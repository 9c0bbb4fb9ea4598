/** Measures whether the GPU finishes frames with time to spare. */

/** Milliseconds after which a picture must be done: half of what a display of 60 Hz gives. */
const SOON = 1000 / 120;
/** Milliseconds by which the look may itself come too late. */
const SLACK = 4;
/** Frames between two looks; each costs a timer and a fence. */
const EVERY = 5;

/** Looks now and then whether the machine has finished a picture long before the display wants it. */
export class FrameHeadroom {
  private frame = 0;
  private early: boolean | undefined;

  constructor(private readonly gl: WebGL2RenderingContext) {}

  /** The picture of this frame has been handed to the machine. */
  drawn(): void {
    this.frame += 1;
    if (this.frame % EVERY !== 0) return;
    const { gl } = this;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (fence === null) return;
    gl.flush();
    const due = performance.now() + SOON;
    setTimeout(() => {
      if (performance.now() < due + SLACK) this.early = gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
      gl.deleteSync(fence);
    }, SOON);
  }

  /** What the last look has seen, once: done early or not; undefined: there was none, or it came too late itself. */
  take(): boolean | undefined {
    const { early } = this;
    this.early = undefined;
    return early;
  }
}
