/** The portraits that come with the pages: every face at rest, and every expression on the generic face. */

import sheet from "./portraits.jpg?no-inline";
import names from "./portraits.json";
import { THUMBNAIL_SIZE, type ThumbnailSubject } from "./thumbnails";

/** Portraits side by side in the sheet, and pixels between two. `tools/pictures/portraits.py` draws it and writes the names. */
const COLUMNS = 13;
const GAP = 1;

/** Whose portrait each is, and the picture. */
export async function loadPortraits(): Promise<[ThumbnailSubject, CanvasImageSource][]> {
  const { width, height } = THUMBNAIL_SIZE;
  // Decoded once, and not on this thread: each cut out of an image element would decode the whole sheet again.
  const whole = await createImageBitmap(await (await fetch(sheet)).blob());
  return Promise.all(
    names.map(async ([face = "", expression = ""], at) => {
      const [x, y] = [(at % COLUMNS) * (width + GAP), Math.floor(at / COLUMNS) * (height + GAP)];
      return [{ face, expression }, await createImageBitmap(whole, x, y, width, height)] as const;
    }),
  ) as Promise<[ThumbnailSubject, CanvasImageSource][]>;
}
