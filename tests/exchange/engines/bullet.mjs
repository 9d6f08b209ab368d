import {report} from "../program.mjs";

export const program = "Bullet";
const margin = "its margin of 40 mm on each side of hulls is more than the gap between them";
export const settings = [
  {name: "defaults", argument: "defaults", looser: {swap: [10, margin], standing: [10, margin], drift: [10, margin]}},
  {name: "margin 0.02 mm, 2 friction directions, interleaved, 30 iterations, 4 substeps", argument: "tuned"},
];
export const slow = ["pane"];

export async function start(load, path) {
  return {version: "3.24", report: (pack, one, setting) => report(path, pack, one, setting.argument)};
}
