#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// SIMD arithmetic on W floats. Everything here is a template of W, so that the linker never merges code compiled for
// wider machines with code compiled for narrower ones. Each lane gets the bits of the scalar code.

namespace rubble {

template <int W>
struct Lane {
    typedef float Float __attribute__((vector_size(W * sizeof(float))));
    typedef std::int32_t Mask __attribute__((vector_size(W * sizeof(float))));  // all bits of a lane, or none
};

template <int W>
using Floats = typename Lane<W>::Float;
template <int W>
using Masks = typename Lane<W>::Mask;

template <int W>
inline Floats<W> all(float value) {
    return Floats<W>{} + value;
}
template <int W>
inline Floats<W> loaded(const float* from) {
    Floats<W> result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}
template <int W>
inline void store(Floats<W> value, float* to) {
    __builtin_memcpy(to, &value, sizeof value);
}
template <int W>
inline Floats<W> select(Masks<W> mask, Floats<W> yes, Floats<W> no) {
    return mask ? yes : no;
}
template <int W>
inline Floats<W> greater(Floats<W> a, Floats<W> b) {
    return a > b ? a : b;
}
template <int W>
inline Floats<W> lesser(Floats<W> a, Floats<W> b) {
    return a < b ? a : b;
}
/// One bit per lane.
template <int W>
inline unsigned bitsOf(Masks<W> mask) {
#if defined(__AVX2__)
    if constexpr (W == 8) return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#endif
#if defined(__SSE2__)
    if constexpr (W == 4) return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#endif
    unsigned bits = 0;
    for (int lane = 0; lane < W; ++lane) bits |= mask[lane] != 0 ? 1u << lane : 0u;
    return bits;
}
template <int W>
inline Floats<W> squareRoot(Floats<W> value) {
#if defined(__AVX2__)
    if constexpr (W == 8) return reinterpret_cast<Floats<W>>(_mm256_sqrt_ps(reinterpret_cast<__m256>(value)));
#endif
#if defined(__SSE2__)
    if constexpr (W == 4) return reinterpret_cast<Floats<W>>(_mm_sqrt_ps(reinterpret_cast<__m128>(value)));
#endif
    Floats<W> result;
    for (int lane = 0; lane < W; ++lane) result[lane] = __builtin_sqrtf(value[lane]);
    return result;
}
/// 1 / value where value > 0, otherwise 0.
template <int W>
inline Floats<W> inverseOrZero(Floats<W> value) {
    const Masks<W> positive = value > Floats<W>{};
    return select<W>(positive, 1.0f / select<W>(positive, value, all<W>(1.0f)), Floats<W>{});
}

/// Transposes a W x W matrix in place.
template <int W>
inline void transpose(Floats<W>* row) {
    if constexpr (W == 4) {
        const Floats<W> a = __builtin_shufflevector(row[0], row[1], 0, 4, 1, 5);
        const Floats<W> b = __builtin_shufflevector(row[0], row[1], 2, 6, 3, 7);
        const Floats<W> c = __builtin_shufflevector(row[2], row[3], 0, 4, 1, 5);
        const Floats<W> d = __builtin_shufflevector(row[2], row[3], 2, 6, 3, 7);
        row[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
        row[1] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
        row[2] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
        row[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
    } else if constexpr (W == 8) {
        Floats<W> pair[8], four[8];
        for (int i = 0; i < 8; i += 2) {
            pair[i] = __builtin_shufflevector(row[i], row[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
            pair[i + 1] = __builtin_shufflevector(row[i], row[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
        }
        for (int i = 0; i < 8; i += 4) {
            four[i] = __builtin_shufflevector(pair[i], pair[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            four[i + 1] = __builtin_shufflevector(pair[i], pair[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
            four[i + 2] = __builtin_shufflevector(pair[i + 1], pair[i + 3], 0, 1, 8, 9, 4, 5, 12, 13);
            four[i + 3] = __builtin_shufflevector(pair[i + 1], pair[i + 3], 2, 3, 10, 11, 6, 7, 14, 15);
        }
        for (int i = 0; i < 4; ++i) {
            row[i] = __builtin_shufflevector(four[i], four[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
            row[i + 4] = __builtin_shufflevector(four[i], four[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
        }
    }
}

template <int W>
struct WideVec3 {
    Floats<W> x, y, z;

    WideVec3 operator+(const WideVec3& b) const { return {x + b.x, y + b.y, z + b.z}; }
    WideVec3 operator-(const WideVec3& b) const { return {x - b.x, y - b.y, z - b.z}; }
    WideVec3 operator*(Floats<W> s) const { return {x * s, y * s, z * s}; }
};

template <int W>
inline Floats<W> dot(const WideVec3<W>& a, const WideVec3<W>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <int W>
inline WideVec3<W> cross(const WideVec3<W>& a, const WideVec3<W>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A symmetric matrix.
template <int W>
struct WideSym3 {
    Floats<W> xx, xy, xz, yy, yz, zz;

    WideVec3<W> operator*(const WideVec3<W>& v) const {
        return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
    }
};

template <int W>
struct WideQuat {
    Floats<W> x, y, z, w;

    WideVec3<W> vector() const { return {x, y, z}; }
    WideQuat conjugate() const { return {-x, -y, -z, w}; }
    WideQuat operator*(const WideQuat& b) const {
        return {w * b.x + x * b.w + y * b.z - z * b.y, w * b.y - x * b.z + y * b.w + z * b.x,
                w * b.z + x * b.y - y * b.x + z * b.w, w * b.w - x * b.x - y * b.y - z * b.z};
    }
};

template <int W>
inline WideVec3<W> rotated(const WideQuat<W>& q, const WideVec3<W>& v) {
    const WideVec3<W> t = cross<W>(q.vector(), v);
    const WideVec3<W> twice = t + t;
    return v + twice * q.w + cross<W>(q.vector(), twice);
}

}  // namespace rubble
