#include "tests/fuzz/FuzzTarget.h"

/// What the importer's process returns, and the assets that are made of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::sourceSceneFault, data, size);
}
