#pragma once

#include "core/fracture/kinds/BrickBond.h"

#include <array>
#include <cstdint>

namespace rubble {

/// The geometry of a bond: courses of equal height, each with two alternating cell widths.
class BrickCourses {
public:
    /// The maximum number of courses and columns in each direction from the origin.
    static constexpr int kMaxIndex = 5000;

    struct Course {
        double start = 0.0;           // m: of column 0, from the origin
        std::array<double, 2> cells;  // m: widths of even and odd columns
    };

    explicit BrickCourses(const BrickBond& bond);

    const Course& courseOf(int number) const { return m_courses[static_cast<std::size_t>(number & 1)]; }
    /// The y of the joint below a course and the x of the joint left of a column, m.
    double bottom(int course) const { return m_origin.y + course * m_rise; }
    double left(int course, int column) const;
    /// The course at y, and the column of a course at x; at most one beyond kMaxIndex.
    int courseAt(double y) const;
    int columnAt(int course, double x) const;
    /// The distance, in m, below which joints above each other coincide.
    double tolerance() const { return m_tolerance; }

    /// The index of a cell: independent of the wall, and below 2^31.
    static std::uint32_t cellIndex(int course, int column);

private:
    Vec2 m_origin;
    double m_rise;
    double m_tolerance;
    std::array<Course, 2> m_courses;  // even and odd
};

}  // namespace rubble
