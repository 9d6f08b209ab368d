#include "tests/fuzz/FuzzTarget.h"
#include "tests/support/files/PngChecksums.h"

/// Pictures of density layers, as rubble-cli reads them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = rubble::test::withPngChecksums(std::string(data, data + size));
    return rubble::test::fuzz(rubble::test::pngFault, reinterpret_cast<const std::uint8_t*>(bytes.data()), size);
}
