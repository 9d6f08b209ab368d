#include "core/io/project/ProjectIdentity.h"

#include "core/base/Hash.h"

#include <random>

namespace rubble {

std::string newIdentity() {
    std::random_device device;
    const auto word = [&] { return (std::uint64_t{device()} << 32) | device(); };
    ContentHash bits;
    bits.high = word();
    bits.low = word();
    return bits.hex();
}

}  // namespace rubble
