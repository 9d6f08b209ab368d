#include "tests/fuzz/FuzzTarget.h"

/// Replay files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return rubble::test::fuzz(rubble::test::replayFault, data, size);
}
