#pragma once

#include <array>
#include <cmath>

namespace rubble {

/// An exact number as a sum of nonoverlapping doubles (an expansion), smallest first, without zeros. Sums, differences
/// and products are exact unless an intermediate value overflows or underflows: see kMinMagnitude in Predicates.h.
/// `Capacity` is the maximum number of terms. Allocates nothing.
///
/// Source: Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997; Dekker 1971; Knuth, TAOCP 2.
template <int Capacity>
struct Expansion {
    std::array<double, Capacity> terms;  // the first `count` are set
    int count = 0;

    /// The sign: -1, 0 or +1.
    int sign() const { return count == 0 ? 0 : (terms[count - 1] > 0.0 ? 1 : -1); }
    /// The value rounded, with an error of at most 1 ulp.
    double estimate() const {
        double sum = 0.0;
        for (int i = 0; i < count; ++i) sum += terms[i];
        return sum;
    }
    void append(double term) {
        if (term != 0.0) terms[count++] = term;
    }
};

/// Represents a + b = sum + error exactly.
struct SumAndError {
    double sum;
    double error;
};
inline SumAndError twoSum(double a, double b) {
    const double sum = a + b;
    const double bVirtual = sum - a;
    return {sum, (a - (sum - bVirtual)) + (b - bVirtual)};
}
/// Computes a * b = sum + error exactly.
inline SumAndError twoProduct(double a, double b) {
    constexpr double kSplitter = 134217729.0;  // 2^27 + 1: splits the 53 bits of a double in halves
    const double product = a * b;
    const double aBig = kSplitter * a, aHigh = aBig - (aBig - a), aLow = a - aHigh;
    const double bBig = kSplitter * b, bHigh = bBig - (bBig - b), bLow = b - bHigh;
    return {product, aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow)};
}

inline Expansion<1> exactly(double value) {
    Expansion<1> result;
    result.append(value);
    return result;
}
/// The exact difference a - b.
inline Expansion<2> exactDifference(double a, double b) {
    const SumAndError difference = twoSum(a, -b);
    Expansion<2> result;
    result.append(difference.error);
    result.append(difference.sum);
    return result;
}

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& a, const Expansion<M>& b) {
    Expansion<N + M> result;
    int i = 0, j = 0;
    const auto smallest = [&] {
        if (j == b.count || (i < a.count && std::abs(a.terms[i]) < std::abs(b.terms[j]))) return a.terms[i++];
        return b.terms[j++];
    };
    if (a.count + b.count == 0) return result;
    double carried = smallest();
    while (i < a.count || j < b.count) {
        const SumAndError step = twoSum(carried, smallest());
        result.append(step.error);
        carried = step.sum;
    }
    result.append(carried);
    return result;
}

template <int N>
Expansion<N> operator-(Expansion<N> a) {
    for (int i = 0; i < a.count; ++i) a.terms[i] = -a.terms[i];
    return a;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& a, const Expansion<M>& b) {
    return a + -b;
}

/// The exact product a * factor.
template <int N>
Expansion<2 * N> scaled(const Expansion<N>& a, double factor) {
    Expansion<2 * N> result;
    if (a.count == 0 || factor == 0.0) return result;
    const SumAndError first = twoProduct(a.terms[0], factor);
    result.append(first.error);
    double carried = first.sum;
    for (int i = 1; i < a.count; ++i) {
        const SumAndError product = twoProduct(a.terms[i], factor);
        const SumAndError low = twoSum(carried, product.error);
        result.append(low.error);
        const SumAndError high = twoSum(product.sum, low.sum);
        result.append(high.error);
        carried = high.sum;
    }
    result.append(carried);
    return result;
}

template <int N, int M>
Expansion<2 * N * M> operator*(const Expansion<N>& a, const Expansion<M>& b) {
    if constexpr (M == 1) {
        return b.count == 0 ? Expansion<2 * N>{} : scaled(a, b.terms[0]);
    } else {
        // Sum of products with the terms of b, split in halves so that the sums stay balanced.
        Expansion<M / 2> low;
        Expansion<M - M / 2> high;
        for (int i = 0; i < b.count; ++i) {
            if (i < M / 2)
                low.append(b.terms[i]);
            else
                high.append(b.terms[i]);
        }
        return a * low + a * high;
    }
}

}  // namespace rubble
