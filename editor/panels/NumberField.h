#pragma once

#include "editor/panels/LocalNumber.h"

#include <QAbstractSpinBox>
#include <QElapsedTimer>

#include <limits>

namespace rubble {

/// What may be typed into a field.
struct FieldRange {
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    bool isMinOut = false;    // min itself is not allowed: "above 0"
    bool isWhole = false;     // no fractions
    double step = 0.0;        // of arrows and wheel; 0: the second digit of the value
    double stepAtZero = 0.1;  // the smallest step there
    bool contains(double value) const;

    static FieldRange aboveZero() { return {.min = 0.0, .isMinOut = true}; }
    static FieldRange zeroOrAbove() { return {.min = 0.0}; }
    static FieldRange zeroToOne() { return {.min = 0.0, .max = 1.0, .step = 0.05}; }
    static FieldRange whole(double min, double max) {
        return {.min = min, .max = max, .isWhole = true, .stepAtZero = 1.0};
    }
};

/// Tells whether a step of an arrow or a wheel belongs to the ones before: a user who keeps stepping wants one step to undo.
class StepRun {
public:
    bool beginsAnother();
    void end() { m_last.invalidate(); }

private:
    QElapsedTimer m_last;
};

/// A number with a unit, typed in the user's locale and held as it is stored: showing a number never rounds it. A long
/// number is shown rounded while the field has no focus, its tooltip holding all digits; with focus all of it is shown.
///
/// What cannot be read or is out of range is refused with a sentence, and the number stays. The wheel turns it only with
/// focus, so that a panel can be scrolled over it.
class NumberField : public QAbstractSpinBox {
    Q_OBJECT
public:
    explicit NumberField(QWidget* parent = nullptr);

    double value() const { return m_value; }
    /// Shows a number; not told by `edited`.
    void setValue(double value);
    /// Takes what was typed; false where that is refused, which leaves the line as it is.
    bool commit();
    /// Shows that there are several numbers.
    void setMixed();
    bool isMixed() const { return m_isMixed; }
    void setFormat(const NumberFormat& format);
    void setRange(const FieldRange& range);
    const FieldRange& range() const { return m_range; }
    /// What the field tells when pointed at; all digits are added where not all are shown.
    void setHint(const QString& hint);

    void stepBy(int steps) override;
    QValidator::State validate(QString& text, int& position) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Edits that follow belong to one stroke.
    void strokeBegan();
    void edited(double value);
    void refused(const QString& sentence);

protected:
    StepEnabled stepEnabled() const override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    void clear() override;

private:
    QSize sizeFor(const QString& number) const;
    void showValue();
    void refuse(const QString& sentence);
    void take(double value);
    QString rangeSentence() const;

    double m_value = 0.0;
    bool m_isMixed = false;
    NumberFormat m_format;
    FieldRange m_range;
    QString m_hint;
    StepRun m_run;
};

}  // namespace rubble
