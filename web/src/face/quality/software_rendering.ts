/** Whether the browser draws without a graphics processor. */

let answer: boolean | undefined;

/** Whether this browser draws without a graphics processor; then everything must be light. */
export function drawsInSoftware(): boolean {
  answer ??= /llvmpipe|swiftshader|software|basic render/i.test(rendererName());
  return answer;
}

/** What the driver calls itself; empty when it does not say. */
function rendererName(): string {
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const name = gl && names ? String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext(); // a browser has few contexts to give
  return name;
}
