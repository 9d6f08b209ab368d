#include "core/asset/bake/Bake.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/base/Version.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/play/PlayInputJson.h"
#include "core/io/system/AtomicFile.h"
#include "tests/attack/EngineUse.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/attack/Sessions.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/files/FuzzedReaders.h"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;
using test::Sentence;

std::string contentsOf(const fs::path& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        std::fprintf(stderr, "%s\n", text.error().message.c_str());
        std::exit(2);
    }
    return *text;
}

/// The valid files of a folder.
std::vector<std::string> samplesIn(const char* folder, Sentence (*faultOf)(std::string_view)) {
    std::vector<std::string> samples;
    for (const auto& entry : fs::directory_iterator(fs::path(RUBBLE_SOURCE_DIR) / folder)) {
        const bool isFound = entry.path().filename().string().starts_with("found-");
        std::string text = isFound || !entry.is_regular_file() ? std::string() : contentsOf(entry.path());
        if (!text.empty() && nlohmann::json::accept(text) && !faultOf(text)) samples.push_back(std::move(text));
    }
    std::ranges::sort(samples);
    return samples;
}

std::string schemaOf(const char* name) {
    return contentsOf(fs::path(RUBBLE_SOURCE_DIR) / "resources/schemas" / (std::string(name) + ".schema.json"));
}

bool isSmallValue(const nlohmann::json& value) {
    constexpr double kMin = 0.02;
    constexpr double kMax = 64.0;
    if (value.is_number()) {
        const double size = std::abs(value.get<double>());
        return size == 0.0 || (size >= kMin && size <= kMax);
    }
    if (!value.is_structured()) return true;
    for (const auto& item : value.items()) {
        const bool isLabel = item.key() == "id" || item.key() == "randomSeed" || item.key() == "threshold";
        if (!isLabel && !isSmallValue(item.value())) return false;
    }
    return true;
}

/// Whether every number of a project's assets is that of an asset of moderate size, so that they are baked at once.
bool isSmall(const std::string& text) {
    const nlohmann::json project = nlohmann::json::parse(text);
    for (const nlohmann::json& asset : project["assets"]) {
        if (asset.contains("levels") && asset["levels"].size() > 2) return false;
        if (!isSmallValue(asset)) return false;
    }
    return project["assets"].size() <= 8 && project["instances"].size() <= 8;
}

Sentence bakeFault(const Project& project) {
    for (const Asset& asset : project.assets) {
        const Result<Bake> baked = bake(asset, {.threads = 1});
        if (!baked) return test::errorFault(baked.error());
        if (Sentence fault = verifyBake(*baked, asset)) return fault;
        for (const Diagnostic& one : baked->diagnostics) {
            if (Sentence fault = test::errorFault({ErrorCode::BadInput, one.message})) return fault;
        }
    }
    const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, {.threads = 1});
    if (!scene) return test::errorFault(scene.error());
    return playFault(*scene, {});
}

Verdict checkProject(std::string_view bytes, Random& random) {
    constexpr std::uint64_t kPlayedShare = 3;
    Verdict verdict{.fault = test::projectFault(bytes)};
    const Result<Project> project = readProjectText(bytes);
    verdict.isAccepted = project.hasValue();
    if (verdict.fault || !project || random.below(kPlayedShare) != 0) return verdict;
    const std::string text = projectText(*project);
    if (!nlohmann::json::accept(text)) return {true, false, "The written project is not JSON."};
    if (!isSmall(text)) return verdict;
    verdict.isPlayed = true;
    verdict.fault = bakeFault(*project);
    return verdict;
}

Verdict checkShots(std::string_view bytes, Random&) {
    Verdict verdict{.fault = test::shotsFault(bytes)};
    const Result<std::vector<Shot>> shots = readShotList(bytes);
    verdict.isAccepted = shots.hasValue();
    if (verdict.fault || !shots || shots->size() > 16) return verdict;
    std::vector<TimedInput> inputs;
    for (const Shot& shot : *shots) inputs.push_back({0, ShotInput{shot.name, shot.action}});
    verdict.isPlayed = true;
    verdict.fault = playFault(blockScene(), inputs);
    return verdict;
}

