#pragma once

#include <cstdint>

namespace rubble {

/// A seeded random number generator, the same on every machine: xoshiro256**, its state initialized by splitmix64. Use
/// one generator per purpose, seeded by mixSeeds(): construction is cheap.
///
/// Source: Blackman, Vigna, "Scrambled linear pseudorandom number generators", 2021.
class Random {
public:
    explicit Random(std::uint64_t seed);

    /// 64 random bits.
    std::uint64_t next();
    /// Uniform in [0, 1), a multiple of 2^-53.
    double unit();
    /// Uniform in [low, high); low if high <= low.
    double between(double low, double high);
    /// Uniform in [0, count) without bias; count > 0.
    std::uint64_t below(std::uint64_t count);

private:
    std::uint64_t m_state[4];
};

/// One step of splitmix64: a bijective hash of 64 bits.
std::uint64_t splitmix64(std::uint64_t value);
/// The seed of a stream identified by two numbers, such as an asset's seed and a layer's id.
std::uint64_t mixSeeds(std::uint64_t seed, std::uint64_t value);

}  // namespace rubble
