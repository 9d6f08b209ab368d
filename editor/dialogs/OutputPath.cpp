#include "editor/dialogs/OutputPath.h"

#include "core/io/output/FileUse.h"
#include "core/io/system/FileName.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/document/DocumentFile.h"
#include "editor/document/FilePath.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVariant>

#include <utility>
#include <vector>

namespace rubble {

namespace {

struct OutputPathTexts {
    Q_DECLARE_TR_FUNCTIONS(OutputPath)
};

constexpr int kMinDialogWidth = 480;  // pixels, so that a path fits

}  // namespace

OutputDefaults outputDefaults(const DocumentFile& file, QStandardPaths::StandardLocation folder) {
    if (file.path().isEmpty()) return {file.name(), QStandardPaths::writableLocation(folder)};
    const QFileInfo info(file.path());
    return {info.completeBaseName(), info.absolutePath()};
}

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

void suggestOutput(QFileDialog& dialog, const DocumentFile& file, const QString& suffix) {
    const auto [name, folder] = outputDefaults(file, QStandardPaths::DocumentsLocation);
    dialog.setDirectory(folder);
    dialog.selectFile(QFileInfo(unusedPath(folder, name, suffix)).fileName());
}

QString outputFault(const QString& path, const QString& project, const QStringList& suffixes) {
    FileUse written{.path = toPath(path), .role = FileRole::Written, .name = OutputPathTexts::tr("File").toStdString()};
    for (const QString& suffix : suffixes) written.extensions.push_back(suffix.toStdString());
    std::vector<FileUse> uses{std::move(written)};
    if (!project.isEmpty()) uses.push_back({.path = toPath(project), .role = FileRole::Read, .what = "the project"});
    const Status free = checkFileUses(uses);
    return free ? QString() : QString::fromStdString(free.error().message);
}

QString askForOutput(QFileDialog& dialog, const DocumentFile& file, const QStringList& suffixes) {
    if (dialog.exec() != QDialog::Accepted) return {};
    const QString path = dialog.selectedFiles().first();
    const QString fault = outputFault(path, file.path(), suffixes);
    if (fault.isEmpty()) return path;
    showError(dialog.parentWidget(), fault);
    return {};
}

QString unusedPathIn(const QVariant& setting, const QString& folder, const QString& name, const QString& suffix) {
    const QString stored = pathOf(setting);
    const bool exists = is_directory(statusOf(stored));
    return QDir::toNativeSeparators(unusedPath(exists ? stored : folder, name, suffix));
}

void offerKinds(QFileDialog& dialog, const QList<FileKind>& kinds) {
    QStringList filters;
    for (const FileKind& kind : kinds) filters.append(kind.filter);
    dialog.setNameFilters(filters);
    dialog.setDefaultSuffix(kinds.front().suffix);
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog, kinds](const QString& filter) {
        for (const FileKind& kind : kinds) {
            if (kind.filter == filter) dialog.setDefaultSuffix(kind.suffix);
        }
        const QString name = QFileInfo(dialog.selectedFiles().value(0)).completeBaseName();
        if (!name.isEmpty()) dialog.selectFile(name + '.' + dialog.defaultSuffix());
    });
}

QLabel* buddyLabel(const QString& text, QWidget* buddy) {
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    return label;
}

QLabel* addSummary(QFormLayout& form, const QString& objectName) {
    auto* summary = new QLabel;
    summary->setObjectName(objectName);
    summary->setWordWrap(true);
    summary->setTextFormat(Qt::PlainText);
    form.addRow(summary);
    return summary;
}

QPushButton* addOutputButtons(QDialog& dialog, QFormLayout& form, const QString& accept) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* button = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form.addRow(buttons);
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in a field, so that its text can be refused
    button->setDefault(true);              // after the button was added to the dialog
    return button;
}

/// The height is that of texts that wrap at this width; at the hint's, which may be smaller, they have more lines.
void fitPath(QDialog& dialog) {
    const QSize hint = dialog.sizeHint().expandedTo({kMinDialogWidth, 0});
    const int height = dialog.layout()->totalHeightForWidth(hint.width());
    dialog.resize(hint.width(), height > 0 ? height : hint.height());
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
