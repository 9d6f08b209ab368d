#include "tests/fuzz/FuzzTarget.h"

/// The JSON of `rubble-cli fracture`, and every stage on accepted input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::fractureFault, data, size);
}
