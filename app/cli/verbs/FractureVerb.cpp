#include "app/cli/console/InputOutput.h"
#include "app/cli/verbs/Verb.h"
#include "app/thesis/ThesisCells.h"
#include "core/io/fracture/FractureJson.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFractureFooter =
    R"(Input, from FILE or standard input:
  {"outline":[[x,y],...], "holes":[[[x,y],...],...], "depth":d, "seeds":[[x,y],...]}
"holes" is optional; points that close a ring or repeat the one before are left out; lengths are in metres.

Output, on one line:
  {"cells":[{"seed":i,"area":a,"centroid":[x,y],"pieces":[{"outer":[...],"holes":[...]}],"neighbours":[...]},...],
   "triangles":[[a,b,c],...], "report":[{"code":"DuplicateSeed","seed":j,"of":i,"message":"..."},...]}
Cells are in seed order, without seeds that have none; indices are those of the input.

Examples:
  rubble-cli fracture pane.json > cells.json
  echo '{"outline":[[0,0],[1,0],[1,1],[0,1]],"depth":1,"seeds":[[0.2,0.5],[0.7,0.5]]}' | rubble-cli fracture)";

struct FractureOptions {
    std::string input = "-";
    std::string method = "exact";
};

Status fracture(const FractureOptions& options, const CliContext& context) {
    const Result<std::string> text = readInput(options.input, context);
    if (!text) return text.error();
    const Result<FractureInput> input = readFractureInput(*text);
    if (!input) return input.error();
    if (options.method == "thesis") return printText(thesisJson(*input), context);
    const Result<std::string> json = fractureJson(*input, {.cancel = context.cancel});
    if (!json) return json.error();
    return printText(*json, context);
}

}  // namespace

Verb addFracture(CLI::App& program) {
    Command command(program, "fracture", "Cut an outline into Voronoi cells, from JSON to JSON", kFractureFooter);
    const auto options = std::make_shared<FractureOptions>();
    command.argument("FILE", options->input, "The input (default: -, standard input)").reads();
    command.option("--method", options->method, "exact (default), or thesis, the reference method with its errors")
        .oneOf({"exact", "thesis"})
        .valueName("exact|thesis");
    return {command, [options](VerbReport&, const CliContext& context) { return fracture(*options, context); }};
}

}  // namespace rubble
