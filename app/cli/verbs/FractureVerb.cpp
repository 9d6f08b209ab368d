#include "app/cli/console/InputOutput.h"
#include "app/cli/verbs/Verb.h"
#include "app/thesis/ThesisCells.h"
#include "core/base/Parallel.h"
#include "core/io/fracture/FractureJson.h"
#include "core/io/fracture/SolidFractureJson.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFractureFooter =
    R"(Input, from FILE or standard input:
  {"outline":[[x,y],...], "holes":[[[x,y],...],...], "depth":d, "seeds":[[x,y],...]}
or {"mesh":{"points":[[x,y,z],...], "triangles":[[a,b,c],...]}, "seeds":[[x,y,z],...]}
"holes" is optional; points that close a ring or repeat the one before are left out; lengths are in metres. A mesh has
to be closed and may touch, but not cross itself; shells in others are cavities.

Output, on one line:
  {"cells":[{"seed":i,"area":a,"centroid":[x,y],"pieces":[{"outer":[...],"holes":[...]}],"neighbours":[...]},...],
   "triangles":[[a,b,c],...], "report":[{"code":"DuplicateSeed","seed":j,"of":i,"message":"..."},...]}
Cells are in seed order, without seeds that have none; indices are those of the input. Of a mesh:
  {"points":[[x,y,z],...], "faces":[{"fragment":f,"behind":g,"source":t,"triangles":[[a,b,c],...]},...],
   "fragments":[{"seed":i,"volume":v,"centroid":[x,y,z],"faces":[...],"neighbours":[...]},...], "report":[...]}
Each face between two fragments is there once, counter-clockwise seen from outside "fragment"; one of the outside has
the triangle that it is part of as "source" in place of "behind". The first points are those of the input.

Examples:
  rubble-cli fracture pane.json > cells.json
  echo '{"outline":[[0,0],[1,0],[1,1],[0,1]],"depth":1,"seeds":[[0.2,0.5],[0.7,0.5]]}' | rubble-cli fracture)";

struct FractureOptions {
    std::string input = "-";
    std::string method = "exact";
};

Status fractureMesh(const std::string& text, const FractureOptions& options, const CliContext& context) {
    if (options.method == "thesis") {
        return Error{ErrorCode::BadInput, "The method of the thesis cuts outlines; a mesh is cut by --method exact."};
    }
    const TaskContext task{.cancel = context.cancel, .threads = availableProcessors()};
    const Result<SolidFractureInput> input = readSolidFractureInput(text, task);
    if (!input) return input.error();
    const Result<std::string> json = solidFractureJson(*input, task);
    if (!json) return json.error();
    return printText(*json, context);
}

Status fracture(const FractureOptions& options, const CliContext& context) {
    const Result<std::string> text = readInput(options.input, context);
    if (!text) return text.error();
    if (hasMesh(*text)) return fractureMesh(*text, options, context);
    const Result<FractureInput> input = readFractureInput(*text);
    if (!input) return input.error();
    if (options.method == "thesis") return printText(thesisJson(*input), context);
    const Result<std::string> json = fractureJson(*input, {.cancel = context.cancel});
    if (!json) return json.error();
    return printText(*json, context);
}

}  // namespace

Verb addFracture(CLI::App& program) {
    Command command(program, "fracture", "Cut an outline or a closed mesh into Voronoi cells, from JSON to JSON",
                    kFractureFooter);
    const auto options = std::make_shared<FractureOptions>();
    command.argument("FILE", options->input, "The input (default: -, standard input)").reads();
    command.option("--method", options->method, "exact (default), or thesis, the reference method with its errors")
        .oneOf({"exact", "thesis"})
        .valueName("exact|thesis");
    return {command, [options](VerbReport&, const CliContext& context) { return fracture(*options, context); }};
}

}  // namespace rubble
