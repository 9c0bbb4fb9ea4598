/** The notes page's entry point. */

import { onFileDrop } from "../../ui/file_import";
import { NotesPage } from "./notes_page";

onFileDrop(); // a file that slips from a hand must not take the page's place
document.body.append(new NotesPage());
