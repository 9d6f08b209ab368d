#pragma once

#include <cstdint>

namespace rubble {

/// Seeded random numbers, the same on every machine: xoshiro256** with its state filled by
/// splitmix64. A stream is cheap to make; give each purpose its own by mixing its id into the seed.
///
/// Source: Blackman, Vigna, "Scrambled linear pseudorandom number generators", 2021.
class Random {
public:
    explicit Random(std::uint64_t seed);

    /// Sixty-four random bits.
    std::uint64_t next();
    /// Uniform in [0, 1), a multiple of 2^-53.
    double unit();
    /// Uniform in [low, high); low where high <= low.
    double between(double low, double high);
    /// Uniform in [0, count) without bias; count > 0.
    std::uint64_t below(std::uint64_t count);

private:
    std::uint64_t m_state[4];
};

/// One step of splitmix64: turns any number, small or patterned, into well-mixed bits.
std::uint64_t mixed(std::uint64_t value);
/// The seed of a stream named by two numbers: mixedWith(asset seed, layer id).
std::uint64_t mixedWith(std::uint64_t seed, std::uint64_t value);

}  // namespace rubble
