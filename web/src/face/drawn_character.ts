/** One character as it is drawn: its blend on the GPU, its head, hair, light and shadow, and where it stands. */

import * as THREE from "three";
import type { Library } from "../link/assets";
import { SHOT_SIZES } from "../link/constants";
import type { ShotSize } from "../link/framings";
import type { Anatomy } from "./anatomy/anatomy";
import { AssetResidency, namesOf } from "./blend/asset_residency";
import type { Blender, BlendTarget } from "./blend/blender";
import type { Eyeballs } from "./blend/sum_pass";
import { Figure, type FigureCall } from "./figure/figure";
import {
  FIGURE_BOUNDS,
  figurePoints,
  figureShot,
  type Ground,
  groundOf,
  meanGround,
  UNMOVED,
} from "./figure/figure_framing";
import type { FigureJob, FigurePass } from "./figure/figure_pass";
import { CONTACTS } from "./figure/floor";
import { GarmentMix } from "./figure/garments";
import type { SharedFigures } from "./figure/shared_figures";
import { type Point, type Shot, shotOfHead, turnedAbout } from "./framing";
import { Hair } from "./hair/hair";
import { createHairStock, type HairStock } from "./hair/hair_assignment";
import { FEET } from "./head/collar";
import { eyeTraitsOf, writeEyeTraits } from "./head/eye_traits";
import { FaceLooks } from "./head/face_looks";
import { type HeadUniforms, PIVOT } from "./head/head";
import { type CharacterUniforms, characterUniforms, copyHead, type HeadTemplate } from "./head/head_template";
import { writeLight } from "./light/light_uniforms";
import { type Light, lightTurned } from "./light/lights";
import { SHADOW_CENTRE, Shadow } from "./light/shadow";
import { dropOf, placed, placeMatrix } from "./placement";
import { complexionOf } from "./pose/complexion";
import { headOf } from "./pose/head_answer";
import { expressionWeights } from "./pose/mix_terms";
import { NO_IDLE, type Pose, STANDING, writeTurn } from "./pose/pose";
import type { CharacterPose } from "./pose/scene_pose";
import { type Arrival, SourceCrossfade } from "./pose/source_crossfade";
import type { Features } from "./quality/quality_levels";
import type { Clearance, PlacedHead, PlacedShot, ShotSizes } from "./scene_framing";
import { writeBlood } from "./skin/blood";
import { SkinPaint } from "./skin/skin_paint";
import { SkinPictures } from "./skin/skin_pictures";

/** Seconds in which a character rises that came on the stage before all of it was here. */
const RISE = 0.6;

/** What a head with its hair and the black figure below it lies in, metres. */
const BOUNDS = new THREE.Box3(new THREE.Vector3(-0.32, FEET, -0.32), new THREE.Vector3(0.32, 0.32, 0.32));

/** What all characters share. */
export interface SharedParts {
  readonly library: Library;
  readonly anatomy: Anatomy;
  readonly looks: FaceLooks;
  readonly hairStock: HairStock;
  readonly residency: AssetResidency;
  readonly pictures: SkinPictures;
}

/** What figures are drawn with. */
export interface FigureDrawing {
  readonly figures: SharedFigures;
  readonly pass: FigurePass;
}

/** What the characters of a view share; `upload`: a texture to the GPU. */
export function sharedParts(library: Library, anatomy: Anatomy, upload: (texture: THREE.Texture) => void): SharedParts {
  const pictures = new SkinPictures(library, upload);
  return {
    library,
    anatomy,
    pictures,
    looks: new FaceLooks(library.faces, (face) => pictures.of(face)),
    hairStock: createHairStock(library, anatomy.positions, (row) => anatomy.traits[4 * row + 2] ?? 0),
    residency: new AssetResidency(library, anatomy.regions?.allowances),
  };
}

/** Names that will be needed soon. */
export interface Coming {
  readonly faces: readonly string[];
  readonly expressions: readonly string[];
}

/** A character on the stage. */
export class DrawnCharacter {
  private readonly eyeballs: Eyeballs;
  private readonly allowed: Float32Array;
  private readonly hair: Hair;
  private readonly sourceCrossfade: SourceCrossfade;
  private readonly bounds = new THREE.Box3();
  private figure: Figure | undefined;
  private clothes: GarmentMix | undefined;
  private ground = UNMOVED;
  private readonly jobs: FigureJob[] = [];
  private uniforms!: CharacterUniforms;
  private target!: BlendTarget;
  private shadow!: Shadow;
  private blended = "";
  private pose: Pose; // by source, as it is drawn
  private whole = false;
  private points: readonly Point[] = []; // those of its head first
  private headPoints = 0;
  private turn: readonly [number, number, number] = [0, 0, 0];
  /** Its farthest points as they were drawn last; none where no part of it was in the picture. */
  seen: readonly Point[] = [];
  /** Its skin without light, for levels that light vertices. */
  paint!: SkinPaint;
  /** Its head at the level that is drawn. */
  head = new THREE.Group();

