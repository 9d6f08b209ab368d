#pragma once

namespace rubble {

/// The visible part of a timeline, in steps. It is the whole timeline, also while that grows, until it is zoomed.
class TimelineSpan {
public:
    double first() const { return m_first; }
    double last() const { return m_isWhole ? whole() : m_last; }
    double width() const { return last() - first(); }
    bool isWhole() const { return m_isWhole; }
    bool contains(double step) const { return step >= first() && step <= last(); }

    /// Sets the length of the timeline.
    void setLength(double steps);
    /// Enlarges by a factor about a step, which keeps its place; never beyond the whole nor below kLeast steps.
    void zoom(double step, double factor);
    /// Moves the visible part by some steps, within the timeline.
    void pan(double steps);
    /// Shows the whole.
    void fit() { *this = wholeOf(m_length); }
    /// Pans as little as it takes to show a step with a tenth of the width around it.
    void reveal(double step);

    static constexpr double kLeast = 12.0;

private:
    static TimelineSpan wholeOf(double length);
    double whole() const { return m_length < 1.0 ? 1.0 : m_length; }
    void show(double first, double width);

    double m_length = 0.0;
    double m_first = 0.0;
    double m_last = 0.0;
    bool m_isWhole = true;
};

}  // namespace rubble
