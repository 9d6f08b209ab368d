#include "core/io/MeshImport.h"

#include "core/io/ChildProcess.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>

namespace rubble {
namespace {

// What rubble-importer ends with; see app/importer/Main.cpp.
constexpr int kRefused = 1;
constexpr int kOutOfMemory = 3;

std::string quotedName(const std::filesystem::path& file) { return "\"" + file.filename().string() + "\""; }

/// The first line of what the child said: readable, and no longer than a sentence.
std::string firstLine(const std::string& text) {
    constexpr std::size_t kLongest = 500;
    std::string line = text.substr(0, std::min({text.find('\n'), text.size(), kLongest}));
    std::ranges::replace_if(
        line, [](char letter) { return static_cast<unsigned char>(letter) < 32; }, '?');
    return line;
}

std::optional<Error> cannotOpen(const std::filesystem::path& file) {
    std::error_code fault;
    const std::filesystem::file_status status = std::filesystem::status(file, fault);
    const auto because = [&](ErrorCode code, const char* reason) {
        return Error{code, "Cannot read \"" + file.string() + "\": " + reason + "."};
    };
    if (!std::filesystem::exists(status)) return because(ErrorCode::NotFound, "No such file or directory");
    if (std::filesystem::is_directory(status)) return because(ErrorCode::Io, "Is a directory");
    if (!std::filesystem::is_regular_file(status)) return because(ErrorCode::Io, "It is no file");
    if (!std::ifstream(file)) return because(ErrorCode::Io, "Permission denied");
    return std::nullopt;
}

/// Why there is no mesh, where the child did not end well.
std::optional<Error> faultOf(const ChildOutcome& outcome, const std::string& name) {
    switch (outcome.end) {
        case ChildEnd::Crashed:
            return Error{ErrorCode::Unsupported, name + " crashed the mesh reader; the file is damaged."};
        case ChildEnd::TimedOut:
            return Error{ErrorCode::Limit,
                         name + " takes the mesh reader longer than 10 s; it is too large or damaged."};
        case ChildEnd::TooMuchOutput: return Error{ErrorCode::Limit, name + " holds too large a mesh."};
        case ChildEnd::Exited: break;
    }
    if (outcome.exitCode == kOutOfMemory)
        return Error{ErrorCode::Limit, name + " needs more than 1 GiB to be read; it is too large or damaged."};
    const std::string said = firstLine(outcome.error);
    if (outcome.exitCode == kRefused && !said.empty()) return Error{ErrorCode::Unsupported, said};
    if (outcome.exitCode != 0)
        return Error{ErrorCode::Unsupported,
                     name + " made the mesh reader fail with exit status " + std::to_string(outcome.exitCode) + "."};
    return std::nullopt;
}

}  // namespace

std::filesystem::path importerBeside(const std::filesystem::path& programFolder) {
    const std::filesystem::path beside = programFolder / "rubble-importer";
    std::error_code ignored;
    return std::filesystem::exists(beside, ignored) ? beside : programFolder / "../libexec/rubble/rubble-importer";
}

Result<SourceScene> importMesh(const std::filesystem::path& file, const std::filesystem::path& importer,
                               const TaskContext& context) {
    if (std::optional<Error> fault = cannotOpen(file)) return *fault;
    std::error_code ignored;
    const std::string path = std::filesystem::absolute(file, ignored).string();
    const Result<ChildOutcome> outcome = runChild(importer, {path}, {}, context);
    if (!outcome) return outcome.error();
    const std::string name = quotedName(file);
    if (std::optional<Error> fault = faultOf(*outcome, name)) return *fault;
    Result<SourceScene> scene = readSourceScene(outcome->output);
    if (!scene) return Error{ErrorCode::Unsupported, name + " made the mesh reader give an answer that is no mesh."};
    return scene;
}

}  // namespace rubble
