#pragma once

#include "tests/support/FuzzedReaders.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace rubble::test {

/// Hands bytes of libFuzzer to a reader and stops where it finds something wrong.
inline int fuzz(Sentence (*faultOf)(std::string_view), const std::uint8_t* data, std::size_t size) {
    const std::string bytes(data, data + size);
    if (const Sentence fault = faultOf(bytes)) {
        std::fprintf(stderr, "%s\n", fault->c_str());
        std::abort();
    }
    return 0;
}

}  // namespace rubble::test
