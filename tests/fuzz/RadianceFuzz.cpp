#include "tests/fuzz/FuzzTarget.h"

/// Pictures of skies.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::radianceFault, data, size);
}
