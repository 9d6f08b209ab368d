#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace rubble {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UnsignedInt128;

/// A signed integer of 64 · Words bits in two's complement. Sums, differences and products are exact where they fit:
/// the caller shows that they do. Allocates nothing; the same bits on every machine.
template <int Words>
struct WideInteger {
    std::array<std::uint64_t, Words> words{};  // lowest first

    WideInteger() = default;
    WideInteger(std::int64_t value) {
        words.fill(value < 0 ? ~std::uint64_t{0} : 0);
        words[0] = static_cast<std::uint64_t>(value);
    }
    WideInteger(Int128 value) {
        static_assert(Words >= 2);
        words.fill(value < 0 ? ~std::uint64_t{0} : 0);
        words[0] = static_cast<std::uint64_t>(value);
        words[1] = static_cast<std::uint64_t>(value >> 64);
    }
    /// The same number with more words.
    template <int Fewer>
    explicit WideInteger(const WideInteger<Fewer>& other) {
        static_assert(Fewer < Words);
        words.fill(other.isNegative() ? ~std::uint64_t{0} : 0);
        for (int k = 0; k < Fewer; ++k) words[k] = other.words[k];
    }

    bool isNegative() const { return static_cast<std::int64_t>(words[Words - 1]) < 0; }
    /// -1, 0 or +1.
    int sign() const {
        if (isNegative()) return -1;
        for (const std::uint64_t word : words) {
            if (word != 0) return 1;
        }
        return 0;
    }
    /// The nearest double or one beside it.
    double rounded() const {
        const WideInteger magnitude = isNegative() ? -*this : *this;
        double value = 0.0;
        int used = 0;
        for (int k = Words - 1; k >= 0 && used < 2; --k) {  // at least 65 bits count
            if (magnitude.words[k] == 0 && used == 0) continue;
            value += std::ldexp(static_cast<double>(magnitude.words[k]), 64 * k);
            ++used;
        }
        return isNegative() ? -value : value;
    }

    WideInteger operator-() const { return WideInteger(std::int64_t{0}) - *this; }
    friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
        WideInteger sum;
        UnsignedInt128 carry = 0;
        for (int k = 0; k < Words; ++k) {
            carry += UnsignedInt128{a.words[k]} + b.words[k];
            sum.words[k] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        return sum;
    }
    friend WideInteger operator-(const WideInteger& a, const WideInteger& b) {
        WideInteger difference;
        std::uint64_t borrow = 0;
        for (int k = 0; k < Words; ++k) {
            const UnsignedInt128 word = UnsignedInt128{a.words[k]} - b.words[k] - borrow;
            difference.words[k] = static_cast<std::uint64_t>(word);
            borrow = static_cast<std::uint64_t>(word >> 64) & 1;
        }
        return difference;
    }
    friend WideInteger operator*(const WideInteger& a, const WideInteger& b) {
        WideInteger product;
        for (int i = 0; i < Words; ++i) {
            if (a.words[i] == 0) continue;
            UnsignedInt128 carry = 0;
            for (int k = 0; i + k < Words; ++k) {
                carry += UnsignedInt128{a.words[i]} * b.words[k] + product.words[i + k];
                product.words[i + k] = static_cast<std::uint64_t>(carry);
                carry >>= 64;
            }
        }
        return product;
    }
    bool operator==(const WideInteger&) const = default;
};

}  // namespace rubble
