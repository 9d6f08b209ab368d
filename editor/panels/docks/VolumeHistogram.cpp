#include "editor/panels/docks/VolumeHistogram.h"

#include "editor/widgets/AccessibleRole.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr int kHistogramMargin = 8;  // pixels, as all here
constexpr double kBarWidth = 9.0;    // approximately
constexpr int kMaxBars = 40;
constexpr double kMinBarHeight = 2.0;  // of a bar that is not empty

}  // namespace

VolumeHistogram::VolumeHistogram(QWidget* parent) : QWidget(parent), m_axisButton(new QToolButton(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Volume Histogram"));
    setAccessibleRole(*this, QAccessible::Chart);
    setStatusTip(tr("Click a bar, or drag over several, to select the fragments with these volumes"));
    m_axisButton->setObjectName("histogram-axis");
    connect(m_axisButton, &QToolButton::clicked, this,
            [this] { setAxis(m_axis == HistogramAxis::Linear ? HistogramAxis::Logarithmic : HistogramAxis::Linear); });
    m_axisButton->setToolTip(tr("Switch between a linear and a logarithmic axis"));
    setAxis(m_axis);
}

void VolumeHistogram::setVolumes(std::vector<double> volumes, std::vector<bool> isSelected) {
    m_volumes = std::move(volumes);
    m_isSelected = std::move(isSelected);
    updateBars();
}

void VolumeHistogram::setUnits(const Units& units) {
    m_units = units;
    updateBars();
}

void VolumeHistogram::setAxis(HistogramAxis axis) {
    m_axis = axis;
    m_axisButton->setText(axis == HistogramAxis::Linear ? tr("Linear") : tr("Logarithmic"));
    m_axisButton->setAccessibleName(tr("Axis: %1").arg(m_axisButton->text()));
    m_range.reset();
    m_axisButton->adjustSize();
    placeAxisButton();
    updateBars();
}

void VolumeHistogram::placeAxisButton() {
    m_axisButton->move(width() - m_axisButton->width() - kHistogramMargin, kHistogramMargin / 2);
}

void VolumeHistogram::updateBars() {
    const int bars = std::clamp(static_cast<int>(plotRect().width() / kBarWidth), 1, kMaxBars);
    m_bars = histogramOf(m_volumes, m_isSelected, bars, m_axis);
    if (m_range && m_range->to >= static_cast<int>(m_bars.size())) m_range.reset();
    setAccessibleDescription(m_bars.empty()
                                 ? QString()
                                 : tr("%Ln fragment(s) from %1 to %2", nullptr, static_cast<int>(m_volumes.size()))
                                       .arg(volume(m_bars.front().min), volume(m_bars.back().max)));
    update();
}

QRectF VolumeHistogram::plotRect() const {
    const int line = fontMetrics().height();
    return QRectF(rect()).adjusted(kHistogramMargin, line + 2 * kHistogramMargin, -kHistogramMargin,
                                   -line - kHistogramMargin);
}

QRectF VolumeHistogram::barRect(int bar) const {
    const QRectF all = plotRect();
    const double width = all.width() / static_cast<double>(std::max<std::size_t>(m_bars.size(), 1));
    return {all.left() + bar * width, all.top(), width, all.height()};
}

int VolumeHistogram::barAt(double x) const {
    const double fraction = (x - plotRect().left()) / plotRect().width();
    return std::clamp(static_cast<int>(fraction * static_cast<double>(m_bars.size())), 0,
                      static_cast<int>(m_bars.size()) - 1);
}

/// A volume in the unit that suits the largest one.
QString VolumeHistogram::volume(double value) const {
    const double largest = m_bars.empty() ? value : m_bars.back().max;
    return roundedQuantity(value, quantityFormat(QuantityKind::Volume, largest, m_units));
}

void VolumeHistogram::selectRange(bool isExtending) {
    const auto [first, last] = std::minmax(m_range->from, m_range->to);
    const bool isAtEnd = last + 1 == static_cast<int>(m_bars.size());
    const double end = m_bars[static_cast<std::size_t>(last)].max;
    emit rangeSelected(m_bars[static_cast<std::size_t>(first)].min, isAtEnd ? end : std::nextafter(end, 0.0),
                       isExtending);
    update();
}

void VolumeHistogram::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_bars.empty()) return;
    const int bar = barAt(event->position().x());
    m_range = {bar, bar};
    m_isDragging = true;
    update();
}

