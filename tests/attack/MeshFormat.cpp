#include "core/asset/import/AssetImport.h"
#include "core/geometry/mesh/SourceScene.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/ChildProcess.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/support/files/FuzzedReaders.h"

#include <unistd.h>

#include <cstring>
#include <memory>
#include <set>
#include <sstream>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSampleSize = 12000;  // bytes; larger ones take the importer longer

struct MeshSample {
    std::string ending;  // ".obj"
    std::string bytes;
};

std::vector<MeshSample> meshSamples() {
    const std::set<std::string> endings = {".obj", ".stl", ".ply", ".glb", ".gltf", ".fbx"};
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(RUBBLE_SOURCE_DIR) / "tests/data/meshes")) {
        const bool isMesh = entry.is_regular_file() && endings.contains(entry.path().extension().string());
        if (isMesh && entry.file_size() <= kMaxSampleSize) paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    std::vector<MeshSample> samples;
    for (const fs::path& path : paths) samples.push_back({path.extension().string(), *readFile(path)});
    return samples;
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

std::string bytesOf(std::uint32_t word) {
    std::string bytes(sizeof word, '\0');
    std::memcpy(bytes.data(), &word, sizeof word);
    return bytes;
}

/// A GLB file: a header of 12 bytes, a chunk of JSON, a chunk of data.
std::string mutatedGlb(const std::string& glb, Random& random) {
    constexpr std::size_t kJson = 20;  // after the headers of the file and the chunk
    const std::size_t size = wordAt(glb, 12);
    std::string json = JsonMutator({glb.substr(kJson, size)}, "").mutated(random);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string data = glb.substr(kJson + size);
    if (random.below(3) == 0) data = mutatedBytes(data, random);
    return glb.substr(0, 8) + bytesOf(static_cast<std::uint32_t>(kJson + json.size() + data.size())) +
           bytesOf(static_cast<std::uint32_t>(json.size())) + glb.substr(16, 4) + json + data;
}

/// A first line that names the ending, then the file: an input says by itself how it is read.
std::string mutatedMesh(const MeshSample& sample, Random& random) {
    const bool isText = sample.bytes.find('\0') == std::string::npos;
    std::string bytes;
    if (random.below(3) == 0)
        bytes = mutatedBytes(sample.bytes, random);
    else if (sample.ending == ".glb")
        bytes = mutatedGlb(sample.bytes, random);
    else if (sample.ending == ".gltf")
        bytes = JsonMutator({sample.bytes}, "").mutated(random);
    else
        bytes = isText ? mutatedLines(sample.bytes, random) : mutatedBytes(sample.bytes, random);
    return sample.ending + '\n' + bytes;
}

/// Returns the fault of what the importer's log tells: it opens no file outside the folder.
std::optional<std::string> logFault(const std::string& log) {
    constexpr std::string_view kOpened = "opened ";
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(kOpened)) continue;
        const fs::path path = fs::path(line.substr(kOpened.size())).lexically_normal();
        if (path.is_absolute() || path.string().starts_with("..")) return "The importer " + line;
    }
    return std::nullopt;
}

/// What the parent does with the outcome of the importer.
Verdict verdictOf(const ChildResult& outcome) {
    if (outcome.exit != ChildExit::Exited || outcome.exitCode != 0) return {};
    const Result<SourceScene> scene = readSourceScene(outcome.output);
    if (!scene) return {.fault = "The importer returned invalid data: " + scene.error().message};
    Verdict verdict{.isAccepted = true, .isPlayed = true};
    const Result<ImportOutcome> imported = importedInto({}, *scene, "mesh", {}, {.threads = 1});
    if (!imported) return {true, true, test::errorFault(imported.error())};
    for (const RejectedObject& rejected : imported->rejected) {
        if ((verdict.fault = test::errorFault(rejected.error))) return verdict;
    }
    verdict.fault = test::projectFault(projectText(imported->project));
    return verdict;
}

/// Whether the importer names the files that it opens.
bool hasLog(const fs::path& importer) {
    const std::string mesh = RUBBLE_SOURCE_DIR "/tests/data/meshes/wall.obj";
    const Result<ChildResult> outcome = runChild(importer, {"--log-files", mesh}, {}, {});
    return outcome && outcome->exitCode == 0;
}

}  // namespace

Format meshFormat(const fs::path& importer, const fs::path& folder) {
    fs::create_directories(folder);
    fs::copy_file(RUBBLE_SOURCE_DIR "/tests/data/meshes/wall.mtl", folder / "wall.mtl",
                  fs::copy_options::overwrite_existing);
    const bool isLogged = hasLog(importer);
    if (!isLogged) std::printf("The importer keeps no log of files: which ones it opens is not checked.\n");
    const auto samples = std::make_shared<const std::vector<MeshSample>>(meshSamples());
    return {
        .name = "Mesh",
        .ending = ".mesh",
        .mutated = [samples](Random& random) { return mutatedMesh((*samples)[random.below(samples->size())], random); },
        .check = [importer, folder, isLogged](std::string_view bytes, Random&) -> Verdict {
            const std::size_t end = bytes.find('\n');
            const fs::path file = folder / (std::to_string(::getpid()) + std::string(bytes.substr(0, end)));
            if (!writeFileAtomically(file, bytes.substr(end + 1))) return {.fault = "The mesh cannot be written."};
            std::vector<std::string> arguments{file.string()};
            if (isLogged) arguments.insert(arguments.begin(), "--log-files");
            const Result<ChildResult> outcome = runChild(importer, arguments, {}, {});
            fs::remove(file);
            if (!outcome) return {.fault = test::errorFault(outcome.error())};
            if (std::optional<std::string> fault = logFault(outcome->error)) return {.fault = fault};
            return verdictOf(*outcome);
        }};
}

}  // namespace rubble::attack
