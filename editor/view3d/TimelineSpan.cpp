#include "editor/view3d/TimelineSpan.h"

#include <algorithm>

namespace rubble {

TimelineSpan TimelineSpan::wholeOf(double length) {
    TimelineSpan span;
    span.m_length = length;
    return span;
}

void TimelineSpan::setLength(double steps) {
    m_length = steps;
    if (!m_isWhole) show(m_first, m_last - m_first);
}

void TimelineSpan::zoom(double step, double factor) {
    const double width = std::max(this->width() / factor, std::min(kLeast, whole()));
    show(step - (step - first()) * width / this->width(), width);
}

void TimelineSpan::pan(double steps) {
    if (!m_isWhole) show(m_first + steps, m_last - m_first);
}

void TimelineSpan::reveal(double step) {
    const double margin = 0.1 * width();
    pan(std::max(0.0, step + margin - last()) - std::max(0.0, first() - (step - margin)));
}

/// Shows `width` steps from the first on, moved into the timeline; all of it if it is not longer.
void TimelineSpan::show(double first, double width) {
    m_isWhole = width >= whole() * (1.0 - 1e-9);  // factors are rounded
    if (m_isWhole) return fit();
    m_first = std::clamp(first, 0.0, whole() - width);
    m_last = m_first + width;
}

}  // namespace rubble