  /** How far it stands in its place as far as it is present, 0..1. */
  private risen = 1;

  /** `first`: the picture begins with it, so that it stands there at once when all of it has come. */
  constructor(
    private readonly parts: SharedParts,
    private called: CharacterPose,
    private readonly first: boolean,
  ) {
    const { anatomy, library } = parts;
    this.eyeballs = {
      rows: anatomy.eyeRows,
      centres: new Float32Array(6),
      radii: new Float32Array(2),
      turns: new Float32Array(18),
    };
    this.allowed = new Float32Array(anatomy.correctives?.size ?? 0);
    this.hair = new Hair(library, anatomy, parts.hairStock);
    this.sourceCrossfade = new SourceCrossfade(library);
    this.pose = called;
  }

  /** Makes its part of the GPU's memory, on a new graphics context too; `common`: the textures that hold for everybody. */
  build(blender: Blender, common: HeadUniforms, drawing?: FigureDrawing): void {
    this.target = blender.createTarget();
    this.uniforms = characterUniforms(this.target, common);
    if (drawing === undefined) this.standAlone();
    else this.stand(this.figure ?? this.createFigure(drawing.figures), drawing.pass);
    this.shadow = new Shadow(this.uniforms.shared);
    this.paint = new SkinPaint(this.uniforms.shared);
    this.blended = "";
  }

  /** Waits for the shaders of a head that is not drawn yet: those of all other characters are the same. */
  async compile(
    head: THREE.Group,
    features: Features,
    compile: (part: THREE.Object3D) => Promise<void>,
  ): Promise<void> {
    await compile(head);
    if (!features.pixelLight) await compile(this.paint.mesh);
  }

  /** A head at another level, with hair; `exchange` puts it on the stage. */
  prepare(template: HeadTemplate, features: Features): THREE.Group {
    const head = copyHead(template, this.uniforms);
    this.hair.on(head, this.uniforms.shared, features);
    return head;
  }

  /** A figure of it that is not drawn yet, and fetches what it needs; `stand` puts the head on it. */
  createFigure(figures: SharedFigures): Figure {
    const figure = new Figure(this.parts.library, figures);
    this.wantFigure(figure, namesOf(this.called).faces, this.faces);
    return figure;
  }

  /** Puts the head on this figure from now on. */
  stand(figure: Figure, pass: FigurePass): void {
    const { shared } = this.uniforms;
    this.figure = figure;
    const { positions, normals } = figure.build(pass);
    this.clothes?.dispose();
    this.clothes = new GarmentMix(pass.space);
    shared.figurePositions.value = new THREE.ExternalTexture(positions);
    shared.figureNormals.value = new THREE.ExternalTexture(normals);
  }

  /** Draws the head alone from now on, where it was modelled. */
  standAlone(): void {
    const { shared } = this.uniforms;
    this.figure?.dispose();
    this.figure = undefined;
    this.clothes?.dispose();
    this.clothes = undefined;
    shared.pivot.value.copy(PIVOT);
    shared.headPlace.value.copy(PIVOT);
    shared.shadowCentre.value.copy(SHADOW_CENTRE);
  }

  /** Draws this head from now on, where the other one was. */
  exchange(head: THREE.Group): void {
    head.visible = this.head.visible;
    head.matrix.copy(this.head.matrix);
    head.matrixWorldNeedsUpdate = true;
    this.forget(this.head);
    this.head = head;
    this.blended = ""; // strains are found at some levels only
  }

  /** Forgets a head that is not drawn, or no more. */
  forget(head: THREE.Group): void {
    head.removeFromParent();
    this.hair.drop(head);
    for (const part of head.children) ((part as THREE.Mesh).material as THREE.Material).dispose();
  }

