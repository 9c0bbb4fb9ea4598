/** What files can hold, by their names, as the show has it (`interchange/formats/file_kinds.py`). */

import { FILE_CONTENTS } from "../link/constants";

export type FileContent = (typeof FILE_CONTENTS)[keyof typeof FILE_CONTENTS][number];

/** What a file of this name may be; the first is what it is taken for where nothing else says so. */
export function contentsOf(name: string): readonly FileContent[] {
  const dot = name.lastIndexOf(".");
  const suffix = dot < 0 ? "" : name.slice(dot).toLowerCase();
  return Object.hasOwn(FILE_CONTENTS, suffix) ? FILE_CONTENTS[suffix as keyof typeof FILE_CONTENTS] : [];
}

/** The suffixes of files that can hold one of these. */
export const suffixesOf = (...contents: readonly FileContent[]): string[] =>
  Object.entries(FILE_CONTENTS).flatMap(([suffix, held]) =>
    held.some((content) => contents.includes(content)) ? [suffix] : [],
  );
