#include "core/io/mesh/MeshImport.h"
#include "core/io/system/ChildProcess.h"
#include "tests/attack/Format.h"
#include "tests/attack/MeshMutator.h"
#include "tests/support/files/FuzzedReaders.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxLog = std::size_t{1} << 24;

/// A folder for meshes with the files that the samples refer to, and files outside of it that no mesh may open. Inputs
/// do not depend on its path, so that they are the same in every process.
class MeshFolder {
public:
    explicit MeshFolder(const fs::path& root) : m_outside(root / std::to_string(::getpid())) {
        constexpr std::size_t kMaxCompanion = 10000;  // bytes
        fs::remove_all(m_outside);
        fs::create_directories(m_outside / "mesh/below");
        for (const fs::path& folder : meshFolders()) {
            for (const auto& entry : fs::directory_iterator(folder)) {
                const bool isNamed = entry.path().extension() == ".mtl" || entry.path().extension() == ".bin";
                if (isNamed && entry.is_regular_file() && entry.file_size() <= kMaxCompanion)
                    fs::copy_file(entry, path(entry.path().filename()), fs::copy_options::overwrite_existing);
            }
        }
        std::ofstream(m_outside / "outside.bin") << "newmtl Brick\nKd 1 0 0\n#" << std::string(36, ' ') << '\n';
        fs::create_symlink("../outside.bin", path("outside-link.bin"));
        fs::create_symlink("..", path("outside-folder"));
        m_watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
        if (::inotify_add_watch(m_watch, (m_outside / "outside.bin").c_str(), IN_OPEN | IN_ACCESS) < 0) std::exit(2);
    }
    ~MeshFolder() { ::close(m_watch); }
    MeshFolder(const MeshFolder&) = delete;
    MeshFolder& operator=(const MeshFolder&) = delete;

    fs::path path(const fs::path& name) const { return m_outside / "mesh" / name; }
    /// Returns whether the kernel saw the file outside being opened since the last call.
    bool isOutsideOpened() {
        alignas(inotify_event) std::array<char, 4096> events;
        return ::read(m_watch, events.data(), events.size()) > 0;
    }

private:
    fs::path m_outside;
    int m_watch = -1;
};

/// Takes the importer's log of files out of its standard error, and returns the fault of the log: no file outside of
/// the folder is opened.
std::optional<std::string> takeLog(std::string& error, ImporterFigures& figures) {
    constexpr std::string_view kOpened = "opened ";
    constexpr std::string_view kRefused = "refused ";
    if (error.size() >= kMaxLog) return "The importer's log of files is too long.";
    std::istringstream lines(std::exchange(error, {}));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(kRefused)) {
            ++figures.refused;
        } else if (line.starts_with(kOpened)) {
            ++figures.opened;
            const fs::path path = fs::path(line.substr(kOpened.size())).lexically_normal();
            if (path.is_absolute() || *path.begin() == "..") return "The importer " + line;
        } else {
            error += line + '\n';
        }
    }
    return std::nullopt;
}

void countEnd(const ChildResult& outcome, ImporterFigures& figures) {
    constexpr int kOutOfMemory = 3;  // see app/importer/Main.cpp
    figures.crashed += outcome.exit == ChildExit::Crashed ? 1 : 0;
    figures.timedOut += outcome.exit == ChildExit::TimedOut ? 1 : 0;
    figures.outOfMemory += outcome.exit == ChildExit::Exited && outcome.exitCode == kOutOfMemory ? 1 : 0;
}

/// Reads a mesh as importMesh() does, and also the importer's log.
Verdict checkMesh(const fs::path& importer, MeshFolder& folder, const std::string& name, std::string_view bytes) {
    const fs::path file = folder.path(name);
    std::ofstream(file, std::ios::binary) << bytes;
    ChildLimits limits = importerLimits();
    limits.error = kMaxLog;
    Result<ChildResult> outcome = runChild(importer, {"--log-files", file.string()}, limits, {});
    if (!outcome) return {.fault = outcome.error().message};
    Verdict verdict;
    countEnd(*outcome, verdict.importer);
    verdict.fault = takeLog(outcome->error, verdict.importer);
    if (folder.isOutsideOpened()) verdict.fault = "The importer opened ../outside.bin.";
    if (verdict.fault) return verdict;
    const Result<SourceScene> scene = importedMesh(*outcome, file);
    verdict.isAccepted = verdict.isPlayed = scene.hasValue();
    if (scene) {
        verdict.fault = test::importFault(*scene);
    } else {
        const bool hasSucceeded = outcome->exit == ChildExit::Exited && outcome->exitCode == 0;
        verdict.fault = hasSucceeded ? scene.error().message : test::errorFault(scene.error());
    }
    return verdict;
}

/// Exits if the importer does not read a valid mesh or does not keep its log.
void tryImporter(const fs::path& importer) {
    const std::string mesh = RUBBLE_SOURCE_DIR "/tests/data/meshes/wall.obj";
    const Result<ChildResult> outcome = runChild(importer, {"--log-files", mesh}, importerLimits(), {});
    if (outcome && outcome->exitCode == 0 && outcome->error.ends_with("opened wall.mtl\n")) return;
    std::fprintf(stderr, "%s does not read wall.obj.\n", importer.c_str());
    std::exit(2);
}

}  // namespace

std::vector<Format> meshFormats(const fs::path& importer, const fs::path& folder) {
    tryImporter(importer);
    std::vector<Format> formats;
    for (const std::string ending : kMeshEndings) {
        const auto mutator = std::make_shared<const MeshMutator>(ending);
        formats.push_back({.name = "Mesh/" + ending.substr(1),
                           .ending = ending,
                           .mutated = [mutator](Random& random) { return mutator->mutated(random); },
                           .check =
                               [importer, folder, ending](std::string_view bytes, Random&) {
                                   static MeshFolder meshes(folder);  // of this process
                                   return checkMesh(importer, meshes, "mesh" + ending, bytes);
                               },
                           .checks = 1});
    }
    return formats;
}

}  // namespace rubble::attack
