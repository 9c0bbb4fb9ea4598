/** The microphone page's entry point. */

import { showAccess } from "../access/access_banner";
import { missingRole, readAccess } from "../access/page_access";
import { onFileDrop } from "../ui/file_import";
import { MicrophonePage } from "./microphone_page";

onFileDrop(); // a file that slips from a hand must not take the page's place
document.body.append(new MicrophonePage());
void readAccess().then((access) => showAccess(missingRole(access, "operate", "speaking through a character")));
