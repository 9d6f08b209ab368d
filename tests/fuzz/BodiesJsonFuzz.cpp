#include "tests/fuzz/FuzzTarget.h"

/// The plain bodies of `rubble-cli simulate`, and some steps of what it accepts.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::bodiesFault, data, size);
}
