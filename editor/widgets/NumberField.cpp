#include "editor/widgets/NumberField.h"

#include "editor/widgets/ColourScheme.h"
#include "editor/widgets/numbers/UnitNames.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QStyleOptionSpinBox>
#include <QToolTip>

#include <cmath>

namespace rubble {

namespace {

constexpr int kShownDigits = 5;                 // significant, without focus
constexpr qint64 kMaxPauseMilliseconds = 3000;  // between steps of one group: clicks with a look at the result
constexpr int kStepDigits = 12;                 // significant, of sums of steps: 0.1 + 0.2 is 0.3

constexpr int kCursorWidth = 6;        // pixels, with the line edit's margins
constexpr double kRefusalFrame = 2.0;  // pixels, as wide as its corners

double roundedTo(int digits, double value) { return QString::number(value, 'g', digits).toDouble(); }

/// One in the value's second significant digit; towards zero, 1.0 steps as 0.9 does.
double adaptiveStep(double value, bool isTowardsZero) {
    const double size = std::abs(value) * (isTowardsZero ? 1.0 - 1e-9 : 1.0 + 1e-9);
    return QString("1e%1").arg(static_cast<int>(std::floor(std::log10(size))) - 1).toDouble();
}

double stepOf(const FieldRange& range, double value, int direction) {
    if (range.step > 0.0) return range.step;
    const double step = value == 0.0 ? range.stepAtZero : adaptiveStep(value, (value > 0.0) == (direction < 0));
    return range.isWhole ? std::max(step, 1.0) : step;
}

/// The frame of a text that is refused.
QColor refusalColour(const QPalette& palette) { return isDark(palette) ? QColor(255, 107, 97) : QColor(196, 30, 20); }

}  // namespace

bool FieldRange::contains(double value) const {
    if (value > 0.0 && value < leastAboveZero) return false;
    return value >= min && value <= max && !(isMinExcluded && value == min) && !(isWhole && value != std::floor(value));
}

bool StepSequence::startsNew() {
    const bool isNew = !m_last.isValid() || m_last.hasExpired(kMaxPauseMilliseconds);
    m_last.start();
    return isNew;
}

NumberField::NumberField(QWidget* parent) : QAbstractSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(false);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    showValue();
}

void NumberField::setValue(double value) {
    const bool isSame = !m_isMixed && m_value == value && std::signbit(m_value) == std::signbit(value);
    if (isSame) return;  // keeps text that is being typed
    m_isMixed = false;
    m_value = value;
    showValue();
}

void NumberField::setMixed() {
    if (m_isMixed) return;
    m_isMixed = true;
    showValue();
}

void NumberField::setFormat(const NumberFormat& format) {
    if (format == m_format) return;
    m_format = format;
    updateGeometry();
    showValue();
}

void NumberField::setRange(const FieldRange& range) { m_range = range; }

void NumberField::setHint(const QString& hint) {
    m_hint = hint;
    setStatusTip(hint);
    if (m_refusal.isEmpty()) showValue();
}

/// Shows the number: exact with focus, rounded without.
void NumberField::showValue() {
    setRefusal({});
    lineEdit()->setPlaceholderText(m_isMixed ? tr("Mixed") : QString());
    const QString exact = exactText(m_value, m_format, locale());
    const QString rounded = significantText(m_value, kShownDigits, m_format, locale());
    const bool isLong = exact.size() > rounded.size();
    const QString& shown = isLong && !hasFocus() ? rounded : exact;
    setToolTip(isLong && !m_isMixed ? m_hint + (m_hint.isEmpty() ? "" : "\n") + withUnit(exact, m_format) : m_hint);
    lineEdit()->setText(m_isMixed ? QString() : withUnit(shown, m_format));
    lineEdit()->setModified(false);
    if (!hasFocus()) lineEdit()->setCursorPosition(0);
}

QString NumberField::rangeSentence() const {
    const auto text = [&](double value) { return withUnit(exactText(value, m_format, locale()), m_format); };
    constexpr double kMost = std::numeric_limits<double>::max();
    if (m_range.isMinExcluded && m_range.max == kMost) return tr("Enter a number above %1.").arg(text(m_range.min));
    if (m_range.isMinExcluded)
        return tr("Enter a number above %1 and at most %2.").arg(text(m_range.min), text(m_range.max));
    if (m_range.leastAboveZero > 0.0)
        return tr("Enter 0, or a number from %1 to %2.").arg(text(m_range.leastAboveZero), text(m_range.max));
    if (m_range.max == kMost) return tr("Enter a number of at least %1.").arg(text(m_range.min));
    if (m_range.isWhole) return tr("Enter a whole number from %1 to %2.").arg(text(m_range.min), text(m_range.max));
    return tr("Enter a number from %1 to %2.").arg(text(m_range.min), text(m_range.max));
}

QString NumberField::refusalOf(const QString& text) const {
    const QString example = locale().toString(12.5);
    if (m_format.unit.isEmpty()) return tr("\"%1\" is not a number. Enter a number such as %2.").arg(text, example);
    const QStringList units = unitNames(m_format.family);
    if (units.isEmpty()) {
        return tr("\"%1\" is not a number with a known unit. Enter a number such as %2.")
            .arg(text, withUnit(example, m_format));
    }
    return tr("\"%1\" is not a number with a unit that this field knows. Enter a number such as %2; units: %3.")
        .arg(text, withUnit(example, m_format), units.join(", "));
}

