#include "app/importer/MeshFile.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

namespace {

/// What the program that started this one tells faults apart by.
constexpr int kRefused = 1;
constexpr int kUsage = 2;
constexpr int kOutOfMemory = 3;

int refuse(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    return kRefused;
}

int readAndWrite(const std::string& path) {
    const rubble::Result<rubble::SourceScene> scene = rubble::readMeshFile(path);
    if (!scene) return refuse(scene.error().message);
    const std::string bytes = rubble::sourceSceneBytes(*scene);
    const bool isWritten = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
    return isWritten && std::fflush(stdout) == 0 ? EXIT_SUCCESS : refuse("The mesh cannot be written.");
}

}  // namespace

/// rubble-importer FILE: a mesh file's triangles as sourceSceneBytes() on standard output, or one sentence on standard
/// error. Started by rubble with limits on memory and time.
int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) {
        std::fputs("usage: rubble-importer FILE\n", stderr);
        return kUsage;
    }
    // Libraries swallow bad_alloc; the one who waits for us must hear of it.
    std::set_new_handler([] { std::_Exit(kOutOfMemory); });
    try {
        return readAndWrite(arguments[1]);
    } catch (const std::exception& fault) {
        return refuse(std::string("The mesh reader failed: ") + fault.what() + ".");
    }
}
