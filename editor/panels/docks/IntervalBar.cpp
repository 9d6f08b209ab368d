#include "editor/panels/docks/IntervalBar.h"

#include "editor/widgets/AccessibleRole.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr int kBarMargin = 8;
constexpr int kBarHeight = 14;
constexpr double kScaleMargin = 1.6;  // factor
const QColor kFits(46, 158, 91), kSurvives(0, 114, 178), kBreaks(213, 94, 0);

}  // namespace

IntervalBar::IntervalBar(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Valid thresholds"));
    setAccessibleRole(*this, QAccessible::Graphic);
    setToolTip(
        tr("Green: thresholds that meet all requirements. Blue lines: impulses it must survive. Orange lines: impulses "
           "it must break by. Triangle: the threshold of the asset"));
}

QSize IntervalBar::sizeHint() const { return {240, kBarHeight + 2 * fontMetrics().height() + 18}; }

void IntervalBar::setInterval(const std::vector<StrengthRequirement>& requirements, const ThresholdInterval& interval,
                              double threshold) {
    m_requirements = requirements;
    m_interval = interval;
    m_threshold = threshold;
    m_from = m_to = threshold;
    for (const double impulse : interval.impulses) {
        if (impulse <= 0.0) continue;
        m_from = std::min(m_from, impulse);
        m_to = std::max(m_to, impulse);
    }
    m_from /= kScaleMargin;
    m_to *= kScaleMargin;
    setAccessibleDescription(QString::fromStdString(intervalText(interval)));
    update();
}

double IntervalBar::positionOf(double impulse) const {
    const double fraction = std::log(std::clamp(impulse, m_from, m_to) / m_from) / std::log(m_to / m_from);
    return kBarMargin + fraction * (width() - 2.0 * kBarMargin);
}

void IntervalBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int line = fontMetrics().height();
    const QRectF bar(kBarMargin, line + 8, width() - 2 * kBarMargin, kBarHeight);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(bar, 3, 3);
    if (!m_interval.isEmpty()) {
        const double left = m_interval.low > 0.0 ? positionOf(m_interval.low) : bar.left();
        const double right = std::isfinite(m_interval.high) ? positionOf(m_interval.high) : bar.right();
        painter.setPen(Qt::NoPen);
        painter.setBrush(kFits);
        painter.drawRoundedRect(QRectF(left, bar.top() + 2, right - left, kBarHeight - 4), 2, 2);
    }
    for (std::size_t k = 0; k < m_interval.impulses.size() && k < m_requirements.size(); ++k) {
        painter.setPen(QPen(m_requirements[k].outcome == RequirementOutcome::Breaks ? kBreaks : kSurvives, 2));
        const double x = positionOf(m_interval.impulses[k]);
        painter.drawLine(QPointF(x, bar.top() - 3), QPointF(x, bar.bottom() + 3));
    }
    const double x = positionOf(m_threshold);
    QPainterPath triangle(QPointF(x, bar.top() - 1));
    triangle.lineTo(x - 5, bar.top() - 9);
    triangle.lineTo(x + 5, bar.top() - 9);
    triangle.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawPath(triangle);
    painter.setPen(palette().color(QPalette::WindowText));
    const QString text = QString::fromStdString(impulseText(m_threshold));
    const int half = fontMetrics().horizontalAdvance(text) / 2 + 2;
    const int middle = std::clamp(static_cast<int>(x), half, std::max(half, width() - half));
    painter.drawText(QRect(middle - half, 0, 2 * half, line), Qt::AlignCenter, text);
    const QRect below(kBarMargin, static_cast<int>(bar.bottom()) + 4, width() - 2 * kBarMargin, line);
    painter.drawText(below, Qt::AlignLeft, QString::fromStdString(impulseText(m_from)));
    painter.drawText(below, Qt::AlignRight, QString::fromStdString(impulseText(m_to)));
}

}  // namespace rubble

#include "moc_IntervalBar.cpp"
