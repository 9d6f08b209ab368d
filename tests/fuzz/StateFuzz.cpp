#include "tests/fuzz/FuzzTarget.h"

/// The fields of states.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::stateFault, data, size);
}
