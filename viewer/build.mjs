// Builds the page's script and style into physsim/view/assets. Same sources, same bytes.
// `npm ci && npm run build`; `node build.mjs FOLDER` writes elsewhere (to compare with what is committed).

import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = resolve(process.argv[2] ?? join(here, "../physsim/view/assets"));
await mkdir(folder, { recursive: true });

await build({
  absWorkingDir: here,
  entryPoints: { viewer: "src/main.ts" },
  outdir: folder,
  bundle: true,
  format: "iife",
  target: ["es2022", "chrome94", "firefox93", "safari15.4"],
  minify: true,
  charset: "utf8",
  legalComments: "none",
  logLevel: "warning",
});

const three = join(here, "node_modules/three");
const { version } = JSON.parse(await readFile(join(three, "package.json"), "utf8"));
const licence = (await readFile(join(three, "LICENSE"), "utf8")).trim();
await writeFile(
  join(folder, "LICENSES.txt"),
  `viewer.js holds parts of three.js ${version} (https://threejs.org), under this licence:\n\n${licence}\n`,
);
await copyFile(join(here, "src/index.html"), join(folder, "index.html"));
