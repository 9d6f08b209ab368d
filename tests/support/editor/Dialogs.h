#pragma once

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <functional>

namespace rubble::test {

/// Calls answer(dialog) once the next dialog of this type is shown.
template <class Dialog>
void onNextDialog(std::function<void(Dialog&)> answer) {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, answer] {
        auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        timer->deleteLater();
        timer->stop();
        answer(*dialog);
    });
    timer->start(20);
}

/// Enters a path into a file dialog and presses Open or Save.
inline void acceptFile(QFileDialog& dialog, const QString& path) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    name->setText(path);  // keyClicks() would open the completer, which grabs the mouse
    auto* buttons = dialog.findChild<QDialogButtonBox*>();
    const bool opens = dialog.acceptMode() == QFileDialog::AcceptOpen;
    QTest::mouseClick(buttons->button(opens ? QDialogButtonBox::Open : QDialogButtonBox::Save), Qt::LeftButton);
}

}  // namespace rubble::test
