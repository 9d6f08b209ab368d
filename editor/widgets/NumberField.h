#pragma once

#include "editor/widgets/numbers/NumberText.h"

#include <QAbstractSpinBox>
#include <QElapsedTimer>

#include <limits>

namespace rubble {

/// The values that may be typed into a field.
struct FieldRange {
    double min = -std::numeric_limits<double>::max();
    double max = std::numeric_limits<double>::max();
    bool isMinExcluded = false;   // "above 0"
    bool isWhole = false;         // no fractions
    double step = 0.0;            // of arrows and wheel; 0: one in the value's second digit
    double stepAtZero = 0.1;      // if the value is 0
    double leastAboveZero = 0.0;  // smaller numbers are not allowed, except 0
    bool contains(double value) const;

    static FieldRange aboveZero() { return {.min = 0.0, .isMinExcluded = true}; }
    static FieldRange zeroOrAbove() { return {.min = 0.0}; }
    static FieldRange zeroToOne() { return {.min = 0.0, .max = 1.0, .step = 0.05}; }
    static FieldRange whole(double min, double max) {
        return {.min = min, .max = max, .isWhole = true, .stepAtZero = 1.0};
    }
};

/// Groups steps of arrows and wheel in quick succession, which become one undo step.
class StepSequence {
public:
    /// True if the step begins a new group.
    bool startsNew();
    void end() { m_last.invalidate(); }

private:
    QElapsedTimer m_last;
};

/// A spin box for a number with a unit, typed in the user's locale. It keeps the value exactly: without focus it shows
/// a rounded number and has all digits in its tooltip, with focus it shows all digits.
///
/// Text that is not a number in range, or has a unit of another family, is refused with a message. It stays in the
/// field, which is red and says in its tooltip what is wrong, until it is corrected, discarded with Esc, or another
/// value is shown. The wheel changes the value only with focus, so that the panel scrolls otherwise.
class NumberField : public QAbstractSpinBox {
    Q_OBJECT
public:
    explicit NumberField(QWidget* parent = nullptr);

    double value() const { return m_value; }
    /// Shows a number without emitting `edited`.
    void setValue(double value);
    /// Applies the typed text. Returns false if it is refused, and keeps the text then.
    bool commit();
    /// Shows why the number that was entered last is refused, and keeps it in the field as text. Emits no signal.
    void refuseEntered(const QString& sentence);
    /// What is wrong with the text in the field; empty if nothing is.
    const QString& refusal() const { return m_refusal; }
    /// Shows the value in place of text that was typed.
    void discardTyping();
    /// Shows that the selected values differ.
    void setMixed();
    bool isMixed() const { return m_isMixed; }
    void setFormat(const NumberFormat& format);
    const NumberFormat& format() const { return m_format; }
    void setRange(const FieldRange& range);
    const FieldRange& range() const { return m_range; }
    /// Sets the tooltip and status tip; the tooltip adds all digits of a rounded number.
    void setHint(const QString& hint);

    void stepBy(int steps) override;
    QValidator::State validate(QString& text, int& position) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The edits that follow merge into one undo step.
    void editingStarted();
    void edited(double value);
    void refused(const QString& sentence);

protected:
    StepEnabled stepEnabled() const override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void clear() override;

private:
    QSize sizeFor(const QString& number) const;
    void showValue();
    void setRefusal(const QString& sentence);
    void showRefusal(const QString& sentence);
    void refuse(const QString& sentence);
    void enter(double value);
    QString rangeSentence() const;
    QString refusalOf(const QString& text) const;

    double m_value = 0.0;
    bool m_isMixed = false;
    NumberFormat m_format;
    FieldRange m_range;
    QString m_hint;
    QString m_typed;    // the text that gave the value
    QString m_refusal;  // what is wrong with the text
    StepSequence m_steps;
};

}  // namespace rubble
