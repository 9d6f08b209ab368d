#include "tests/fuzz/FuzzTarget.h"

/// The pack.json of exported folders, and what verifies them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::packFault, data, size);
}
