/** Photographs from the desk: made smaller, and saved anew without anything but their pixels. */

/** The longer side that is sent, pixels: finer than the texture of a face. */
const LARGEST_SIDE = 2048;
const QUALITY = 0.95;
export const MOST_PHOTOGRAPHS = 8;

/** A picture without place, time and camera. */
export interface PlainPicture {
  readonly picture: Blob;
  readonly bitmap: ImageBitmap;
}

/** Reads a file as browsers show it; an Error with a sentence where it is no picture that they know. */
export async function readPhotograph(file: File): Promise<PlainPicture> {
  const whole = await createImageBitmap(file).catch(() => null);
  if (whole === null) throw new Error(`${file.name} is no picture that this browser reads; save it as JPEG or PNG.`);
  const [width, height] = smaller(whole.width, whole.height);
  const canvas = new OffscreenCanvas(width, height);
  const brush = canvas.getContext("2d") as OffscreenCanvasRenderingContext2D;
  brush.imageSmoothingQuality = "high";
  brush.drawImage(whole, 0, 0, width, height);
  whole.close();
  const picture = await canvas.convertToBlob({ type: "image/jpeg", quality: QUALITY });
  return { picture, bitmap: canvas.transferToImageBitmap() };
}

/** Width and height, the longer no longer than `LARGEST_SIDE`. */
export function smaller(width: number, height: number): [number, number] {
  const share = Math.min(1, LARGEST_SIDE / Math.max(width, height));
  return [Math.max(1, Math.round(share * width)), Math.max(1, Math.round(share * height))];
}
