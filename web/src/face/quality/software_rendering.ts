/** What the browser draws with: a graphics processor, the processor alone, or nothing. */

let answer: string | null | undefined;

/** Whether this browser can draw a face at all. */
export const hasWebGL2 = (): boolean => rendererName() !== null;

/** Whether this browser draws without a graphics processor; then everything must be light. */
export const drawsInSoftware = (): boolean => /llvmpipe|swiftshader|software|basic render/i.test(rendererName() ?? "");

/** What the driver calls itself; empty when it does not say, null without WebGL2. Asked once. */
function rendererName(): string | null {
  if (answer !== undefined) return answer;
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  answer = gl && names ? String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)) : gl && "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext(); // a browser has few contexts to give
  return answer;
}
