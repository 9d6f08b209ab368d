#include "tests/fuzz/FuzzTarget.h"

/// Lists of shots.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::shotsFault, data, size);
}
