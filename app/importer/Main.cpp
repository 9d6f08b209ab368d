#include "app/importer/MeshFile.h"
#include "app/importer/files/Descriptor.h"
#include "app/importer/files/Sandbox.h"

#include <fcntl.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>

namespace {

// Exit statuses; see core/io/mesh/MeshImport.cpp.
constexpr int kRejected = 1;
constexpr int kUsage = 2;
constexpr int kOutOfMemory = 3;

int reject(const std::string& message) {
    std::fprintf(stderr, "%s\n", message.c_str());
    return kRejected;
}

int write(const std::string& bytes) {
    const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    return isWritten && std::fflush(stdout) == 0 ? EXIT_SUCCESS : reject("The mesh cannot be written.");
}

/// Opens the mesh while that is still possible, enters the sandbox, and only then looks at the content.
int readAndWrite(const std::string& path, rubble::FileLog log) {
    rubble::Result<rubble::MeshPlace> place = rubble::openMesh(path);
    if (!place) return reject(place.error().message);
    const rubble::Sandbox sandbox = rubble::enterSandbox(place->folder->number());
    if (!sandbox.failure.empty()) return reject("\"" + place->name + "\" was not read: " + sandbox.failure + ".");
    const rubble::Result<rubble::SourceScene> scene = rubble::readMeshFile(std::move(*place), log);
    if (!scene) return reject(scene.error().message);
    return write(rubble::sourceSceneBytes(*scene));
}

/// Enters the sandbox of a mesh in the root folder and prints what the kernel supports of it.
int describeSandbox() {
    const rubble::Descriptor root(::open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return write(rubble::sandboxText(rubble::enterSandbox(root.number())));
}

}  // namespace

/// rubble-importer FILE writes the triangles of a mesh file as sourceSceneBytes() to standard output, or an error
/// message to standard error. Rubble starts it with limits on memory and time.
///
/// rubble-importer --log-files FILE also names each file that it opens or refuses to open on standard error.
/// rubble-importer --sandbox prints which parts of the sandbox this kernel supports.
int main(int argumentCount, char** arguments) {
    const bool isLogging = argumentCount == 3 && arguments[1] == std::string_view("--log-files");
    if (argumentCount != 2 && !isLogging) {
        std::fputs("usage: rubble-importer [--log-files] FILE | --sandbox\n", stderr);
        return kUsage;
    }
    // Libraries swallow bad_alloc; the calling process has to learn about it.
    std::set_new_handler([] { std::_Exit(kOutOfMemory); });
    try {
        if (argumentCount == 2 && arguments[1] == std::string_view("--sandbox")) return describeSandbox();
        return readAndWrite(arguments[argumentCount - 1], isLogging ? rubble::FileLog::On : rubble::FileLog::Off);
    } catch (const std::exception& error) {
        return reject(std::string("The mesh reader failed: ") + error.what() + ".");
    }
}
