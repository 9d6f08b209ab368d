#include "editor/widgets/SliderField.h"

#include "editor/widgets/ProjectRange.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr int kTicks = 1000;           // positions of a slider
constexpr int kSliderDigits = 3;       // significant digits of the slider's values
constexpr double kMinThreshold = 1.0;  // N·s, what the slider of a threshold spans:
constexpr double kMaxThreshold = 1e5;  // from a flower pot to a wall

/// A slider that ignores the wheel unless it has the focus, and the mouse after its release.
class QuietSlider : public QSlider {
public:
    using QSlider::QSlider;

protected:
    void wheelEvent(QWheelEvent* event) override { hasFocus() ? QSlider::wheelEvent(event) : event->ignore(); }
    void mouseMoveEvent(QMouseEvent* event) override {
        isSliderDown() ? QSlider::mouseMoveEvent(event) : event->ignore();
    }
};

}  // namespace

SliderField::SliderField(const FieldRange& range, double from, double to, SliderScale scale, QWidget* parent)
    : QWidget(parent),
      m_slider(new QuietSlider(Qt::Horizontal, this)),
      m_field(new NumberField(this)),
      m_from(from),
      m_to(to),
      m_scale(scale) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_slider, 3);
    layout->addWidget(m_field, 2);
    m_field->setRange(range);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    m_slider->setMinimumWidth(48);
    m_slider->setRange(0, range.isWhole ? std::min(kTicks, static_cast<int>(to - from)) : kTicks);
    m_slider->setPageStep(std::max(1, m_slider->maximum() / 10));
    setFocusProxy(m_field);
    connect(m_slider, &QSlider::sliderPressed, this, &SliderField::editingStarted);
    connect(m_slider, &QSlider::sliderReleased, this, [this] { m_steps.end(); });
    connect(m_slider, &QSlider::valueChanged, this, &SliderField::sliderMoved);
    connect(m_field, &NumberField::editingStarted, this, &SliderField::editingStarted);
    connect(m_field, &NumberField::edited, this, [this](double value) {
        showOnSlider();
        emit edited(value);
    });
    showOnSlider();
}

void SliderField::setValue(double value) {
    m_field->setValue(value);
    if (m_slider->isSliderDown() && valueAt(m_slider->value()) == value) return;
    m_slider->setSliderDown(false);  // the value was undone or changed elsewhere during a drag
    showOnSlider();
}

void SliderField::setMixed() {
    m_field->setMixed();
    showOnSlider();
}

void SliderField::setSliderRange(double from, double to) {
    if (m_from == from && m_to == to) return;
    m_from = from;
    m_to = to;
    showOnSlider();
}

void SliderField::setHint(const QString& hint) {
    m_field->setHint(hint);
    m_slider->setToolTip(hint);
    m_slider->setStatusTip(hint);
}

void SliderField::setName(const QString& name) {
    m_field->setAccessibleName(name);
    m_slider->setAccessibleName(tr("%1, slider").arg(name));
}

void SliderField::showOnSlider() {
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(m_field->isMixed() ? m_slider->minimum() : positionOf(m_field->value()));
}

void SliderField::sliderMoved() {
    const double value = valueAt(m_slider->value());
    if (!m_slider->isSliderDown() && m_steps.startsNew()) emit editingStarted();
    if (!m_field->isMixed() && value == m_field->value()) return;
    m_field->setValue(value);
    emit edited(value);
}

double SliderField::valueAt(int position) const {
    const double part = static_cast<double>(position) / m_slider->maximum();
    const double value =
        m_scale == SliderScale::Linear ? m_from + part * (m_to - m_from) : m_from * std::pow(m_to / m_from, part);
    if (m_field->range().isWhole) return std::round(value);
    return QString::number(value, 'g', kSliderDigits).toDouble();
}

int SliderField::positionOf(double value) const {
    const double inside = std::clamp(value, m_from, m_to);
    const double part = m_scale == SliderScale::Linear ? (inside - m_from) / (m_to - m_from)
                                                       : std::log(inside / m_from) / std::log(m_to / m_from);
    return static_cast<int>(std::lround(part * m_slider->maximum()));
}

SliderField* thresholdField() {
    auto* field =
        new SliderField(fieldRange(ProjectNumber::Threshold), kMinThreshold, kMaxThreshold, SliderScale::Logarithmic);
    field->setFormat(Units::impulses());
    return field;
}

}  // namespace rubble

#include "moc_SliderField.cpp"