/// The inputs of a replay, without the seals that would reveal each change.
Verdict checkInputs(std::string_view bytes, Random&) {
    Result<JsonDocument> document = JsonDocument::parse(bytes);
    if (!document) return {.fault = test::errorFault(document.error())};
    const std::vector<TimedInput> inputs = document->root().list(readTimedInput);
    if (document->firstError()) return {.fault = test::errorFault(*document->firstError())};
    Verdict verdict{.isAccepted = true};
    const Replay replay{.program = programVersion(), .inputs = inputs};
    if (std::ranges::is_sorted(inputs, {}, &TimedInput::step)) verdict.fault = test::replayFault(replayText(replay));
    if (verdict.fault || inputs.size() > 32) return verdict;
    verdict.isPlayed = true;
    verdict.fault = playFault(blockScene(), inputs);
    return verdict;
}

/// A pack is read by the program and by the header that engines use. What is a right pack to the first is one to the
/// second.
Verdict checkPack(std::string_view bytes, Random& random) {
    Verdict verdict{.fault = test::packFault(bytes)};
    const Result<Pack> pack = readPack(bytes);
    verdict.isAccepted = pack.hasValue();
    rubble_pack::Pack read;
    const bool isRead = isReadBy(rubble_pack::parse, bytes, read, verdict.fault);
    if (verdict.fault) return verdict;
    if (!isRead && pack && !verifyPack(*pack)) verdict.fault = "The header refuses a right pack.";
    if (isRead) verdict.fault = packUseFault(read, random);
    return verdict;
}

/// A format that one function checks.
Format plainFormat(std::string name, std::shared_ptr<const JsonMutator> mutator, Sentence (*faultOf)(std::string_view),
                   std::function<bool(std::string_view)> isAccepted) {
    return {.name = std::move(name),
            .ending = ".json",
            .mutated = [mutator](Random& random) { return mutator->mutated(random); },
            .check = [faultOf, isAccepted](
                         std::string_view bytes,
                         Random&) { return Verdict{.isAccepted = isAccepted(bytes), .fault = faultOf(bytes)}; }};
}

std::string inputsText() {
    JsonWriter json;
    json.openArray();
    for (const TimedInput& input : sampleInputs()) writeTimedInput(json, input);
    json.close();
    return std::move(json).finished();
}

std::string shotsText() { return nlohmann::json::parse(projectText(fullProject()))["shots"].dump(); }

}  // namespace

std::vector<Format> jsonFormats() {
    std::vector<Format> formats;
    const auto mutatorOf = [](std::vector<std::string> samples, const std::string& schema) {
        return std::make_shared<const JsonMutator>(samples, schema);
    };
    std::vector<std::string> projects = samplesIn("tests/corpus/Project", test::projectFault);
    projects.push_back(projectText(fullProject()));
    projects.push_back(projectText(boxProject(UniformScatter{.count = 5})));
    const auto project = mutatorOf(std::move(projects), schemaOf("project"));
    formats.push_back(
        {"Project", ".rubble", [project](Random& random) { return project->mutated(random); }, checkProject});

    std::vector<std::string> packs = samplesIn("tests/corpus/Pack", test::packFault);
    packs.push_back(packOf(twoLevelRing()));
    const auto pack = mutatorOf(std::move(packs), schemaOf("pack"));
    formats.push_back({"Pack", ".json", [pack](Random& random) { return pack->mutated(random); }, checkPack, 1});
    std::vector<std::string> materials = samplesIn("resources/materials", test::materialFault);
    formats.push_back(plainFormat("Material", mutatorOf(std::move(materials), schemaOf("material")),
                                  test::materialFault,
                                  [](std::string_view bytes) { return readMaterialPresetText(bytes).hasValue(); }));
    formats.push_back(
        plainFormat("FractureJson", mutatorOf(samplesIn("tests/corpus/FractureJson", test::fractureFault), ""),
                    test::fractureFault, [](std::string_view bytes) { return readFractureInput(bytes).hasValue(); }));
    formats.push_back(plainFormat("BodiesJson", mutatorOf(samplesIn("tests/corpus/BodiesJson", test::bodiesFault), ""),
                                  test::bodiesFault,
                                  [](std::string_view bytes) { return readBodyScene(bytes).hasValue(); }));

    const auto inputs = mutatorOf({inputsText()}, "");
    formats.push_back({"Inputs", ".json", [inputs](Random& random) { return inputs->mutated(random); }, checkInputs});
    const auto shots = mutatorOf({shotsText()}, schemaOf("project"));
    formats.push_back({"Shots", ".json", [shots](Random& random) { return shots->mutated(random); }, checkShots});
    return formats;
}

}  // namespace rubble::attack