  /** What the next frame draws of it, and what will be needed soon. */
  show(pose: CharacterPose, coming: Coming): void {
    this.called = pose;
    const names = namesOf(pose);
    const faces = this.sourceCrossfade.wanted("faces", [...names.faces, ...coming.faces]);
    const expressions = this.sourceCrossfade.wanted("expressions", [...names.expressions, ...coming.expressions]);
    this.parts.residency.want(faces, expressions);
    this.parts.pictures.want(faces);
    this.hair.want(faces);
    if (this.figure !== undefined) this.wantFigure(this.figure, [...names.faces, ...coming.faces], faces);
  }

  /** Has a figure fetch what these faces wear, by their names and by their sources. */
  private wantFigure(figure: Figure, faces: readonly string[], sources: readonly string[]): void {
    const all = (list: readonly string[]) => Object.fromEntries(list.map((name) => [name, 1]));
    figure.want({ mix: this.called.figure ?? STANDING, faces: all(faces), sources: all(sources) });
  }

  /** Its pose by source, `seconds` after the last frame. */
  advance(seconds: number, blender: Blender, atOnce: boolean): Pose {
    const { residency, pictures } = this.parts;
    const arrival: Arrival = (faces, worn) => (pictures.here(faces) ? residency.arrival(faces, worn, blender) : "away");
    this.pose = this.sourceCrossfade.pose(this.called, seconds, arrival, atOnce);
    if (atOnce || this.called.presence === 0) this.risen = 1;
    else if (this.whole) this.risen = Math.min(1, this.risen + seconds / RISE);
    else this.risen = this.first ? 1 : 0;
    return this.pose;
  }

  /** Where it stands, for the camera; all of its faces count, loaded or not, so that a wall's tiles agree. */
  place(shot: Shot, centred: boolean, sizes: ShotSizes): PlacedHead {
    const { uniforms, called, parts, head } = this;
    this.turnHead();
    this.ground = meanGround([...sizes].map(([size, weight]) => [this.groundIn(size), weight]));
    uniforms.shared.floorSeen.value = sizes.get("full") ?? 0;
    this.stands(0, 0);
    const straight = parts.looks.extremes(this.pose);
    const { shot: near, points } = shotOfHead(shot, { ...uniforms.shared, straight, centred });
    const place = { ...called.place, size: this.size };
    const shots = new Map<ShotSize, PlacedShot>();
    this.points = [];
    this.headPoints = points.length;
    for (const size of SHOT_SIZES) {
      if (!sizes.has(size)) continue;
      const { shot: framed, body } = this.frameBody(size, near, straight, centred);
      const own = placed(framed, [...points, ...body], place, head.matrix);
      shots.set(size, own);
      this.points = own.points; // the farthest shot holds most of them
    }
    return { shots, presence: called.presence };
  }

  /** The shot of its figure, where it has one, and the points of it that a picture has to hold. */
  private frameBody(
    size: ShotSize,
    near: Shot,
    straight: readonly Point[],
    centred: boolean,
  ): { shot: Shot; body: Point[] } {
    const { figure } = this;
    if (figure === undefined) return { shot: near, body: [] };
    const [x, y, z] = near.centre;
    const [aside, up, ahead] = this.groundIn("head").offset;
    const still: Shot = centred ? near : { ...near, centre: [x - aside, y - up, z - ahead] }; // as if the body stood
    return { shot: figureShot(figure, size, straight) ?? still, body: figurePoints(figure, size) };
  }

  /** How large it is drawn. */
  private get size(): number {
    return this.called.place.size * this.ground.size;
  }

  /** How it stands in a shot of a size. */
  private groundIn(size: ShotSize): Ground {
    const { figure, called, uniforms } = this;
    return figure === undefined ? UNMOVED : groundOf(figure, size, called.place.size, uniforms.shared);
  }

  /** Puts it in its place, `aside` to the picture's right and so much lower, metres. */
  private stands(aside: number, drop: number): void {
    const { head, called, ground } = this;
    const place = { ...called.place, x: called.place.x + aside, size: called.place.size * ground.size };
    placeMatrix(place, drop, head.matrix).multiply(new THREE.Matrix4().makeTranslation(...ground.offset));
  }

