import { Library } from "../link/assets";
import { now } from "../link/clock";
import { ParameterError, readParameters, type StageParameters } from "./parameters";
import { Stage } from "./stage";

const notice = document.getElementById("notice") as HTMLElement;
const canvas = document.getElementById("stage") as HTMLCanvasElement;

/** Says a sentence on the page, for whoever sets the stage up. */
function say(sentence: string): void {
  notice.textContent = sentence;
}

async function open(parameters: StageParameters): Promise<void> {
  document.documentElement.classList.toggle("transparent", parameters.transparent);
  const library = await Library.open();
  const stage = await Stage.open(canvas, library, parameters);
  const tick = (): void => {
    stage.frame(now());
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

try {
  await open(readParameters(location.search));
} catch (error) {
  say(error instanceof Error ? error.message : String(error));
  if (!(error instanceof ParameterError)) console.error(error);
}
