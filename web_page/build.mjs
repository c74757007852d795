/** Bundles the page into the package. The first line of the bundle has the digest of what it was made from. */

import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { build } from "esbuild";

const sources = ["package-lock.json", ...readdirSync("src").sort().map((name) => `src/${name}`)];
const digest = createHash("sha256");
for (const name of sources) digest.update(readFileSync(name));

await build({
  entryPoints: ["src/studio.ts"],
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  legalComments: "eof",
  banner: { js: `// made from ${digest.digest("hex")} by \`npm run build\` in web_page` },
  outfile: "../src/storyblender/web_studio/static/studio.js",
});
