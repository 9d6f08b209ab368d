#include "core/fracture/kinds/BrickCourses.h"

#include "core/fracture/sampling/PairIndex.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kToleranceFraction = 1e-9;  // of the shortest cell

int clamped(double number) {
    return static_cast<int>(std::clamp(number, -BrickCourses::kMaxIndex - 1.0, BrickCourses::kMaxIndex + 1.0));
}

}  // namespace

BrickCourses::BrickCourses(const BrickBond& bond) : m_origin(bond.origin), m_rise(bond.height + bond.mortar) {
    const double stretcher = bond.length + bond.mortar, header = bond.width + bond.mortar;
    const Course stretchers{0.0, {stretcher, stretcher}}, headers{0.0, {header, header}};
    switch (bond.bond) {
        case BondKind::Stretcher: m_courses = {stretchers, Course{stretcher / 2.0, {stretcher, stretcher}}}; break;
        case BondKind::Stack: m_courses = {stretchers, stretchers}; break;
        case BondKind::English: m_courses = {stretchers, Course{header / 2.0, {header, header}}}; break;
        case BondKind::Header: m_courses = {headers, Course{header / 2.0, {header, header}}}; break;
        case BondKind::Flemish:
            m_courses = {Course{0.0, {stretcher, header}}, Course{(stretcher + header) / 2.0, {stretcher, header}}};
            break;
    }
    m_tolerance = kToleranceFraction * std::min(stretcher, header);
}

double BrickCourses::left(int course, int column) const {
    const Course& of = courseOf(course);
    const int pair = (column - (column & 1)) / 2;
    const double start = m_origin.x + of.start + pair * (of.cells[0] + of.cells[1]);
    return column & 1 ? start + of.cells[0] : start;
}

int BrickCourses::courseAt(double y) const { return clamped(std::floor((y - m_origin.y) / m_rise)); }

int BrickCourses::columnAt(int course, double x) const {
    const Course& of = courseOf(course);
    const double period = of.cells[0] + of.cells[1], from = x - m_origin.x - of.start;
    const double pair = std::floor(from / period);
    return clamped(2.0 * pair + (from - pair * period < of.cells[0] ? 0.0 : 1.0));
}

std::uint32_t BrickCourses::cellIndex(int course, int column) { return pairIndex(zigzag(column), zigzag(course)); }

}  // namespace rubble
