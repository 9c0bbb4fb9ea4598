/** The hair of the faces that are shown: styles fetched once, each posed on the faces that wear it. */

import type { Library } from "../../../link/assets";
import type { HairStrands } from "../../../link/strands";
import type { FaceHair, HairPainter } from "../draw/hair_painter";
import type { ShownFace } from "../model/shown_face";

/** Heads of hair that are kept, the latest used: those of all faces on the canvas, and of a few that were there. */
const MOST = 16;

export class HairCache {
  private readonly styles = new Map<string, HairStrands | "awaited" | "refused">();
  private readonly worn = new Map<string, FaceHair>();

  /** `arrived` is told when a style has come. */
  constructor(
    private readonly library: Pick<Library, "hair">,
    private readonly painter: Pick<HairPainter, "make" | "drop">,
    private readonly arrived: () => void,
  ) {}

  /** The hair of a face: undefined where it wears none, or none can be had; "awaited" until the style is here. */
  of({ source, document: { look }, rest }: Pick<ShownFace, "source" | "document" | "rest">) {
    const style = look.hair_style === "" ? "refused" : this.style(look.hair_style);
    if (style === "refused") return undefined;
    if (style === "awaited") return "awaited";
    const key = JSON.stringify([source, look.hair_style, look.hair]);
    const hair = this.worn.get(key) ?? this.painter.make(look.hair_style, style, rest, look.hair);
    this.worn.delete(key);
    this.worn.set(key, hair); // the latest used is last
    this.forget();
    return hair;
  }

  private style(name: string): HairStrands | "awaited" | "refused" {
    const known = this.styles.get(name);
    if (known !== undefined) return known;
    this.styles.set(name, "awaited");
    this.library
      .hair(name)
      .catch((error: unknown) => {
        console.warn(String(error));
        return "refused" as const;
      })
      .then((style) => {
        this.styles.set(name, style);
        this.arrived();
      });
    return "awaited";
  }

  private forget(): void {
    for (const [key, hair] of this.worn) {
      if (this.worn.size <= MOST) return;
      this.worn.delete(key);
      this.painter.drop(hair);
    }
  }
}
