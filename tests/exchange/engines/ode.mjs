import {report} from "../program.mjs";

export const program = "ODE";
const creeping = "contacts are new in each step and begin without impulses, so stacks creep";
const swap = [1e-2, "its collider of convex hulls takes the gap of a few pairs for a depth"];
export const settings = [
  {name: "dWorldQuickStep", argument: "defaults", looser: {swap, standing: [0.5, creeping], drift: [0.3, creeping]}},
  {name: "4 substeps, contacts without a normal left out", argument: "tuned",
   looser: {swap, standing: [0.1, creeping], drift: [5e-2, creeping]}},
];
export const slow = ["pane"];

export async function start(load, path) {
  return {version: "0.16.2", report: (pack, one, setting) => report(path, pack, one, setting.argument)};
}
