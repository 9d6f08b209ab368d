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

/// What to do with the next dialog: done once it is there and active.
template <class Dialog>
void whenAsked(std::function<void(Dialog&)> answer) {
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

/// Types a path into a dialog that opens or saves, and does so.
inline void takeFile(QFileDialog& dialog, const QString& path) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    name->setText(path);  // typed, its completer would hold the mouse
    auto* buttons = dialog.findChild<QDialogButtonBox*>();
    const bool opens = dialog.acceptMode() == QFileDialog::AcceptOpen;
    QTest::mouseClick(buttons->button(opens ? QDialogButtonBox::Open : QDialogButtonBox::Save), Qt::LeftButton);
}

}  // namespace rubble::test
