/** A framebuffer with several samples a pixel, and the picture that they come to. */

import { nearestTexture } from "./gl";

const SAMPLES = 4;

/** Draws with smooth edges where the canvas itself has one sample a pixel; as large as the largest picture asked for. */
export class Multisampled {
  readonly framebuffer: WebGLFramebuffer;
  private readonly picture: WebGLFramebuffer;
  private readonly colour: WebGLRenderbuffer;
  private readonly depth: WebGLRenderbuffer;
  private texture: WebGLTexture | undefined;
  private width = 0;
  private height = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {
    [this.framebuffer, this.picture] = [gl.createFramebuffer(), gl.createFramebuffer()];
    [this.colour, this.depth] = [gl.createRenderbuffer(), gl.createRenderbuffer()];
  }

  /** Makes room for a picture of so many pixels. */
  fit(width: number, height: number): void {
    if (width <= this.width && height <= this.height) return;
    [this.width, this.height] = [Math.max(width, this.width), Math.max(height, this.height)];
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    this.store(this.colour, gl.RGBA8, gl.COLOR_ATTACHMENT0);
    this.store(this.depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT);
    if (this.texture !== undefined) gl.deleteTexture(this.texture);
    this.texture = nearestTexture(gl, gl.RGBA8, this.width, this.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.picture);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Copies the lower left part of the picture into a texture of that size. */
  copyTo(texture: WebGLTexture, width: number, height: number): void {
    const { gl } = this;
    this.resolve(width, height);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.picture);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /** Puts the lower left part of the picture on the canvas, which must have one sample a pixel. */
  showAt(left: number, bottom: number, width: number, height: number): void {
    const { gl } = this;
    this.resolve(width, height);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.picture);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    const to = [left, bottom, left + width, bottom + height] as const;
    gl.blitFramebuffer(0, 0, width, height, ...to, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  dispose(): void {
    const { gl } = this;
    for (const framebuffer of [this.framebuffer, this.picture]) gl.deleteFramebuffer(framebuffer);
    for (const buffer of [this.colour, this.depth]) gl.deleteRenderbuffer(buffer);
    if (this.texture !== undefined) gl.deleteTexture(this.texture);
  }

  private resolve(width: number, height: number): void {
    const { gl } = this;
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.picture);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  private store(buffer: WebGLRenderbuffer, format: GLenum, attachment: GLenum): void {
    const { gl } = this;
    const samples = Math.min(SAMPLES, gl.getParameter(gl.MAX_SAMPLES) as number);
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, this.width, this.height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
  }
}
