#include "editor/widgets/RandomSeedField.h"

#include "editor/widgets/Buttons.h"
#include "editor/widgets/Icon.h"

#include <QAction>
#include <QHBoxLayout>
#include <QRandomGenerator>
#include <QToolTip>

namespace rubble {

namespace {

constexpr int kRandomSeeds = 1'000'000;  // few digits, easy to tell and type

}  // namespace

RandomSeedField::RandomSeedField(QWidget* parent)
    : QWidget(parent),
      m_line(new QLineEdit(this)),
      m_refusal(m_line->addAction(iconNamed("message-error"), QLineEdit::TrailingPosition)),
      m_randomize(panelButton("dice", tr("Randomize"), tr("Randomize the seed"), this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_line);
    layout->addWidget(m_randomize);
    setFocusProxy(m_line);
    connect(m_line, &QLineEdit::editingFinished, this, &RandomSeedField::commit);
    connect(m_randomize, &QToolButton::clicked, this,
            [this] { enter(static_cast<quint64>(QRandomGenerator::global()->bounded(kRandomSeeds))); });
    showValue();
}

void RandomSeedField::setValue(quint64 value) {
    if (value == m_value && !m_isMixed) return;  // keeps text that is being typed
    m_isMixed = false;
    m_value = value;
    showValue();
}

void RandomSeedField::setMixed() {
    if (m_isMixed) return;
    m_isMixed = true;
    showValue();
}

void RandomSeedField::showValue() {
    setRefusal({});
    m_line->setPlaceholderText(m_isMixed ? tr("Mixed") : QString());
    m_line->setText(m_isMixed ? QString() : QString::number(m_value));
    m_line->setModified(false);
}

void RandomSeedField::setRefusal(const QString& sentence) {
    m_refusal->setVisible(!sentence.isEmpty());
    m_refusal->setToolTip(sentence);
    m_line->setAccessibleDescription(sentence);
}

void RandomSeedField::discardTyping() {
    if (m_line->isModified()) showValue();
}

bool RandomSeedField::commit() {
    if (!m_line->isModified()) return true;
    bool isSeed = false;
    const quint64 typed = m_line->text().trimmed().toULongLong(&isSeed);
    if (isSeed) {
        enter(typed);
        return true;
    }
    const QString sentence = tr("Enter a whole number from 0 to %1 as the random seed.").arg(~quint64{0});
    setRefusal(sentence);
    QToolTip::showText(m_line->mapToGlobal(QPoint(0, m_line->height())), sentence, m_line);
    emit refused(sentence);
    return false;
}

void RandomSeedField::enter(quint64 value) {
    const bool isChanged = m_isMixed || value != m_value;
    m_isMixed = false;
    m_value = value;
    showValue();
    if (isChanged) emit edited(value);
}

}  // namespace rubble

#include "moc_RandomSeedField.cpp"