void NumberField::setRefusal(const QString& sentence) {
    if (sentence == m_refusal) return;
    m_refusal = sentence;
    setAccessibleDescription(sentence);
    if (!sentence.isEmpty()) setToolTip(sentence);
    update();
}

void NumberField::refuseEntered(const QString& sentence) {
    if (!m_typed.isEmpty()) {
        lineEdit()->setText(m_typed);
        lineEdit()->setModified(true);
    }
    showRefusal(sentence);
}

void NumberField::discardTyping() {
    if (lineEdit()->isModified()) showValue();
}

void NumberField::showRefusal(const QString& sentence) {
    setRefusal(sentence);
    QToolTip::showText(mapToGlobal(QPoint(0, height())), sentence, this);
}

void NumberField::refuse(const QString& sentence) {
    showRefusal(sentence);
    emit refused(sentence);
}

bool NumberField::commit() {
    if (!lineEdit()->isModified()) return true;
    const QString text = lineEdit()->text();
    if (m_isMixed && text.trimmed().isEmpty()) return true;
    const std::optional<double> typed = parseNumber(text, m_format, locale());
    if (!typed) {
        refuse(refusalOf(text.trimmed()));
        return false;
    }
    if (!m_range.contains(*typed)) {
        refuse(rangeSentence());
        return false;
    }
    m_steps.end();
    emit editingStarted();
    m_typed = text;
    enter(*typed);
    m_typed.clear();
    return m_refusal.isEmpty();
}

void NumberField::enter(double value) {
    const bool isChanged = m_isMixed || value != m_value;
    m_isMixed = false;
    m_value = value;
    showValue();
    if (isChanged) emit edited(value);
}

void NumberField::stepBy(int steps) {
    if (m_isMixed || !commit()) return;
    const int direction = steps > 0 ? 1 : -1;
    double value = m_value;
    for (int k = 0; k < std::abs(steps); ++k)
        value = roundedTo(kStepDigits, value + direction * stepOf(m_range, value, direction));
    value = std::clamp(value, m_range.min, m_range.max);
    if (value > 0.0 && value < m_range.leastAboveZero) value = direction > 0 ? m_range.leastAboveZero : 0.0;
    if (m_range.isMinExcluded && value <= m_range.min) return;
    if (m_steps.startsNew()) emit editingStarted();
    enter(value);
    lineEdit()->selectAll();
}

QValidator::State NumberField::validate(QString&, int&) const { return QValidator::Acceptable; }

QAbstractSpinBox::StepEnabled NumberField::stepEnabled() const {
    if (isReadOnly() || m_isMixed) return StepNone;
    StepEnabled enabled = StepNone;
    if (m_value < m_range.max) enabled |= StepUpEnabled;
    if (m_value > m_range.min) enabled |= StepDownEnabled;
    return enabled;
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (commit()) {
                showValue();
                event->ignore();  // a dialog accepts
            }
            lineEdit()->selectAll();
            return;
        case Qt::Key_Escape:
            if (!lineEdit()->isModified()) return event->ignore();
            QToolTip::hideText();
            showValue();
            lineEdit()->selectAll();
            return;
        default: QAbstractSpinBox::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event) {
    if (hasFocus()) return QAbstractSpinBox::wheelEvent(event);
    event->ignore();
}

void NumberField::focusInEvent(QFocusEvent* event) {
    QAbstractSpinBox::focusInEvent(event);
    if (lineEdit()->isModified()) return;
    showValue();
    if (event->reason() != Qt::MouseFocusReason) lineEdit()->selectAll();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    const bool isApplied = commit();
    m_steps.end();
    QAbstractSpinBox::focusOutEvent(event);
    if (isApplied) showValue();
}

void NumberField::changeEvent(QEvent* event) {
    QAbstractSpinBox::changeEvent(event);
    if (event->type() == QEvent::LocaleChange) showValue();
}

void NumberField::paintEvent(QPaintEvent* event) {
    QAbstractSpinBox::paintEvent(event);
    if (m_refusal.isEmpty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(refusalColour(palette()), kRefusalFrame));
    const double half = kRefusalFrame / 2.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), kRefusalFrame, kRefusalFrame);
}

void NumberField::clear() { lineEdit()->clear(); }

/// The size of a field with this number, its unit, frame and arrows.
QSize NumberField::sizeFor(const QString& number) const {
    ensurePolished();
    const QSize text(fontMetrics().horizontalAdvance(withUnit(number, m_format)) + kCursorWidth,
                     lineEdit()->sizeHint().height());
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, this);
}

QSize NumberField::sizeHint() const { return sizeFor(QStringLiteral("-000.000")); }
/// As many digits as are shown without focus, of a number below 1.
QSize NumberField::minimumSizeHint() const { return sizeFor(QStringLiteral("0.00000")); }

}  // namespace rubble

#include "moc_NumberField.cpp"
