/** The stage page. */

import { Library } from "../link/assets";
import { PREVIEW_WORDS } from "../link/bus";
import { now } from "../link/clock";
import { onFileDrop } from "../ui/file_import";
import { WakeLock } from "../ui/wake_lock";
import { ParameterError, readParameters, type StageParameters } from "./parameters";
import { PREVIEW_FOOT, Stage } from "./stage";
import { exposeProbe } from "./stage_probe";

const notice = document.getElementById("notice") as HTMLElement;
const canvas = document.getElementById("stage") as HTMLCanvasElement;

async function open(parameters: StageParameters): Promise<void> {
  if (parameters.bus === "preview") showPreview();
  document.documentElement.classList.toggle("transparent", parameters.transparent);
  const stage = await Stage.open(canvas, await Library.open(parameters.hair), parameters, new WakeLock());
  exposeProbe(stage);
  const tick = (): void => {
    stage.frame(now());
    const missing = missingNotice(stage);
    tell(missing || stage.sound.notice, missing === "");
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
  if (parameters.hud) showCounters(stage, parameters);
}

/** Says something over the picture; at its edge where there may be a face. */
function tell(text: string, atEdge: boolean): void {
  if (notice.textContent === text) return;
  notice.textContent = text;
  notice.classList.toggle("edge", atEdge);
}

/** Says below the picture that nobody in the house sees it; beside the page, which is dark while the picture is black. */
function showPreview(): void {
  document.title = `${PREVIEW_WORDS} · ${document.title}`;
  document.documentElement.style.setProperty("--foot", `${PREVIEW_FOOT}px`);
  const strip = document.documentElement.appendChild(document.createElement("div"));
  strip.id = "preview";
  strip.textContent = PREVIEW_WORDS;
}

/** Lets the page fill its screen, and no more, by F and by a double click, where its browser allows that. */
function fillScreenOnDemand(): void {
  addEventListener("dblclick", toggleFullScreen);
  addEventListener("keydown", (event) => {
    const chord = event.ctrlKey || event.altKey || event.metaKey;
    if (event.code === "KeyF" && !chord && !event.repeat) toggleFullScreen();
  });
}

function toggleFullScreen(): void {
  const fill = document.fullscreenElement === null;
  const done = fill ? document.documentElement.requestFullscreen?.() : document.exitFullscreen(); // none on an iPhone
  done?.catch(() => undefined); // what is refused changes nothing
}

/** Why the picture is empty, where the character that it is to show is not in the show; it waits until that one comes. */
function missingNotice({ missing, characters }: Stage): string {
  if (missing === undefined) return "";
  return `There is no character "${missing}" in this show; it has ${characters.join(", ")}. This stage waits until one of that name comes.`;
}

/** What a technician wants to see in a corner of the picture. */
function showCounters(stage: Stage, parameters: StageParameters): void {
  const shows = parameters.bus === "air" ? "on air" : "preview";
  const hud = document.body.appendChild(document.createElement("pre"));
  hud.id = "hud";
  setInterval(() => {
    const { fps, level, received, ignored, number, connected } = stage.counters();
    const faces = Object.values(stage.shown?.characters ?? {})
      .map((character) => Object.keys(character.faces).join(" + "))
      .join(", ");
    hud.textContent = `${connected ? shows : "no server"}  ${fps} fps  ${level}  state ${number} (${received}, late ${ignored})\n${faces}`;
  }, 500);
}

fillScreenOnDemand();
onFileDrop(); // a file that slips from a hand must not take the picture's place
try {
  await open(readParameters(location.search + location.hash));
} catch (error) {
  notice.textContent = error instanceof Error ? error.message : String(error); // for whoever sets the stage up
  document.body.style.opacity = "1"; // no picture comes for which the page would be black
  if (!(error instanceof ParameterError)) console.error(error);
}