void VolumeHistogram::mouseMoveEvent(QMouseEvent* event) {
    if (!m_isDragging || m_bars.empty()) return;
    m_range->to = barAt(event->position().x());
    update();
}

void VolumeHistogram::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_isDragging || event->button() != Qt::LeftButton) return;
    m_isDragging = false;
    if (m_range) selectRange(event->modifiers().testFlag(Qt::ControlModifier));
}

void VolumeHistogram::keyPressEvent(QKeyEvent* event) {
    const int by = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (by == 0 || m_bars.empty()) return QWidget::keyPressEvent(event);
    const int last = static_cast<int>(m_bars.size()) - 1;
    Range range = m_range.value_or(Range{by > 0 ? -1 : last + 1, by > 0 ? -1 : last + 1});
    range.to = std::clamp(range.to + by, 0, last);
    if (!event->modifiers().testFlag(Qt::ShiftModifier)) range.from = range.to;
    m_range = range;
    selectRange(false);
}

bool VolumeHistogram::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || m_bars.empty()) return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const HistogramBar& bar = m_bars[static_cast<std::size_t>(barAt(help->pos().x()))];
    QString text =
        tr("%1 to %2: %Ln fragment(s)", nullptr, static_cast<int>(bar.count)).arg(volume(bar.min), volume(bar.max));
    if (bar.selected > 0) text += tr(", %L1 selected").arg(bar.selected);
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

void VolumeHistogram::resizeEvent(QResizeEvent*) {
    placeAxisButton();
    m_range.reset();
    updateBars();
}

void VolumeHistogram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    paintTexts(painter);
    if (!m_bars.empty()) paintBars(painter);
}

void VolumeHistogram::paintBars(QPainter& painter) const {
    const std::uint32_t highest = std::ranges::max_element(m_bars, {}, &HistogramBar::count)->count;
    QColor plain = palette().color(QPalette::Text);
    plain.setAlphaF(0.35f);
    for (int k = 0; k < static_cast<int>(m_bars.size()); ++k) {
        const HistogramBar& bar = m_bars[static_cast<std::size_t>(k)];
        const QRectF place = barRect(k);
        const bool isDraggedOver =
            m_isDragging && k >= std::min(m_range->from, m_range->to) && k <= std::max(m_range->from, m_range->to);
        if (isDraggedOver) {
            QColor wash = palette().color(QPalette::Highlight);
            wash.setAlphaF(0.2f);
            painter.fillRect(place, wash);
        }
        if (bar.count == 0) continue;
        const auto heightOf = [&](std::uint32_t count) {
            return count == 0 ? 0.0 : std::max(place.height() * count / highest, kMinBarHeight);
        };
        QRectF column = place.adjusted(0.5, 0.0, -0.5, 0.0);
        column.setTop(place.bottom() - heightOf(bar.count));
        painter.fillRect(column, plain);
        column.setTop(place.bottom() - heightOf(bar.selected));
        painter.fillRect(column, palette().color(QPalette::Highlight));
    }
    painter.setPen(plain);
    painter.drawLine(plotRect().bottomLeft(), plotRect().bottomRight());
}

void VolumeHistogram::paintTexts(QPainter& painter) const {
    painter.setPen(palette().color(QPalette::Text));
    const QRect head(kHistogramMargin, m_axisButton->y(), m_axisButton->x() - 2 * kHistogramMargin,
                     m_axisButton->height());
    painter.drawText(head, Qt::AlignVCenter | Qt::AlignLeft,
                     fontMetrics().elidedText(tr("By volume"), Qt::ElideRight, head.width()));
    if (m_bars.empty()) return;
    const QRect foot(kHistogramMargin, static_cast<int>(plotRect().bottom()) + 3, width() - 2 * kHistogramMargin,
                     fontMetrics().height());
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignTop, volume(m_bars.front().min));
    if (m_bars.size() > 1) painter.drawText(foot, Qt::AlignRight | Qt::AlignTop, volume(m_bars.back().max));
}

}  // namespace rubble

#include "moc_VolumeHistogram.cpp"
