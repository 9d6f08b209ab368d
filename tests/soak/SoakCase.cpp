#include "tests/soak/SoakCase.h"

#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/play/PlayInputJson.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"

#include <fstream>
#include <iterator>

namespace rubble::soak {
namespace {

std::filesystem::path projectOf(std::filesystem::path soakFile) { return soakFile.replace_extension(".rubble"); }

std::string soakText(const SoakCase& one, const std::string& note) {
    JsonWriter json;
    json.openObject();
    json.text("format", "rubble-soak");
    json.text("shows", note);
    json.number("dt", one.dt);
    json.boolean("sleeping", one.isSleeping);
    json.wholeNumber("steps", one.steps);
    json.list("inputs", one.inputs, writeTimedInput);
    json.list("rewinds", one.rewinds, [](JsonWriter& list, const Rewind& rewind) {
        list.openObject({}, JsonLayout::Inline);
        list.wholeNumber("step", rewind.step);
        list.wholeNumber("steps", rewind.steps);
        list.close();
    });
    json.list("saves", one.saves, [](JsonWriter& list, std::uint64_t step) { list.wholeNumber({}, step); });
    json.boolean("compared", one.isCompared);
    json.close();
    return std::move(json).finished();
}

}  // namespace

Status saveCase(const std::filesystem::path& soakFile, const SoakCase& one, const std::string& note) {
    if (const Status saved = saveProject(projectOf(soakFile), one.project); !saved) return saved;
    return writeFileAtomically(soakFile, soakText(one, note));
}

Result<SoakCase> loadCase(const std::filesystem::path& soakFile) {
    Result<Project> project = loadProject(projectOf(soakFile));
    if (!project) return project.error();
    std::ifstream stream(soakFile, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    Result<JsonDocument> document = JsonDocument::parse(text);
    if (!document) return document.error();
    const JsonValue root = document->root();
    root.requireObject({"format", "shows", "dt", "sleeping", "steps", "inputs", "rewinds", "saves", "compared"});
    SoakCase one{.project = std::move(*project)};
    one.dt = root["dt"].number(above(0.0));
    one.isSleeping = root["sleeping"].boolean();
    one.steps = root["steps"].wholeNumber();
    one.inputs = root["inputs"].list(readTimedInput);
    one.rewinds = root["rewinds"].list([](const JsonValue& value) {
        return Rewind{value["step"].wholeNumber(), value["steps"].wholeNumber()};
    });
    one.saves = root["saves"].list([](const JsonValue& value) { return value.wholeNumber(); });
    one.isCompared = root["compared"].boolean();
    if (document->firstError()) return *document->firstError();
    return one;
}

}  // namespace rubble::soak
