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

/** Reads a file as browsers show it; `decode` gives one that the browser does not decode (HEIC) as one that it does. An
 * Error with a sentence where it is no picture. */
export async function readPhotograph(file: File, decode: (file: File) => Promise<Blob>): Promise<PlainPicture> {
  const whole = (await bitmapOf(file)) ?? (await bitmapOf(await decode(file)));
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

const bitmapOf = (picture: Blob): Promise<ImageBitmap | null> => createImageBitmap(picture).catch(() => null);

/** Width and height, the longer no longer than `LARGEST_SIDE`. */
export function smaller(width: number, height: number): [number, number] {
  const share = Math.min(1, LARGEST_SIDE / Math.max(width, height));
  return [Math.max(1, Math.round(share * width)), Math.max(1, Math.round(share * height))];
}
