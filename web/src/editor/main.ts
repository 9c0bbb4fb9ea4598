/** The editor page: authored once, played on every face. */

import { EDITING_PATH, EDITING_VERSION, type Greet } from "../link/editing";

const greet: Greet = { type: "greet", editor: "page", name: "Editor", version: EDITING_VERSION };
document.body.append(`${greet.name} of ${EDITING_PATH}, version ${greet.version}.`);
