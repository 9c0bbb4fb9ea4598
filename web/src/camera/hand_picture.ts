/** A hand in profile, drawn: how it stands before the camera, and what it does. */

import { type SVGTemplateResult, svg } from "lit";
import type { HandAxes } from "../hands/hand_guide";

/** Where the wrist and the knuckles are; the forearm comes from the left. */
const [WRIST, KNUCKLES]: [Point, Point] = [
  [78, 74],
  [126, 66],
];
/** Lengths of the joints of a finger and of the thumb. */
const FINGER = [24, 17, 13];
const THUMB = [26, 20];
/** Of the view box; where the ring of a turn stands in it. */
const [WIDTH, TURN] = [220, 178];
/** Degrees: how far the wrist turns at most as drawn. */
const NOD = 24;

type Point = [number, number];

/** The hand, for a view box of 220 by 140. Fingers: the index behind, the little finger in front. leftward: they point left. */
export function drawHand({ opening, index, little, yaw, pitch, roll }: HandAxes, leftward = false): SVGTemplateResult {
  const turned = `rotate(${-NOD * pitch} ${WRIST[0]} ${WRIST[1]}) translate(${WRIST[0]} 0) scale(${1 - 0.16 * Math.abs(yaw)} 1) translate(${-WRIST[0]} 0)`;
  const tilt = 6 * roll;
  return svg`<g fill="none" stroke="currentColor" stroke-linecap="round" stroke-linejoin="round">
    <g transform=${leftward ? `translate(${WIDTH} 0) scale(-1 1)` : ""}>
    <path d="M4 92C34 84 56 76 78 74" stroke-width="26" opacity=".35" />
    <g transform=${turned}>
      <path d=${fingerPath([KNUCKLES[0], KNUCKLES[1] - 4 - tilt], opening, index)} stroke-width="9" opacity=".45" />
      <path d="M80 74Q104 60 124 67" stroke-width="24" opacity=".35" />
      <path d=${thumbPath(opening)} stroke-width="11" opacity=".8" />
      <path d=${fingerPath([KNUCKLES[0] - 2, KNUCKLES[1] + 5 + tilt], opening, little)} stroke-width="9" />
    </g></g>
    ${yaw === 0 ? null : drawTurn(yaw, leftward)}
  </g>`;
}

/** Whether the hand turns to the camera or away: a ring that grows, or shrinks. */
const drawTurn = (yaw: number, leftward: boolean): SVGTemplateResult =>
  svg`<circle cx=${leftward ? WIDTH - TURN : TURN} cy="104" r=${9 - 7 * yaw} stroke-width="2.4" />
    <text x=${leftward ? WIDTH - TURN : TURN} y="134" text-anchor="middle" font-size="11" fill="currentColor" stroke="none">${yaw > 0 ? "away" : "to the camera"}</text>`;

/** A finger from its knuckle: bent at the knuckle by as much as the mouth is shut, then by its curl. */
function fingerPath(knuckle: Point, opening: number, curl: number): string {
  const bend = 18 + 9 * (1 - opening) + (curl > 0 ? 38 * curl : 16 * curl);
  return chain(knuckle, 14 + 46 * (1 - opening) + 20 * Math.min(0, curl), [bend, bend], FINGER);
}

const thumbPath = (opening: number): string => chain([92, 84], 34 + 34 * opening, [-16 - 8 * (1 - opening)], THUMB);

/** Joints one after the other. angle: degrees down from the right; bends: what each further joint adds. */
function chain(start: Point, angle: number, bends: number[], lengths: number[]): string {
  let [x, y] = start;
  let direction = angle;
  const places = lengths.map((length, joint) => {
    direction += joint === 0 ? 0 : (bends[joint - 1] ?? 0);
    x += length * Math.cos((direction * Math.PI) / 180);
    y += length * Math.sin((direction * Math.PI) / 180);
    return `L${x.toFixed(1)} ${y.toFixed(1)}`;
  });
  return `M${start[0]} ${start[1]}${places.join("")}`;
}

/** How to stand: the camera at the side of the hand, seen from above; for a view box of 220 by 140. */
export const drawStand = (): SVGTemplateResult =>
  svg`<g fill="none" stroke="currentColor" stroke-width="2.4" stroke-linecap="round" stroke-linejoin="round">
    <circle cx="48" cy="32" r="17" /><path d="M18 62Q48 40 78 62" />
    <path d="M72 60Q84 82 112 84" stroke-width="11" opacity=".5" />
    <path d="M112 84h26" stroke-width="13" /><path d="M138 84h22" stroke-width="5" />
    <rect x="116" y="116" width="26" height="16" rx="3" /><path d="M123 116l-3-7h18l-3 7" />
    <path d="M129 106l-22 -12M129 106l34 -12" stroke-dasharray="3 4" stroke-width="1.4" />
    <text x="150" y="130" font-size="11" fill="currentColor" stroke="none">camera</text>
    <text x="14" y="84" font-size="11" fill="currentColor" stroke="none">you, from</text>
    <text x="14" y="97" font-size="11" fill="currentColor" stroke="none">above</text>
  </g>`;
