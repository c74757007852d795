/** How people call a service, or another place that something came from. */

/** @param source As the library has it: poly_haven; files for what a person added. */
export function called(source: string): string {
  if (source === "files") return "your files";
  return source.split("_").map((word) => word.charAt(0).toUpperCase() + word.slice(1)).join(" ");
}
