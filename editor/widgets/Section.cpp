#include "editor/widgets/Section.h"

#include "editor/widgets/ColourButton.h"
#include "editor/widgets/ElidedLabel.h"
#include "editor/widgets/SliderField.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr int kMinLabelCharacters = 13;  // aligns the controls of all sections

/// Ignores the wheel over combo boxes without focus, so that the panel scrolls.
class WheelGuard : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

/// A scroll bar that keeps its place, but is not painted where there is nothing to scroll.
class QuietScrollBar : public QScrollBar {
public:
    using QScrollBar::QScrollBar;

protected:
    void paintEvent(QPaintEvent* event) override {
        if (minimum() < maximum()) QScrollBar::paintEvent(event);
    }
};

}  // namespace

Section::Section(const QString& name, const QString& title, QWidget* parent)
    : QWidget(parent), m_head(new QToolButton(this)), m_body(new QWidget(this)), m_rows(new QGridLayout(m_body)) {
    setObjectName(name);
    setTitle(title);
    m_head->setVisible(!title.isEmpty());
    m_head->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_head->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_head->setFocusPolicy(Qt::TabFocus);
    m_head->setCheckable(true);
    m_head->setAutoRaise(true);
    QFont bold = m_head->font();
    bold.setBold(true);
    m_head->setFont(bold);

    m_rows->setContentsMargins(title.isEmpty() ? QMargins() : QMargins(8, 4, 8, 10));
    m_rows->setVerticalSpacing(6);
    m_rows->setHorizontalSpacing(10);
    m_rows->setColumnStretch(1, 1);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_head);
    layout->addWidget(m_body);
    connect(m_head, &QToolButton::toggled, this, [this](bool isOpen) { setCollapsed(!isOpen); });
    m_head->setChecked(true);
}

void Section::setTitle(const QString& title) {
    m_head->setText(title);
    m_head->setToolTip(tr("Collapse or expand %1").arg(title));
    m_head->setAccessibleName(title);
}

QLabel* Section::addNote(const QString& text) {
    constexpr double kNoteScale = 0.9;  // of the font
    auto* note = new QLabel(text);
    note->setTextFormat(Qt::PlainText);
    note->setWordWrap(true);
    QFont small = note->font();
    small.setPointSizeF(small.pointSizeF() * kNoteScale);
    note->setFont(small);
    addWide(note);
    return note;
}

void Section::setCollapsed(bool isCollapsed) {
    m_head->setChecked(!isCollapsed);
    m_head->setArrowType(isCollapsed ? Qt::RightArrow : Qt::DownArrow);
    m_body->setVisible(!isCollapsed);
}

void Section::setRowVisible(QWidget* control, bool isVisible) {
    control->setVisible(isVisible);
    if (QLabel* label = m_labels.value(control)) label->setVisible(isVisible);
}

void Section::setRowLabel(QWidget* control, const QString& label) {
    if (QLabel* text = m_labels.value(control)) text->setText(label);
    control->setAccessibleName(label);
}

/// The label of a tall control is beside its top.
void Section::addLabelled(const QString& label, QWidget* control) {
    auto* text = new ElidedLabel(label);
    text->setBuddy(control);
    const bool isTall = control->sizeHint().height() > 2 * text->sizeHint().height();
    m_rows->addWidget(text, m_rowCount, 0, Qt::AlignLeft | (isTall ? Qt::AlignTop : Qt::AlignVCenter));
    m_rows->addWidget(control, m_rowCount++, 1);
    m_labels.insert(control, text);
}

void Section::nameRow(const QString& label, QWidget* control, const QString& hint) {
    QLabel* text = m_labels.value(control);
    text->setToolTip(hint);
    text->setMinimumWidth(fontMetrics().averageCharWidth() * kMinLabelCharacters);
    control->setAccessibleName(label);
    if (auto* number = qobject_cast<NumberField*>(control)) return number->setHint(hint);
    if (auto* slider = qobject_cast<SliderField*>(control)) {
        slider->setName(label);
        return slider->setHint(hint);
    }
    if (qobject_cast<QComboBox*>(control)) {
        control->setFocusPolicy(Qt::StrongFocus);
        control->installEventFilter(new WheelGuard(control));
    }
    QWidget* focused = control->focusProxy() ? control->focusProxy() : control;
    focused->setAccessibleName(label);
    for (QWidget* widget : {control, focused}) {
        widget->setToolTip(hint);
        widget->setStatusTip(hint);
    }
}

QScrollArea* verticalScrollArea(QWidget* page) {
    auto* area = new QScrollArea;
    area->setWidget(page);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setVerticalScrollBar(new QuietScrollBar(Qt::Vertical));
    area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    area->setFocusPolicy(Qt::NoFocus);
    return area;
}

}  // namespace rubble

#include "moc_Section.cpp"
