/** Mixes the looks of the faces on air: colours, traits, eyeballs, extremes. */

import * as THREE from "three";
import type { FaceDocument, Look } from "../../link/messages";
import { PATTERNS } from "../figure/garments";
import { faceWeights } from "../pose/mix_terms";
import type { Pose } from "../pose/pose";
import { addScaled, dressPictures, type ShownPicture } from "../skin/picture_mix";
import { mixHairColour, mixScalp } from "../skin/scalp";
import { mixSkinTraits, SKIN_TRAITS } from "../skin/skin_layers";
import { type EyeUniforms, type HeadUniforms, LOOK_COLOURS } from "./head";

type FaceLook = Record<(typeof LOOK_COLOURS)[number], THREE.Color> & {
  source: string;
  traits: Look;
  eyeRadius: number;
  centres: number[];
  ballRadii: number[];
  extremes: [number, number, number][];
};

/** The looks of faces by source, mixed with the weights of the faces on air. */
export class FaceLooks {
  private readonly looks = new Map<string, FaceLook>();

  /** `faces`: documents by source; more may come. `picture`: what a face, by its source, shows on its skin. */
  constructor(
    private readonly faces: ReadonlyMap<string, FaceDocument>,
    private readonly picture: (face: string) => ShownPicture | undefined = () => undefined,
  ) {}

  /** The mix in linear light, for the shaders. */
  dress(pose: Pose, shared: HeadUniforms, eyes: readonly EyeUniforms[]): void {
    const shares = this.shares(pose);
    for (const part of LOOK_COLOURS) {
      const colour = shared[part].value.setRGB(0, 0, 0);
      for (const [look, share] of shares) addScaled(colour, look[part], share);
    }
    const traits = mixSkinTraits(shares.map(([look, share]) => [look.traits, share]));
    for (const name of SKIN_TRAITS) shared[name].value = traits[name];
    for (const name of PATTERNS)
      shared[name].value = shares.reduce((sum, [{ traits }, share]) => sum + share * traits[name], 0);
    dressScalp(shares, shared);
    dressPictures(
      shares.map(([look, weight]) => ({ weight, look, picture: this.picture(look.source) })),
      shared,
    );
    const radius = shares.reduce((sum, [look, share]) => sum + share * look.eyeRadius, 0);
    for (const eye of eyes) eye.radius.value = radius;
  }

  /** How much of each garment the faces on air wear. */
  garments(pose: Pose): Map<string, number> {
    const worn = new Map<string, number>();
    for (const [{ traits }, share] of this.shares(pose))
      worn.set(traits.garment, (worn.get(traits.garment) ?? 0) + share);
    return worn;
  }

  /** The mix of the eyeballs' centres, left then right, metres: eyeballs turn about it, as `omote.evaluate_parts` has it. */
  writeCentres(pose: Pose, into: Float32Array): void {
    this.write(pose, "centres", into);
  }

  /** The mix of the eyeballs' radii, left then right, metres: what lids must leave. */
  writeRadii(pose: Pose, into: Float32Array): void {
    this.write(pose, "ballRadii", into);
  }

  private write(pose: Pose, part: "centres" | "ballRadii", into: Float32Array): void {
    into.fill(0);
    for (const [look, share] of this.shares(pose))
      look[part].forEach((value, at) => {
        into[at] = (into[at] as number) + share * value;
      });
  }

  /** The mix of the heads' farthest points, metres: of all faces on air, loaded or not, so that a wall's tiles agree. */
  extremes(pose: Pose): [number, number, number][] {
    const mixed = Array.from({ length: 6 }, (): [number, number, number] => [0, 0, 0]);
    for (const [look, share] of this.shares(pose))
      look.extremes.forEach((point, at) => {
        const sum = mixed[at] as [number, number, number];
        for (const axis of [0, 1, 2] as const) sum[axis] += share * point[axis];
      });
    return mixed;
  }

  private shares(pose: Pose): [FaceLook, number][] {
    const weights = faceWeights(pose, (face) => (this.faces.has(face) ? 1 : 0));
    return [...weights].filter(([face]) => this.faces.has(face)).map(([face, weight]) => [this.look(face), weight]);
  }

  private look(face: string): FaceLook {
    const look = this.looks.get(face) ?? readLook(this.faces.get(face) as FaceDocument);
    this.looks.set(face, look);
    return look;
  }
}

/** The scalp under hair that comes or goes, in the colour that the hair has. */
function dressScalp(shares: readonly (readonly [FaceLook, number])[], { scalp, hair }: HeadUniforms): void {
  scalp.value = mixScalp(shares.map(([{ traits }, weight]) => ({ weight, scalp: traits.scalp })));
  mixHairColour(
    shares.map(([{ traits }, weight]) => [traits, weight] as const),
    hair.value,
  );
}

function readLook(face: FaceDocument): FaceLook {
  const colours = LOOK_COLOURS.map((part) => [part, new THREE.Color().setStyle(face.look[part])]); // sRGB in, linear out
  return {
    ...Object.fromEntries(colours),
    source: face.source,
    traits: face.look,
    eyeRadius: face.eye_radius,
    centres: face.centres.flat(),
    ballRadii: [...face.ball_radii],
    extremes: face.extremes,
  } as FaceLook;
}
