#pragma once

#include "core/geometry/predicates/Vec.h"

#include <cmath>

namespace rubble {

/// Single-precision vectors of the simulation. Every operation is spelled out, so that all compilers give the same
/// bits.
using Vec3f = glm::vec3;

inline Vec3f toFloat(Vec3 v) {
    return Vec3f(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}
inline Vec3 toDouble(Vec3f v) { return Vec3(v.x, v.y, v.z); }

inline float dot(Vec3f a, Vec3f b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3f cross(Vec3f a, Vec3f b) {
    return Vec3f(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
inline float lengthSquared(Vec3f a) { return dot(a, a); }
inline float length(Vec3f a) { return std::sqrt(dot(a, a)); }
/// The unit vector along a; zero if a is shorter than 1e-20.
inline Vec3f normalized(Vec3f a) {
    const float size = length(a);
    return size > 1e-20f ? a * (1.0f / size) : Vec3f(0.0f);
}
/// The smaller, larger and absolute value of each component.
inline Vec3f componentMin(Vec3f a, Vec3f b) {
    return Vec3f(a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z);
}
inline Vec3f componentMax(Vec3f a, Vec3f b) {
    return Vec3f(a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z);
}
inline Vec3f componentAbs(Vec3f a) { return Vec3f(std::abs(a.x), std::abs(a.y), std::abs(a.z)); }

/// A rotation matrix, by columns.
struct Mat3f {
    Vec3f x{1.0f, 0.0f, 0.0f};
    Vec3f y{0.0f, 1.0f, 0.0f};
    Vec3f z{0.0f, 0.0f, 1.0f};

    Vec3f operator*(Vec3f v) const { return x * v.x + y * v.y + z * v.z; }
    /// The transposed matrix times v: for a rotation, its inverse.
    Vec3f transposedTimes(Vec3f v) const { return Vec3f(dot(x, v), dot(y, v), dot(z, v)); }
    Mat3f operator*(const Mat3f& m) const { return {*this * m.x, *this * m.y, *this * m.z}; }
    Mat3f transposed() const { return {Vec3f(x.x, y.x, z.x), Vec3f(x.y, y.y, z.y), Vec3f(x.z, y.z, z.z)}; }
};

/// A unit quaternion, scalar last.
struct Quatf {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;
    float w = 1.0f;

    Vec3f vector() const { return Vec3f(x, y, z); }
    Quatf conjugate() const { return {-x, -y, -z, w}; }
    Quatf operator*(const Quatf& b) const {
        return {w * b.x + x * b.w + y * b.z - z * b.y, w * b.y - x * b.z + y * b.w + z * b.x,
                w * b.z + x * b.y - y * b.x + z * b.w, w * b.w - x * b.x - y * b.y - z * b.z};
    }
    Quatf normalized() const {
        const float scale = 1.0f / std::sqrt(x * x + y * y + z * z + w * w);
        return {x * scale, y * scale, z * scale, w * scale};
    }
    Mat3f matrix() const {
        const float xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z;
        const float wx = w * x, wy = w * y, wz = w * z;
        return {Vec3f(1.0f - 2.0f * (yy + zz), 2.0f * (xy + wz), 2.0f * (xz - wy)),
                Vec3f(2.0f * (xy - wz), 1.0f - 2.0f * (xx + zz), 2.0f * (yz + wx)),
                Vec3f(2.0f * (xz + wy), 2.0f * (yz - wx), 1.0f - 2.0f * (xx + yy))};
    }
};

/// A symmetric 3 x 3 matrix, such as an inertia tensor.
struct SymMat3f {
    float xx = 0.0f;
    float xy = 0.0f;
    float xz = 0.0f;
    float yy = 0.0f;
    float yz = 0.0f;
    float zz = 0.0f;

    Vec3f operator*(Vec3f v) const {
        return Vec3f(xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z);
    }
};

/// The quaternion in single precision, of length 1 there.
inline Quatf toFloat(const Quat& q) {
    return Quatf{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)}
        .normalized();
}
inline Quat toDouble(const Quatf& q) { return Quat(q.w, q.x, q.y, q.z); }
/// A symmetric matrix in single precision.
inline SymMat3f toFloat(const Mat3& symmetric) {
    const auto at = [&](int column, int row) { return static_cast<float>(symmetric[column][row]); };
    return {at(0, 0), at(1, 0), at(2, 0), at(1, 1), at(2, 1), at(2, 2)};
}

/// The tensor in rotated axes: R m R^T.
inline SymMat3f rotated(const SymMat3f& m, const Mat3f& r) {
    const Vec3f a = r * (m * Vec3f(r.x.x, r.y.x, r.z.x));  // R m, times the rows of R
    const Vec3f b = r * (m * Vec3f(r.x.y, r.y.y, r.z.y));
    const Vec3f c = r * (m * Vec3f(r.x.z, r.y.z, r.z.z));
    return {a.x, a.y, a.z, b.y, b.z, c.z};
}

}  // namespace rubble
