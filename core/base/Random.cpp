#include "core/base/Random.h"

#include "core/base/Assert.h"

#include <bit>

namespace rubble {

Random::Random(std::uint64_t seed) {
    for (std::uint64_t& word : m_state) {
        word = splitmix64(seed);
        seed += 0x9e3779b97f4a7c15u;
    }
}

std::uint64_t Random::next() {
    const std::uint64_t result = std::rotl(m_state[1] * 5, 7) * 9;
    const std::uint64_t shifted = m_state[1] << 17;
    m_state[2] ^= m_state[0];
    m_state[3] ^= m_state[1];
    m_state[1] ^= m_state[2];
    m_state[0] ^= m_state[3];
    m_state[2] ^= shifted;
    m_state[3] = std::rotl(m_state[3], 45);
    return result;
}

double Random::unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

double Random::between(double low, double high) {
    if (!(low < high)) return low;
    const double value = low + (high - low) * unit();
    return value < high ? value : low;  // the sum may round up to high
}

std::uint64_t Random::below(std::uint64_t count) {
    RUBBLE_ASSERT(count > 0);
    const std::uint64_t limit = ~std::uint64_t{0} - ~std::uint64_t{0} % count;
    std::uint64_t bits = next();
    while (bits >= limit) bits = next();
    return bits % count;
}

std::uint64_t splitmix64(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31);
}

std::uint64_t mixSeeds(std::uint64_t seed, std::uint64_t value) { return splitmix64(seed ^ splitmix64(value)); }

}  // namespace rubble
