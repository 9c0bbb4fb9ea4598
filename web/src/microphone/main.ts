/** The microphone page's entry point. */

import { showAccess } from "../access/access_banner";
import { missingRole, readAccess } from "../access/page_access";
import { MicrophonePage } from "./microphone_page";

document.body.append(new MicrophonePage());
void readAccess().then((access) => showAccess(missingRole(access, "operate", "speaking through a character")));
