#include "tests/fuzz/FuzzTarget.h"

/// Files of the library of materials.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::materialFault, data, size);
}
