#pragma once

#include "editor/widgets/NumberField.h"

#include <QSlider>
#include <QWidget>

namespace rubble {

enum class SliderScale { Linear, Logarithmic };

/// A slider beside a number field. The slider covers the common values; any value in the field's range can be typed. A
/// drag of the slider is one undo step.
class SliderField : public QWidget {
    Q_OBJECT
public:
    /// The slider spans `from` to `to`, both above zero for a logarithmic scale.
    SliderField(const FieldRange& range, double from, double to, SliderScale scale = SliderScale::Linear,
                QWidget* parent = nullptr);

    NumberField& field() { return *m_field; }
    QSlider& slider() { return *m_slider; }
    double value() const { return m_field->value(); }
    /// Shows a number without emitting `edited`. Ends a drag that has set a different value.
    void setValue(double value);
    void setMixed();
    void setFormat(const NumberFormat& format) { m_field->setFormat(format); }
    /// Changes what the slider spans.
    void setSliderRange(double from, double to);
    void setHint(const QString& hint);
    void setName(const QString& name);

signals:
    /// The edits that follow merge into one undo step.
    void editingStarted();
    void edited(double value);

private:
    void showOnSlider();
    void sliderMoved();
    double valueAt(int position) const;
    int positionOf(double value) const;

    QSlider* m_slider;
    NumberField* m_field;
    double m_from;
    double m_to;
    SliderScale m_scale;
    StepSequence m_steps;
};

/// A field for thresholds in N·s.
SliderField* thresholdField();

}  // namespace rubble
