/** What people call a source: its name without the address that tells it from others of the same name. */

const ADDRESS = / (?:\d{1,3}(?:\.\d{1,3}){3}|(?=\S*::|(?:[0-9a-f]+:){7})[0-9a-f:.]+(?:%\w+)?)$/i;

/** The name of a source as people read it. `others`: the names of all; two that would read the same keep their address. */
export function sourceLabel(name: string, others: readonly string[] = []): string {
  const label = name.replace(ADDRESS, "");
  return others.some((other) => other !== name && other.replace(ADDRESS, "") === label) ? name : label;
}

/** The address at the end of a source's name; "" where there is none. */
export const sourceAddress = (name: string): string => ADDRESS.exec(name)?.[0].trim() ?? "";
