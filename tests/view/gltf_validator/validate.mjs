// node validate.mjs FILE.glb... prints what the Khronos validator says: one JSON list, an entry for each file.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

const reports = [];
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 20 });
  reports.push({ file, issues: report.issues, info: report.info });
}
console.log(JSON.stringify(reports));
