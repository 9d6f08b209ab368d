#include "editor/dialogs/OutputPath.h"

#include "core/io/system/FileName.h"
#include "editor/document/FilePath.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include <utility>

namespace rubble {

namespace {

struct OutputPathTexts {
    Q_DECLARE_TR_FUNCTIONS(OutputPath)
};

}  // namespace

QString unusedPath(const QString& folder, const QString& name, const QString& suffix) {
    const std::string ending = std::string(" 99") + suffix.toStdString();
    const QString longest = fromPath(fittingFileName("", toPath(name).native(), ending));
    const QString base = folder + '/' + longest.chopped(static_cast<qsizetype>(ending.size()));
    QString path = base;
    for (int k = 2; exists(statusOf(path)) || exists(statusOf(path + suffix)); ++k) {
        path = QString("%1 %2").arg(base).arg(k);
    }
    return path + suffix;
}

QHBoxLayout* createPathRow(QLineEdit& path, std::function<void()> browse) {
    auto* button = new QPushButton(OutputPathTexts::tr("Browse…"));
    QObject::connect(button, &QPushButton::clicked, &path, std::move(browse));
    auto* row = new QHBoxLayout;
    row->addWidget(&path, 1);
    row->addWidget(button);
    return row;
}

}  // namespace rubble
