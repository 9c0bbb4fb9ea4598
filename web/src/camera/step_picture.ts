/** The faces of the guided minute, drawn: what to do, as in a mirror. */

import { type SVGTemplateResult, svg } from "lit";

/** A drawn face. eyes: how open; look: where to, right and down; brows: up; mouth: half width, opening, curve up. */
interface DrawnFace {
  eyes: number;
  look: readonly [number, number];
  brows: number;
  frown: number;
  mouth: readonly [number, number, number];
  puff: number;
}

const REST: DrawnFace = { eyes: 1, look: [0, 0], brows: 0, frown: 0, mouth: [15, 0, 0], puff: 0 };
const FACES: Record<string, Partial<DrawnFace>> = {
  neutral: {},
  shut: { eyes: 0 },
  wide: { eyes: 1.6, brows: 3 },
  smile: { mouth: [22, 3, 9], eyes: 0.8 },
  pucker: { mouth: [7, 4, 0] },
  aa: { mouth: [14, 15, 0] },
  ee: { mouth: [21, 5, 2] },
  oo: { mouth: [8, 9, 0] },
  browsUp: { brows: 8, eyes: 1.2 },
  browsDown: { brows: -3, frown: 5, eyes: 0.85 },
  left: { look: [-4.5, 0] },
  right: { look: [4.5, 0] },
  up: { look: [0, -4], eyes: 1.2 },
  down: { look: [0, 4], eyes: 0.75 },
  puff: { puff: 10, mouth: [9, 0, -1] },
};
const ARROWS: Record<string, string> = {
  left: "M14 62H4m4-4-4 4 4 4",
  right: "M106 62h10m-4-4 4 4-4 4",
  up: "M60 8v-7m-4 4 4-4 4 4",
  down: "M60 130v8m-4-4 4 4 4-4",
};

/** The face of a step, for a view box of 120 by 140. */
export function drawStep(step: string): SVGTemplateResult {
  const face = { ...REST, ...FACES[step] };
  return svg`<g fill="none" stroke="currentColor" stroke-width="2.4" stroke-linecap="round" stroke-linejoin="round">
    <path d="${outline(face.puff)}" />
    ${[-1, 1].map((way) => drawEye(60 + way * 16, way, face))}
    <path d="M60 64c-2 8 -5 12 -3 14s5 1 7 0" />
    <path d="${mouth(face)}" />
    ${ARROWS[step] ? svg`<path d=${ARROWS[step]} />` : null}
  </g>`;
}

function outline(puff: number): string {
  const cheek = 31 + puff;
  return `M60 12C82 12 94 28 94 54C94 ${66} ${60 + cheek} 74 ${60 + cheek} 88C${58 + cheek} 108 76 126 60 126C44 126 ${62 - cheek} 108 ${60 - cheek} 88C${60 - cheek} 74 26 66 26 54C26 28 38 12 60 12Z`;
}

function drawEye(x: number, way: number, face: DrawnFace): SVGTemplateResult {
  const [open, y] = [5.5 * face.eyes, 56];
  const [inner, outer] = [x - way * 8, x + way * 8];
  const brow = y - 13 - face.brows;
  const eye = svg`<path d="M${x - 9} ${y}Q${x} ${y - 1.9 * open} ${x + 9} ${y}Q${x} ${y + 1.9 * open + (open === 0 ? 4 : 0)} ${x - 9} ${y}" />`;
  const iris = svg`<circle cx=${x + face.look[0]} cy=${y + face.look[1]} r="3.2" fill="currentColor" />`;
  return svg`<path d="M${inner} ${brow + face.frown}Q${x} ${brow - 4 + face.frown / 3} ${outer} ${brow + 1}" />
    ${eye}${open > 0 ? iris : null}`;
}

function mouth({ mouth: [half, open, curve] }: DrawnFace): string {
  const [y, corner] = [96, 96 - curve / 2];
  return `M${60 - half} ${corner}Q60 ${y - open + curve} ${60 + half} ${corner}Q60 ${y + open * 1.6 + curve} ${60 - half} ${corner}`;
}
