#pragma once

#include "tests/support/files/FuzzedReaders.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace rubble::test {

/// Runs a check on bytes from libFuzzer and aborts if it returns a fault.
inline int fuzz(Sentence (*faultOf)(std::string_view), const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    if (const Sentence fault = faultOf(bytes)) {
        std::fprintf(stderr, "%s\n", fault->c_str());
        std::abort();
    }
    return 0;
}

}  // namespace rubble::test
