#include "editor/widgets/RandomSeedField.h"

#include "editor/widgets/Buttons.h"

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
      m_randomize(panelButton("dice", tr("Randomize"), tr("Randomize the seed"), this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_line);
    layout->addWidget(m_randomize);
    setFocusProxy(m_line);
    connect(m_line, &QLineEdit::editingFinished, this, &RandomSeedField::commit);
    connect(m_randomize, &QToolButton::clicked, this,
            [this] { enter(static_cast<quint64>(QRandomGenerator::global()->bounded(kRandomSeeds))); });
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
    m_line->setPlaceholderText(tr("Mixed"));
}

void RandomSeedField::commit() {
    if (!m_line->isModified()) return;
    bool isSeed = false;
    const quint64 typed = m_line->text().trimmed().toULongLong(&isSeed);
    if (isSeed) return enter(typed);
    const QString sentence = tr("Enter a whole number from 0 to %1 as the random seed.").arg(~quint64{0});
    setValue(m_value);
    QToolTip::showText(m_line->mapToGlobal(QPoint(0, m_line->height())), sentence, m_line);
    emit refused(sentence);
}

void RandomSeedField::enter(quint64 value) {
    const bool isChanged = value != m_value;
    setValue(value);
    if (isChanged) emit edited(value);
}

}  // namespace rubble

#include "moc_RandomSeedField.cpp"
