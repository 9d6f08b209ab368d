#include "editor/widgets/StateField.h"

#include "editor/document/DocumentFile.h"
#include "editor/document/ShownText.h"

#include <QDir>
#include <QFileInfo>
#include <QSignalBlocker>

namespace rubble {

StateField::StateField(const DocumentFile& file, QWidget* parent) : QComboBox(parent), m_file(file) {
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    fill({});
    connect(this, &QComboBox::activated, this, [this] { emit edited(state()); });
}

void StateField::setState(const QString& name) {
    if (name != state()) fill(name);
}

void StateField::showPopup() {
    fill(state());
    QComboBox::showPopup();
}

void StateField::fill(const QString& selected) {
    QStringList names;
    if (!m_file.path().isEmpty()) {
        names = QFileInfo(m_file.path()).dir().entryList({QStringLiteral("*.rubblestate")}, QDir::Files, QDir::Name);
    }
    const QSignalBlocker blocker(this);
    clear();
    addItem(tr("Scene"), QString());
    for (const QString& name : names) addItem(fileNameText(name), name);
    if (!selected.isEmpty() && !names.contains(selected))
        addItem(tr("%1 (missing)").arg(fileNameText(selected)), selected);
    setCurrentIndex(findData(selected));
}

}  // namespace rubble

#include "moc_StateField.cpp"
