#include "core/base/Version.h"
#include "core/io/output/ExportCheck.h"
#include "core/io/output/ExportFolder.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/attack/ReplaySeals.h"
#include "tests/attack/Sessions.h"
#include "tests/support/files/FuzzedReaders.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;
using test::Sentence;

constexpr std::uint64_t kUnsealedShare = 8;  // one in so many inputs keeps the seals that no longer match
constexpr std::size_t kMaxInputs = 32;
constexpr std::uint64_t kMaxSteps = 80;

[[noreturn]] void fail(const Error& error) {
    std::fprintf(stderr, "%s\n", error.message.c_str());
    std::exit(2);
}

/// A replay is read, written again and, if it is short, played beside its recording.
Verdict checkReplay(std::string_view bytes, Random&) {
    Verdict verdict{.fault = test::replayFault(bytes)};
    Result<Replay> replay = readReplayText(bytes);
    verdict.isAccepted = replay.hasValue();
    if (verdict.fault || !replay || replay->inputs.size() > kMaxInputs) return verdict;
    const std::uint64_t steps = std::min<std::uint64_t>(replay->steps.size(), kMaxSteps);
    Result<ReplayPlayer> player = ReplayPlayer::start(blockScene(), std::move(*replay), {.threads = 1});
    if (!player) return {true, false, test::errorFault(player.error()), {}};
    verdict.isPlayed = true;
    if (const Status played = player->seek(steps); !played) verdict.fault = test::errorFault(played.error());
    if (!verdict.fault) verdict.fault = outcomeFault(player->session());
    if (!verdict.fault && player->divergence())
        verdict.fault = test::errorFault({ErrorCode::BadInput, player->divergence()->diagnostic().message});
    return verdict;
}

std::string sampleReplay(const std::vector<TimedInput>& inputs, bool isDetailed) {
    Result<Replay> replay = recordReplay(blockScene(), {.threads = 1}, inputs, 70, programVersion(), {1, 2});
    if (!replay) fail(replay.error());
    replay->isDetailed = isDetailed;
    std::string text = replayText(*replay);
    std::string changed = text;
    changed.replace(changed.find("\"ball\""), 6, "\"bulb\"");
    if (readReplayText(changed)) fail({ErrorCode::BadInput, "A change of a replay is not noticed."});
    if (const Result<Replay> sealed = readReplayText(withReplaySeals(changed)); !sealed) fail(sealed.error());
    return text;
}

std::string sealed(std::string replay, Random& random) {
    return random.below(kUnsealedShare) == 0 ? replay : withReplaySeals(replay);
}

/// A folder with an export in it, and a file beside it that nothing may touch.
class ExportPlace {
public:
    explicit ExportPlace(fs::path folder) : m_folder(std::move(folder)) {
        fs::create_directories(m_folder);
        write(outside(), kOutside);
    }
    ~ExportPlace() {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }
    ExportPlace(const ExportPlace&) = delete;
    ExportPlace& operator=(const ExportPlace&) = delete;

    fs::path pack() const { return m_folder / "pack"; }
    fs::path outside() const { return m_folder / "outside.txt"; }
    /// Without flushing, which would take most of the time.
    static void write(const fs::path& path, std::string_view bytes) {
        std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    bool isOutsideUntouched() const {
        const Result<std::string> text = readFile(outside());
        return text && *text == kOutside;
    }

private:
    static constexpr const char* kOutside = "outside";
    fs::path m_folder;
};

const std::vector<ExportFile>& exportedFiles() {
    static const std::vector<ExportFile> files = {{"pack.json", "{}"}, {"box.obj", "v 0 0 0"}, {"box.mtl", ""}};
    return files;
}

std::string sampleManifest(const fs::path& folder) {
    const ExportPlace place(folder / "sample");
    if (const Status written = writeExportFolder(place.pack(), {1, 2}, exportedFiles()); !written)
        fail(written.error());
    const Result<std::string> manifest = readFile(place.pack() / kManifestName);
    if (!manifest) fail(manifest.error());
    return *manifest;
}

/// A manifest lies in the folder of an export, which is then verified, and exported to again.
Verdict checkManifest(const fs::path& folder, std::string_view bytes) {
    const ExportPlace place(folder / std::to_string(::getpid()));
    fs::create_directories(place.pack());
    for (const ExportFile& file : exportedFiles()) ExportPlace::write(place.pack() / file.name, file.bytes);
    ExportPlace::write(place.pack() / kManifestName, bytes);
    const std::optional<std::string> fault = verifyExportFolder(place.pack());
    if (fault && test::errorFault({ErrorCode::BadInput, *fault})) return {.fault = *fault};
    Verdict verdict{.isAccepted = !fault};
    if (isExportOf(place.pack(), {1, 2}) && fault) verdict.fault = "A folder with a fault is taken for the export.";
    const std::vector<ExportFile> files = {{"pack.json", "{\"new\":1}"}};
    const Status written = writeExportFolder(place.pack(), {3, 4}, files, EditedFiles::Replaced);
    if (!written) verdict.fault = test::errorFault(written.error());
    if (written && verifyExportFolder(place.pack())) verdict.fault = "A new export has a fault.";
    if (!written && verdict.isAccepted) verdict.fault = "A right export is not replaced: " + written.error().message;
    if (!place.isOutsideUntouched()) verdict.fault = "A file outside of the folder changed.";
    return verdict;
}

Format replayFormat(std::string name, std::vector<std::string> samples) {
    const auto mutator = std::make_shared<const JsonMutator>(samples, "");
    return {std::move(name), ".replay", [mutator](Random& random) { return sealed(mutator->mutated(random), random); },
            checkReplay};
}

}  // namespace

std::vector<Format> sealedFormats(const fs::path& folder) {
    const std::vector<TimedInput> inputs = sampleInputs();
    const std::string throwing = sampleReplay({inputs.front()}, true), all = sampleReplay(inputs, true);
    std::vector<Format> formats;
    formats.push_back(replayFormat("Replay", {throwing, all}));
    formats.push_back(replayFormat("ReplayVersion1", {sampleReplay({inputs.front()}, false)}));
    formats.push_back({"ReplayBytes", ".replay",
                       [all](Random& random) { return sealed(mutatedBytes(all, random), random); }, checkReplay});
    const auto manifest = std::make_shared<const JsonMutator>(std::vector{sampleManifest(folder)}, "");
    formats.push_back({"Manifest", ".json", [manifest](Random& random) { return manifest->mutated(random); },
                       [folder](std::string_view bytes, Random&) { return checkManifest(folder, bytes); }, 1});
    return formats;
}

}  // namespace rubble::attack
