#include "editor/panels/RandomSeedField.h"

#include "editor/panels/Icons.h"

#include <QHBoxLayout>
#include <QRandomGenerator>
#include <QToolTip>

namespace rubble {

namespace {

constexpr int kSeedsOfDice = 1'000'000;  // few digits, to be told and typed again

}  // namespace

RandomSeedField::RandomSeedField(QWidget* parent)
    : QWidget(parent),
      m_line(new QLineEdit(this)),
      m_dice(panelButton("dice", tr("Throw"), tr("Throw the dice: scatter with another random seed"), this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_line);
    layout->addWidget(m_dice);
    setFocusProxy(m_line);
    connect(m_line, &QLineEdit::editingFinished, this, &RandomSeedField::commit);
    connect(m_dice, &QToolButton::clicked, this,
            [this] { take(static_cast<quint64>(QRandomGenerator::global()->bounded(kSeedsOfDice))); });
    setValue(0);
}

void RandomSeedField::setValue(quint64 value) {
    m_value = value;
    m_line->setPlaceholderText({});
    m_line->setText(QString::number(value));
    m_line->setModified(false);
}

void RandomSeedField::setMixed() {
    m_line->clear();
    m_line->setPlaceholderText(tr("several"));
}

void RandomSeedField::commit() {
    if (!m_line->isModified()) return;
    bool isSeed = false;
    const quint64 typed = m_line->text().trimmed().toULongLong(&isSeed);
    if (isSeed) return take(typed);
    const QString sentence = tr("A random seed is a whole number from 0 to %1.").arg(~quint64{0});
    setValue(m_value);
    QToolTip::showText(m_line->mapToGlobal(QPoint(0, m_line->height())), sentence, m_line);
    emit refused(sentence);
}

void RandomSeedField::take(quint64 value) {
    const bool isAnother = value != m_value;
    setValue(value);
    if (isAnother) emit edited(value);
}

}  // namespace rubble