  /**
   * Puts it where the camera sees it, or beside and below the picture where that is of others; returns its points there,
   * none where no part of it is in the picture.
   */
  appear(camera: THREE.PerspectiveCamera, frustum: THREE.Frustum, { aside, sunk }: Clearance): readonly Point[] {
    const { head, called, bounds } = this;
    const presence = called.presence * (1 - sunk) * this.risen * this.risen * (3 - 2 * this.risen);
    const half = Math.tan((camera.fov * Math.PI) / 360);
    const drop = dropOf(presence, this.points, this.size, camera.position.toArray(), half);
    this.stands(aside, drop);
    head.matrixWorldNeedsUpdate = true;
    this.uniforms.shared.viewPoint.value.copy(camera.position).applyMatrix4(head.matrix.clone().invert());
    bounds.copy(this.figure === undefined ? BOUNDS : FIGURE_BOUNDS).applyMatrix4(head.matrix);
    head.visible = presence > 0 && frustum.intersectsBox(bounds);
    const seen = head.visible ? this.points.map(([x, y, z]): Point => [x + aside, y - drop, z]) : [];
    this.seen = seen.slice(0, this.headPoints);
    return seen;
  }

  /** Has what is seen of it blended on the GPU where it has changed, and dresses its hair; true where `finish` has to draw. */
  blend(blender: Blender, seconds: number, atOnce: boolean): boolean {
    const { residency } = this.parts;
    if (this.whole && !this.head.visible) return false;
    const touched = this.blendFace(blender);
    const job = this.figure?.job(this.target.positions, touched);
    if (job !== undefined) this.jobs.push(job);
    this.hair.follow(this.turn, seconds, atOnce || !this.whole);
    this.hair.dress(residency.faces(this.pose, blender), seconds, atOnce || !this.whole);
    const here = this.hair.here && this.parts.pictures.here(this.faces) && this.figure?.here !== false;
    this.whole ||= this.blended !== "" && (atOnce || here); // at once: what is wanted for later may be on its way
    this.head.visible &&= this.whole;
    return touched;
  }

  /** What of its figure is to be drawn now that its head is blended; each is given once. */
  takeFigure(): FigureJob[] {
    return this.jobs.splice(0);
  }

  /** Dresses it in its faces' looks and in the light. */
  dress(renderer: THREE.WebGLRenderer, light: Light, { pixelLight, shadow }: Features): void {
    const { pose, parts, uniforms } = this;
    const local = lightTurned(light, this.called.place.turn);
    parts.looks.dress(pose, uniforms.shared, uniforms.eyes);
    this.clothes?.write(parts.looks.garments(pose), uniforms.shared);
    writeEyeTraits(eyeTraitsOf(pose, parts.library), uniforms.shared);
    const { lacquer, fur } = uniforms.shared;
    const shown = complexionOf(pose, parts.library.expressions);
    writeBlood(shown, { lacquer: lacquer.value, fur: fur.value }, uniforms.shared);
    uniforms.shared.pressed.value = this.target.pressed ? 1 : 0;
    uniforms.shared.folds.value = this.target.pressed ? (pose.folds ?? 1) : 0;
    writeLight(local, uniforms.shared);
    this.turnEyes();
    if (!pixelLight) this.paint.draw(renderer);
    this.shadow.draw(renderer, local, this.head, shadow);
  }

  /** Whether all of its pose shows in full. */
  settled(blender: Blender): boolean {
    const { residency } = this.parts;
    if (!this.sourceCrossfade.settled(this.called) || !residency.shownInFull(this.pose, blender)) return false;
    if (!this.parts.pictures.settled(this.faces)) return false;
    if (this.figure?.here === false) return false;
    return this.whole && this.risen === 1 && (!this.head.visible || this.hair.settled);
  }

  /** Whether nothing of it swings. */
  get still(): boolean {
    return !this.head.visible || this.hair.still;
  }

  /** The faces that are drawn of it, by source. */
  get faces(): string[] {
    return Object.keys(this.pose.faces);
  }

  /** The faces that an audience sees of it, by source. */
  get facesSeen(): string[] {
    return this.whole && this.head.visible ? this.faces : [];
  }

  /** Waits for all of its hair, and the pictures on its skin. */
  async complete(): Promise<void> {
    await Promise.all([this.hair.complete(), this.parts.pictures.complete(), this.figure?.complete()]);
  }

  /** Its blended positions, read back from the GPU. */
  readPositions(blender: Blender): Float32Array {
    return blender.readPositions(this.target);
  }

  /** The rows of its figure, read back from the GPU. */
  readFigure(): Float32Array {
    return this.figure?.readPositions() ?? new Float32Array();
  }

  /** How far its skin is pressed, read back from the GPU. */
  readStrains(blender: Blender): Float32Array {
    return blender.readStrains(this.target);
  }

