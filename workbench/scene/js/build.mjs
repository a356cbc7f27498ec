// Builds the two bundles in ../static and notes the hashes of source and bundles beside them.
// Usage: npm ci && npm run build
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const target = join(here, "..", "static");

const common = {
  bundle: true,
  minify: true,
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  loader: { ".css": "text" },
  define: { "define.amd": "false" },
  banner: { js: "/* SeaView; contains three.js, MIT licence, copyright three.js authors */" },
  logLevel: "info",
};
await build({
  ...common,
  entryPoints: [join(here, "src", "widget.js")],
  format: "esm",
  outfile: join(target, "sea_view.js"),
});
await build({
  ...common,
  entryPoints: [join(here, "src", "standalone.js")],
  format: "iife",
  outfile: join(target, "sea_view_standalone.js"),
});

const digest = (paths) => {
  const hash = createHash("sha256");
  for (const path of paths) hash.update(readFileSync(path));
  return hash.digest("hex");
};
const source = readdirSync(join(here, "src")).sort().map((name) => join(here, "src", name));
const hashes = {
  source: digest([...source, join(here, "build.mjs"), join(here, "package.json"), join(here, "package-lock.json")]),
  "sea_view.js": digest([join(target, "sea_view.js")]),
  "sea_view_standalone.js": digest([join(target, "sea_view_standalone.js")]),
};
writeFileSync(join(target, "hashes.json"), `${JSON.stringify(hashes, null, 2)}\n`);
