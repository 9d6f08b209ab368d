#pragma once

#include "core/fracture/BrickBond.h"

#include <array>
#include <cstdint>

namespace rubble {

/// Where the cells of a bond lie: courses of one height, and in each the same two cells in turns.
class BrickCourses {
public:
    /// Courses and columns are told apart as far as this from the origin.
    static constexpr int kMost = 5000;

    explicit BrickCourses(const BrickBond& bond);

    /// The joint below a course, and the one to the left of a column, m.
    double bottom(int course) const { return m_origin.y + course * m_rise; }
    double left(int course, int column) const;
    /// The course at a height, and the column at a place in a course; at most one beyond kMost.
    int courseAt(double y) const;
    int columnAt(int course, double x) const;
    /// How many metres are too little to tell joints above each other apart.
    double finest() const { return m_finest; }

    /// The number of a cell: the same pair has the same one in all walls, and none is as high as 2^31.
    static std::uint32_t cellIndex(int course, int column);

private:
    struct Course {
        double start = 0.0;           // m: of column 0, from the origin
        std::array<double, 2> cells;  // m: how long even and odd columns are
    };
    const Course& courseOf(int number) const { return m_courses[static_cast<std::size_t>(number & 1)]; }

    Vec2 m_origin;
    double m_rise;
    double m_finest;
    std::array<Course, 2> m_courses;  // even and odd ones
};

}  // namespace rubble