  /** Where vertices of its skin lie in the picture last drawn: right, down as shares of it, and depth, metres. */
  placesOf(rows: readonly number[], camera: THREE.PerspectiveCamera, blender: Blender): number[][] {
    const positions = this.figure === undefined ? this.readPositions(blender) : this.readFigure();
    const { pivot, headTurn, headPlace } = this.uniforms.shared;
    const points = rows.map((row): Point => {
      const [x = 0, y = 0, z = 0] = positions.subarray(3 * row, 3 * row + 3);
      return [x, y, z];
    });
    const turned =
      this.figure === undefined ? turnedAbout(points, pivot.value, headTurn.value, headPlace.value) : points;
    return turned.map((point) => {
      const standing = new THREE.Vector3(...point).applyMatrix4(this.head.matrix);
      const depth = -standing.clone().applyMatrix4(camera.matrixWorldInverse).z;
      const { x, y } = standing.project(camera);
      return [(1 + x) / 2, (1 - y) / 2, depth];
    });
  }

  /** Its figure, and the matrix from its metres to those of the stage; undefined where heads are drawn alone. */
  get placedFigure(): { figure: Figure; matrix: THREE.Matrix4 } | undefined {
    return this.figure && { figure: this.figure, matrix: this.head.matrix };
  }

  /** Frees its part of the GPU's memory. */
  dispose(blender: Blender): void {
    this.forget(this.head);
    this.hair.dispose();
    this.shadow.dispose();
    this.paint.dispose();
    this.figure?.dispose();
    this.clothes?.dispose();
    blender.drop(this.target);
  }

  private blendFace(blender: Blender): boolean {
    const { pose, eyeballs, parts } = this;
    const mix = parts.residency.mix(pose, blender, this.allowed);
    if (mix.entries.length === 0) return false; // nothing loaded yet: what shows stays
    const key = JSON.stringify([mix.entries, mix.regional, pose.eyes]);
    if (key === this.blended) return false;
    this.blended = key;
    parts.looks.writeCentres(pose, eyeballs.centres);
    parts.looks.writeRadii(pose, eyeballs.radii);
    writeTurn(pose.eyes[0], pose.eyes[1], eyeballs.turns, 0);
    writeTurn(pose.eyes[2], pose.eyes[3], eyeballs.turns, 9);
    blender.blend(mix, eyeballs, this.target);
    return true;
  }

  /** Head: yaw, then pitch, then roll; + is the character's left, up, tilt to its left. */
  private turnHead(): void {
    const { shared } = this.uniforms;
    this.turn = headOf(this.pose, this.parts.library);
    const [yaw, pitch, roll] = this.turn;
    const turn = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(-pitch, yaw, -roll, "YXZ"));
    shared.headTurn.value.setFromMatrix4(turn);
    if (this.figure !== undefined) this.carryHead(this.figure);
  }

  /** The head as its body carries it: neck and spine share its turn. */
  private carryHead(figure: Figure): void {
    const { shared } = this.uniforms;
    const { called, pose } = this;
    const call: FigureCall = {
      mix: pose.figure ?? STANDING,
      idle: called.idle ?? NO_IDLE,
      head: this.turn,
      faces: called.faces,
      sources: pose.faces,
      worn: expressionWeights(pose),
    };
    figure.move(call);
    const { turn, pivot, place } = figure.head;
    shared.headTurn.value.set(...turn);
    shared.pivot.value.set(...pivot);
    shared.headPlace.value.set(...place);
    const { x, y, z } = new THREE.Euler().setFromRotationMatrix(
      new THREE.Matrix4().setFromMatrix3(shared.headTurn.value),
      "YXZ",
    );
    this.turn = [y, -x, -z];
    const centre = shared.shadowCentre.value.copy(SHADOW_CENTRE).sub(shared.pivot.value);
    centre.applyMatrix3(shared.headTurn.value).add(shared.headPlace.value);
    shared.soles.value = figure.soles;
    for (const [place, name] of CONTACTS.entries())
      shared.contacts.value[place]?.set(...(figure.joint(name) ?? [0, 0, 0]));
  }

  /** The eyeballs as they are blended, turned with the head. */
  private turnEyes(): void {
    const { shared, eyes } = this.uniforms;
    const [pivot, place] = [shared.pivot.value, shared.headPlace.value];
    eyes.forEach((eye, side) => {
      eye.centre.value
        .fromArray(this.eyeballs.centres, 3 * side)
        .sub(pivot)
        .applyMatrix3(shared.headTurn.value)
        .add(place);
      eye.eyeTurn.value.fromArray(this.eyeballs.turns, 9 * side).premultiply(shared.headTurn.value);
    });
  }
}
