#include "core/io/mesh/MeshImport.h"

#include "core/base/MessageText.h"
#include "core/base/Utf8.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>

namespace rubble {
namespace {

// Exit statuses of rubble-importer; see app/importer/Main.cpp.
constexpr int kRejected = 1;
constexpr int kOutOfMemory = 3;

constexpr const char* kImporter = "rubble-importer";
constexpr const char* kInstalledFolder = "/usr/libexec/rubble";

/// An STL file of the 2,000,000 triangles that are allowed takes 0.9 GiB, with the program and its libraries 1.4 GiB of
/// address space, and 5 s on an idle machine. The importer writes no file and opens few: its libraries, the mesh and
/// the files to which that refers.
constexpr ChildLimits kImporterLimits{.memory = std::size_t{2} << 30,
                                      .seconds = 30.0,
                                      .fileSize = 0,
                                      .descriptors = 64,
                                      .environment = ChildEnvironment::Empty};

/// Returns the first line of the child's standard error in UTF-8, shortened, without control characters.
std::string firstLine(const std::string& text) {
    constexpr std::size_t kMaxLength = 1000;
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string line = text.substr(0, std::min(length, kMaxLength));
    const bool isText = isUtf8(std::string_view(text).substr(0, length));
    while (isText && !isUtf8(line)) line.pop_back();  // half a character
    std::ranges::replace_if(
        line, [=](unsigned char letter) { return letter < 0x20 || (letter >= 0x7f && !isText); }, '?');
    return length > kMaxLength ? line + "..." : line;
}

std::optional<Error> cannotOpen(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    const auto error = [&](ErrorCode code, const char* reason) {
        return Error{code, "Cannot read " + quotedPath(file) + ": " + reason + "."};
    };
    if (!std::filesystem::exists(status)) return error(ErrorCode::NotFound, "No such file or directory");
    if (std::filesystem::is_directory(status)) return error(ErrorCode::Io, "Is a directory");
    if (!std::filesystem::is_regular_file(status)) return error(ErrorCode::Io, "Not a file");
    if (!std::ifstream(file)) return error(ErrorCode::Io, "Permission denied");
    return std::nullopt;
}

/// Returns the error if the importer failed.
std::optional<Error> importerError(const ChildResult& outcome, const std::string& name) {
    switch (outcome.exit) {
        case ChildExit::Crashed:
            return Error{ErrorCode::Unsupported, "The importer crashed while reading " + name + " (signal " +
                                                     std::to_string(outcome.signal) +
                                                     "). The file may be damaged or not supported by the reader."};
        case ChildExit::TimedOut:
            return Error{ErrorCode::Limit, name + " takes longer than 30 s to read; it is too large or damaged."};
        case ChildExit::TooMuchOutput: return Error{ErrorCode::Limit, "The mesh in " + name + " is too large."};
        case ChildExit::Exited: break;
    }
    if (outcome.exitCode == kOutOfMemory)
        return Error{ErrorCode::Limit, name + " needs more than 2 GiB of memory; it is too large or damaged."};
    const std::string message = firstLine(outcome.error);
    if (outcome.exitCode == kRejected && !message.empty()) return Error{ErrorCode::Unsupported, message};
    if (outcome.exitCode != 0)
        return Error{ErrorCode::Unsupported, name + " cannot be read: the mesh reader failed with exit status " +
                                                 std::to_string(outcome.exitCode) + "."};
    return std::nullopt;
}

}  // namespace

std::filesystem::path importerPath(const std::filesystem::path& programFolder) {
    if (programFolder.empty()) return std::filesystem::path(kInstalledFolder) / kImporter;
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::absolute(programFolder, ignored);
    const std::filesystem::path beside = folder / kImporter;
    if (std::filesystem::exists(beside, ignored)) return beside;
    return (folder / "../libexec/rubble" / kImporter).lexically_normal();
}

Result<SourceScene> importMesh(const std::filesystem::path& file, const std::filesystem::path& importer,
                               const TaskContext& context) {
    if (std::optional<Error> error = cannotOpen(file)) return *error;
    if (!importer.is_absolute())  // would be looked for in the current folder
        return Error{ErrorCode::Io, "Cannot start " + quotedPath(importer) + ": its folder is unknown."};
    std::error_code ignored;
    const std::string path = std::filesystem::absolute(file, ignored).string();
    const Result<ChildResult> outcome = runChild(importer, {path}, kImporterLimits, context);
    if (!outcome) return outcome.error();
    return importedMesh(*outcome, file);
}

ChildLimits importerLimits() { return kImporterLimits; }

Result<SourceScene> importedMesh(const ChildResult& outcome, const std::filesystem::path& file) {
    const std::string name = quotedName(file.filename().native());
    if (std::optional<Error> error = importerError(outcome, name)) return *error;
    Result<SourceScene> scene = readSourceScene(outcome.output);
    if (!scene) return Error{ErrorCode::Unsupported, name + " cannot be read: the mesh reader returned invalid data."};
    return scene;
}

}  // namespace rubble
