#include "app/importer/MeshFile.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

namespace {

// Exit statuses; see core/io/mesh/MeshImport.cpp.
constexpr int kRejected = 1;
constexpr int kUsage = 2;
constexpr int kOutOfMemory = 3;

int reject(const std::string& message) {
    std::fprintf(stderr, "%s\n", message.c_str());
    return kRejected;
}

int readAndWrite(const std::string& path) {
    const rubble::Result<rubble::SourceScene> scene = rubble::readMeshFile(path);
    if (!scene) return reject(scene.error().message);
    const std::string bytes = rubble::sourceSceneBytes(*scene);
    const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    return isWritten && std::fflush(stdout) == 0 ? EXIT_SUCCESS : reject("The mesh cannot be written.");
}

}  // namespace

/// rubble-importer FILE writes the triangles of a mesh file as sourceSceneBytes() to standard output, or an error
/// message to standard error. Rubble starts it with limits on memory and time.
int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) {
        std::fputs("usage: rubble-importer FILE\n", stderr);
        return kUsage;
    }
    // Libraries swallow bad_alloc; the calling process has to learn about it.
    std::set_new_handler([] { std::_Exit(kOutOfMemory); });
    try {
        return readAndWrite(arguments[1]);
    } catch (const std::exception& error) {
        return reject(std::string("The mesh reader failed: ") + error.what() + ".");
    }
}
